#pragma once

#include <harmos/files/detail/Hdf5.hpp>
#include <harmos/results/StochasticSummary.hpp>

namespace harmos::files {

/// Writes what a study with random parameters has come to into a group of its file; docs/guide/stochastic.md describes
/// the layout. Throws base::Error when it cannot.
void writeStatistics(const Hdf5Group& group, const results::StochasticSummary& summary);

}  // namespace harmos::files
