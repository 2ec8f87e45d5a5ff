#include <harmos/design/LatinHypercubeDesign.hpp>

#include <harmos/design/detail/RandomNumbers.hpp>

namespace harmos::design {

std::vector<std::vector<double>> LatinHypercubeDesign::points(const std::vector<Axis>& axes) const {
  RandomNumbers random(seed_);
  std::vector<std::vector<double>> points(count_);
  for (const Axis& axis : axes) {
    const std::vector<int> strata = random.permutation(count_);
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i].push_back(axis.at((strata[i] + random.fraction()) / count_));
    }
  }
  return points;
}

}  // namespace harmos::design
