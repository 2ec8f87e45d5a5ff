#pragma once

#include <vector>

#include <harmos/chaos/RandomVector.hpp>
#include <harmos/study/Design.hpp>

namespace harmos::study {

/// The points of a design in the unit cube as germs of random parameters: each coordinate is taken for a probability.
///
/// A coordinate of 0, which a Sobol' sequence begins with, has no finite quantile: it is raised to 0.5 / count. Returns
/// one row per point.
std::vector<std::vector<double>> germsOf(const Design& design, int count, const chaos::RandomVector& variables);

}  // namespace harmos::study
