#pragma once

#include <iosfwd>

#include <harmos/output/StudyResults.hpp>
#include <harmos/setup/Study.hpp>

namespace harmos::setup {

/// Prints what a study will do: configurations, those left out, and what every parameter changes.
void printPlan(std::ostream& out, const Study& study);

/// Prints what it did: how many configurations ended how, the range of every response, the cost.
void printOutcome(std::ostream& out, const output::StudyResults& results);

}  // namespace harmos::setup
