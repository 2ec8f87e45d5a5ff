#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>

namespace harmos::latin {

/// The column of a load step from the two before it, linear in time; the first two are those before them, or zero.
/// `alpha` [stress]: one column per load step. `times` of them. `state`: gets a column with the rows of alpha.
void extrapolate(const base::Matrix& alpha, int step, const std::vector<double>& times, double* state);

/// How many times as far the state of a path is expected to go in a load step as in the one before. `values`: what is
/// controlled, at every load step; it was 0 at the unloaded start. 0: nothing is known.
double growthAlong(const std::vector<double>& values, int step);

/// The same as extrapolate(), along a path, linear in the `values` that are controlled.
void extrapolateAlong(const base::Matrix& alpha, int step, const std::vector<double>& values, double* state);

}  // namespace harmos::latin
