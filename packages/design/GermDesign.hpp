#pragma once

#include <vector>

#include <harmos/design/Design.hpp>
#include <harmos/probability/RandomVector.hpp>

namespace harmos::design {

/// The points of a design in the unit cube as germs of random parameters: each coordinate is taken for a probability.
///
/// A coordinate of 0 may have no finite quantile: it is raised to 0.5 / count, `count` being the number of points.
/// Returns one row per point, one column per germ of `variables` [-].
std::vector<std::vector<double>> germsOf(const Design& design, int count, const probability::RandomVector& variables);

}  // namespace harmos::design
