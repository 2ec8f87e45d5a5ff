#include <harmos/mortar/detail/FaceShape.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace harmos::mortar {
namespace {

/// Lagrange functions of a line and their derivatives: the nodes -1 and 1, then 0.
struct Line {
  Line(double x, bool isQuadratic) {
    if (isQuadratic) {
      value = {0.5 * x * (x - 1.0), 0.5 * x * (x + 1.0), 1.0 - x * x};
      slope = {x - 0.5, x + 0.5, -2.0 * x};
    } else {
      value = {0.5 * (1.0 - x), 0.5 * (1.0 + x), 0.0};
      slope = {-0.5, 0.5, 0.0};
    }
  }
  std::array<double, 3> value{}, slope{};
};

/// Which functions of the two lines make those of a square.
constexpr int along[9] = {0, 1, 1, 0, 2, 1, 2, 0, 2};
constexpr int across[9] = {0, 0, 1, 1, 0, 2, 1, 2, 2};
constexpr int centre = 8;

std::vector<Parent> placesOf(int corners) {
  if (corners == 2) return {{-1.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}};
  if (corners == 3) return {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.5, 0.0}, {0.5, 0.5}, {0.0, 0.5}};
  return {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0},  {-1.0, 1.0}, {0.0, -1.0},
          {1.0, 0.0},   {0.0, 1.0},  {-1.0, 0.0}, {0.0, 0.0}};
}

/// Polygons between the places of a shape, by the numbers of these.
std::vector<std::vector<Parent>> polygons(int corners, const std::vector<std::vector<int>>& numbers) {
  const auto places = placesOf(corners);
  std::vector<std::vector<Parent>> result;
  for (const auto& polygon : numbers) {
    result.emplace_back();
    for (const int number : polygon) result.back().push_back(places[number]);
  }
  return result;
}

}  // namespace

FaceShape::FaceShape(int nodes, int corners, int degree, std::vector<std::vector<Parent>> parts)
    : nodes_(nodes), corners_(corners), degree_(degree), places_(placesOf(corners)), parts_(std::move(parts)) {
  places_.resize(nodes);
}

const FaceShape& FaceShape::of(int dimension, std::size_t nodes) {
  const std::vector<std::vector<int>> quarters = {{0, 4, 8, 7}, {4, 1, 5, 8}, {8, 5, 2, 6}, {7, 8, 6, 3}};
  static const std::map<std::pair<int, std::size_t>, FaceShape> shapes = {
      {{2, 2}, FaceShape(2, 2, 1, polygons(2, {{0, 1}}))},
      {{2, 3}, FaceShape(3, 2, 2, polygons(2, {{0, 2}, {2, 1}}))},
      {{3, 3}, FaceShape(3, 3, 1, polygons(3, {{0, 1, 2}}))},
      {{3, 6}, FaceShape(6, 3, 2, polygons(3, {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}))},
      {{3, 4}, FaceShape(4, 4, 2, polygons(4, {{0, 1, 2, 3}}))},
      {{3, 8}, FaceShape(8, 4, 3, polygons(4, quarters))},
      {{3, 9}, FaceShape(9, 4, 4, polygons(4, quarters))}};
  return shapes.at({dimension, nodes});
}

FaceShape::Values FaceShape::values(const Parent& at) const {
  if (!isQuadratic()) {
    const auto linear = cornerValues(at);
    Values values{};
    std::copy(linear.begin(), linear.end(), values.begin());
    return values;
  }
  Values values{};
  Gradients gradients;
  evaluate(at, values, gradients);
  return values;
}

void FaceShape::evaluate(const Parent& at, Values& values, Gradients& gradients) const {
  if (corners_ == 3) return triangle(at, values, gradients);
  if (corners_ == 4) return square(at, values, gradients);
  const Line line(at[0], isQuadratic());
  for (int j = 0; j < nodes_; ++j) {
    values[j] = line.value[j];
    gradients[j] = {line.slope[j], 0.0};
  }
}

void FaceShape::triangle(const Parent& at, Values& values, Gradients& gradients) const {
  const std::array<double, 3> area = {1.0 - at[0] - at[1], at[0], at[1]};
  constexpr double slope[3][2] = {{-1.0, -1.0}, {1.0, 0.0}, {0.0, 1.0}};
  for (int j = 0; j < 3; ++j) {
    const double factor = isQuadratic() ? 4.0 * area[j] - 1.0 : 1.0;
    values[j] = isQuadratic() ? area[j] * (2.0 * area[j] - 1.0) : area[j];
    gradients[j] = {factor * slope[j][0], factor * slope[j][1]};
  }
  for (int j = 3; j < nodes_; ++j) {
    const int a = j - 3, b = (j - 2) % 3;
    values[j] = 4.0 * area[a] * area[b];
    for (int d = 0; d < 2; ++d) gradients[j][d] = 4.0 * (area[a] * slope[b][d] + area[b] * slope[a][d]);
  }
}

void FaceShape::square(const Parent& at, Values& values, Gradients& gradients) const {
  const Line x(at[0], isQuadratic()), y(at[1], isQuadratic());
  const int count = isQuadratic() ? FaceShape::mostNodes : corners_;
  for (int j = 0; j < count; ++j) {
    values[j] = x.value[along[j]] * y.value[across[j]];
    gradients[j] = {x.slope[along[j]] * y.value[across[j]], x.value[along[j]] * y.slope[across[j]]};
  }
  if (nodes_ != centre) return;
  // Without the node in the centre its function goes to the others so that quadratic polynomials are kept.
  for (int j = 0; j < nodes_; ++j) {
    const double share = j < corners_ ? -0.25 : 0.5;
    values[j] += share * values[centre];
    for (int d = 0; d < 2; ++d) gradients[j][d] += share * gradients[centre][d];
  }
}

}  // namespace harmos::mortar
