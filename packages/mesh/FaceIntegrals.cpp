#include <harmos/mesh/FaceIntegrals.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/ReferenceElement.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {
namespace {

struct QuadraturePoint {
  std::array<double, 9> shape, alongFirst, alongSecond;  // N and its derivatives
  double weight;
};

std::vector<QuadraturePoint> lineRule() {
  std::vector<QuadraturePoint> rule;
  for (const double x : {-1.0 / std::sqrt(3.0), 1.0 / std::sqrt(3.0)}) {
    rule.push_back({{0.5 * (1.0 - x), 0.5 * (1.0 + x)}, {-0.5, 0.5}, {}, 1.0});
  }
  return rule;
}

std::vector<QuadraturePoint> triangleRule() {
  std::vector<QuadraturePoint> rule;
  for (const auto& [x, y] : {std::pair(0.5, 0.0), std::pair(0.5, 0.5), std::pair(0.0, 0.5)}) {
    rule.push_back({{1.0 - x - y, x, y}, {-1.0, 1.0, 0.0}, {-1.0, 0.0, 1.0}, 1.0 / 6.0});
  }
  return rule;
}

std::vector<QuadraturePoint> quadrilateralRule() {
  std::vector<QuadraturePoint> rule;
  const double g = 1.0 / std::sqrt(3.0);
  for (const double x : {-g, g}) {
    for (const double y : {-g, g}) {
      const double a = 0.5 * (1.0 - x), b = 0.5 * (1.0 + x), c = 0.5 * (1.0 - y), d = 0.5 * (1.0 + y);
      rule.push_back({{a * c, b * c, b * d, a * d},
                      {-0.5 * c, 0.5 * c, 0.5 * d, -0.5 * d},
                      {-0.5 * a, -0.5 * b, 0.5 * b, 0.5 * a},
                      1.0});
    }
  }
  return rule;
}

std::vector<QuadraturePoint> quadraticLineRule() {
  std::vector<QuadraturePoint> rule;
  const double g = std::sqrt(0.6);
  for (const auto& [x, weight] : {std::pair(-g, 5.0 / 9.0), std::pair(0.0, 8.0 / 9.0), std::pair(g, 5.0 / 9.0)}) {
    rule.push_back({{0.5 * x * (x - 1.0), 0.5 * x * (x + 1.0), 1.0 - x * x}, {x - 0.5, x + 0.5, -2.0 * x}, {}, weight});
  }
  return rule;
}

std::vector<QuadraturePoint> quadraticRule(ElementType type) {
  const ReferenceElement reference = referenceElement(type);
  std::vector<QuadraturePoint> rule(reference.points);
  for (int p = 0; p < reference.points; ++p) {
    rule[p].weight = reference.weight[p];
    for (int a = 0; a < reference.nodes; ++a) {
      const int at = p * reference.nodes + a;
      rule[p].shape[a] = reference.value[at];
      rule[p].alongFirst[a] = reference.gradient[2 * at];
      rule[p].alongSecond[a] = reference.gradient[2 * at + 1];
    }
  }
  return rule;
}

const std::vector<QuadraturePoint>& rule(int dimension, std::size_t nodes) {
  static const std::map<std::pair<int, std::size_t>, std::vector<QuadraturePoint>> rules = {
      {{2, 2}, lineRule()},
      {{2, 3}, quadraticLineRule()},
      {{3, 3}, triangleRule()},
      {{3, 4}, quadrilateralRule()},
      {{3, 6}, quadraticRule(ElementType::tri6)},
      {{3, 8}, quadraticRule(ElementType::quad8)},
      {{3, 9}, quadraticRule(ElementType::quad9)}};
  return rules.at({dimension, nodes});
}

/// Positive areas and normals from the diagonal of the mass and normals with the same weights.
void lump(FaceIntegrals& face, const std::vector<base::Vector3>& squares) {
  double diagonal = 0.0, total = 0.0;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    diagonal += face.mass[i][i];
    total += face.weight[i].share;
  }
  if (!(diagonal > 0.0)) return;  // a face on the axis, which has no area
  for (std::size_t i = 0; i < squares.size(); ++i) {
    face.weight[i].area = total / diagonal * face.mass[i][i];
    face.weight[i].normal = total / diagonal * squares[i];
  }
}

/// Around a node on the axis forces along the radius cancel, and it does not move there.
void removeRadialFlux(FaceIntegrals& face, const std::vector<base::Vector3>& nodes) {
  double largest = 0.0;
  for (const base::Vector3& x : nodes) largest = std::max(largest, std::abs(x[0]));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (std::abs(nodes[i][0]) <= Depth::onAxis * largest) face.weight[i].flux[0] = 0.0;
  }
}

}  // namespace

FaceIntegrals integrateFace(int dimension, const std::vector<base::Vector3>& nodes, const Depth& depth,
                            const std::optional<base::Vector3>& projection) {
  const std::size_t n = nodes.size();
  FaceIntegrals result{std::vector<NodalWeight>(n), {n, std::vector<double>(n)}};
  std::vector<base::Vector3> squares(n);  // int N_i^2 n dS
  for (const QuadraturePoint& at : rule(dimension, n)) {
    base::Vector3 first{}, second{}, place{};
    for (std::size_t i = 0; i < n; ++i) {
      place = place + at.shape[i] * nodes[i];
      first = first + at.alongFirst[i] * nodes[i];
      second = second + at.alongSecond[i] * nodes[i];
    }
    if (dimension == 2) second = {0.0, 0.0, depth.at(place)};
    const base::Vector3 normal = at.weight * cross(first, second);
    const double area = projection ? std::abs(dot(normal, *projection)) : norm(normal);
    for (std::size_t i = 0; i < n; ++i) {
      NodalWeight& weight = result.weight[i];
      weight.share += at.shape[i] * area;
      weight.flux = weight.flux + at.shape[i] * normal;
      squares[i] = squares[i] + at.shape[i] * at.shape[i] * normal;
      for (std::size_t j = 0; j < n; ++j) result.mass[i][j] += at.shape[i] * at.shape[j] * area;
    }
  }
  if (static_cast<int>(n) > cornersOfFace(dimension, n)) {
    lump(result, squares);
  } else {
    for (NodalWeight& weight : result.weight) {
      weight.area = weight.share;
      weight.normal = weight.flux;
    }
  }
  if (dimension == 2 && depth.isRevolved()) removeRadialFlux(result, nodes);
  return result;
}

}  // namespace harmos::mesh
