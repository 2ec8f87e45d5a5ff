#include <harmos/mesh/FaceIntegrals.hpp>

#include <array>
#include <cmath>

#include <harmos/base/Vector3.hpp>

namespace harmos::mesh {
namespace {

struct QuadraturePoint {
  std::array<double, 4> shape, alongFirst, alongSecond;  // N and its derivatives
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

const std::vector<QuadraturePoint>& rule(std::size_t corners) {
  static const std::array<std::vector<QuadraturePoint>, 3> rules = {lineRule(), triangleRule(), quadrilateralRule()};
  return rules[corners - 2];
}

}  // namespace

FaceIntegrals integrateFace(const std::vector<base::Vector3>& corners, double thickness,
                            const std::optional<base::Vector3>& projection) {
  const std::size_t n = corners.size();
  FaceIntegrals result{std::vector<double>(n), std::vector<base::Vector3>(n), {n, std::vector<double>(n)}};
  for (const QuadraturePoint& at : rule(n)) {
    base::Vector3 first{}, second{};
    for (std::size_t i = 0; i < n; ++i) {
      first = first + at.alongFirst[i] * corners[i];
      second = second + at.alongSecond[i] * corners[i];
    }
    if (n == 2) second = {0.0, 0.0, thickness};
    const base::Vector3 normal = at.weight * cross(first, second);
    const double area = projection ? std::abs(dot(normal, *projection)) : norm(normal);
    for (std::size_t i = 0; i < n; ++i) {
      result.area[i] += at.shape[i] * area;
      result.normal[i] = result.normal[i] + at.shape[i] * normal;
      for (std::size_t j = 0; j < n; ++j) result.mass[i][j] += at.shape[i] * at.shape[j] * area;
    }
  }
  return result;
}

}  // namespace harmos::mesh
