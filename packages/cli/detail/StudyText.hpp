#pragma once

#include <iosfwd>

#include <harmos/results/StudyResults.hpp>
#include <harmos/study/Study.hpp>

namespace harmos::cli {

/// Prints what a study will do: configurations, those left out, and what every parameter changes.
void printPlan(std::ostream& out, const study::Study& study);

/// Prints what it did: how many configurations ended how, the range of every response, the cost.
void printOutcome(std::ostream& out, const results::StudyResults& results);

}  // namespace harmos::cli
