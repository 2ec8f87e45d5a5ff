#pragma once

#include <harmos/output/Hdf5.hpp>
#include <harmos/study/StochasticSummary.hpp>

namespace harmos::output {

/// Writes what a study with random parameters has come to into a group of its file; docs/guide/stochastic.md describes
/// the layout. Throws base::Error when it cannot.
void writeStatistics(const Hdf5Group& group, const study::StochasticSummary& summary);

}  // namespace harmos::output
