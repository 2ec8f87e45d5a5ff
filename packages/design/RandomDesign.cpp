#include <harmos/design/RandomDesign.hpp>

#include <harmos/design/detail/RandomNumbers.hpp>

namespace harmos::design {

std::vector<std::vector<double>> RandomDesign::points(const std::vector<Axis>& axes) const {
  RandomNumbers random(seed_);
  std::vector<std::vector<double>> points(count_);
  for (auto& point : points) {
    for (const Axis& axis : axes) point.push_back(axis.at(random.fraction()));
  }
  return points;
}

}  // namespace harmos::design
