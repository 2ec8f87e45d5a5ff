#include <harmos/scene/SolveSeconds.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/latin/StepsAtOnce.hpp>

namespace harmos::scene {

double SolveSeconds::seconds(double columns) const {
  return std::min(columns * alone, std::ceil(columns / latin::stepsAtOnce) * first + columns * further);
}

}  // namespace harmos::scene
