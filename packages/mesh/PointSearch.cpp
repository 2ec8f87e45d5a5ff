#include <harmos/mesh/PointSearch.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

#include <harmos/base/Vector3.hpp>

namespace harmos::mesh {

PointSearch::PointSearch(std::vector<base::Vector3> points)
    : points_(std::move(points)), order_(points_.size()), axis_(points_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  build(0, order_.size());
  std::vector<base::Vector3> ordered;  // as searches meet them
  ordered.reserve(points_.size());
  for (const int index : order_) ordered.push_back(points_[index]);
  points_.swap(ordered);
}

void PointSearch::build(std::size_t begin, std::size_t end) {
  if (begin == end) return;
  const auto at = [this](int index) -> const base::Vector3& { return points_[index]; };
  base::Vector3 low = at(order_[begin]);
  base::Vector3 high = low;
  for (std::size_t i = begin; i < end; ++i) {
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], at(order_[i])[d]);
      high[d] = std::max(high[d], at(order_[i])[d]);
    }
  }
  const base::Vector3 extent = high - low;
  const auto axis = static_cast<std::size_t>(std::max_element(extent.begin(), extent.end()) - extent.begin());
  const std::size_t middle = begin + (end - begin) / 2;
  const auto position = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(position(begin), position(middle), position(end),
                   [&](int a, int b) { return at(a)[axis] < at(b)[axis]; });
  axis_[middle] = static_cast<int>(axis);
  build(begin, middle);
  build(middle + 1, end);
}

template <typename Visit>
void PointSearch::visit(const base::Vector3& point, std::size_t begin, std::size_t end, double& radius,
                        const Visit& found) const {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const base::Vector3& here = points_[middle];
  const double away = distance(point, here);
  if (away <= radius) found(order_[middle], away);
  const auto axis = static_cast<std::size_t>(axis_[middle]);
  const double offset = point[axis] - here[axis];
  const bool below = offset < 0.0;
  visit(point, below ? begin : middle + 1, below ? middle : end, radius, found);
  if (std::abs(offset) <= radius) visit(point, below ? middle + 1 : begin, below ? end : middle, radius, found);
}

PointSearch::Nearest PointSearch::nearest(const base::Vector3& point) const {
  Nearest result;
  double radius = std::numeric_limits<double>::infinity();
  visit(point, 0, order_.size(), radius, [&](int index, double away) {
    if (result.index < 0 || away < result.distance || index < result.index) result = {index, away};
    radius = result.distance;
  });
  return result;
}

std::vector<int> PointSearch::within(const base::Vector3& point, double radius) const {
  std::vector<int> result;
  visit(point, 0, order_.size(), radius, [&](int index, double) { result.push_back(index); });
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace harmos::mesh
