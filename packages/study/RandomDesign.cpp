#include <harmos/study/RandomDesign.hpp>

#include <harmos/study/RandomNumbers.hpp>

namespace harmos::study {

std::vector<std::vector<double>> RandomDesign::points(const std::vector<Axis>& axes) const {
  RandomNumbers random(seed_);
  std::vector<std::vector<double>> points(static_cast<std::size_t>(count_));
  for (auto& point : points) {
    for (const Axis& axis : axes) point.push_back(axis.at(random.fraction()));
  }
  return points;
}

}  // namespace harmos::study
