#pragma once

#include <vector>

#include <harmos/base/ColumnStore.hpp>
#include <harmos/base/Matrix.hpp>
#include <harmos/latin/StateMetric.hpp>

namespace harmos::latin {

/// Collective. How far the fields f and k w of a state are from those of an earlier one at every load step, the larger
/// of both, each relative to the largest f and k w of the state over all load steps [-]; alpha = f + k w and beta =
/// f - k w are those of the linear stage [stress].
std::vector<double> fieldDistances(const StateMetric& metric, const base::Matrix& alpha, const base::Matrix& beta,
                                   const base::ColumnStore& startAlpha, const base::ColumnStore& startBeta);

}  // namespace harmos::latin
