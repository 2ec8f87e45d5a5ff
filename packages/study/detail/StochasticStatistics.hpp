#pragma once

#include <memory>
#include <string>

#include <harmos/results/StochasticSummary.hpp>
#include <harmos/results/StudyResults.hpp>
#include <harmos/study/Study.hpp>
#include <harmos/study/detail/ChaosStudy.hpp>

namespace harmos::study {

/// What a study with random parameters comes to, once its configurations are done. `chaos` of a study of that type,
/// else null; then collective over its communicator, and the answer of rank 0 of all counts, which knows all results.
/// Null without responses, and when configurations that an expansion or interpolation needs have no solution.
std::shared_ptr<const results::StochasticSummary> summarise(const Study& study, const results::StudyResults& results,
                                                            const ChaosStudy* chaos);

/// Why there are no moments of a collocation or a sample whose configurations are done; empty: there are, or it is
/// another design. On rank 0 of all, which knows all results.
std::string lackOfStatistics(const Study& study, const results::StudyResults& results);

/// How expansions were solved for, in one sentence.
std::string describe(const ChaosStudy& chaos, latin::Outcome outcome);

}  // namespace harmos::study
