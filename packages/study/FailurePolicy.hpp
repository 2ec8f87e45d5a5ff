#pragma once

#include <vector>

#include <harmos/input/Parameters.hpp>
#include <harmos/results/ConfigurationResult.hpp>

namespace harmos::study {

/// What a study does with a configuration that has no solution as accurate as asked for.
struct FailurePolicy {
  /// Solve it again, cold and by itself; record it only; end the study; put given values in place of its responses;
  /// walk to it from the nearest solved configuration.
  enum class Kind { retry, record, abort, recover, continuation };

  Kind kind = Kind::retry;     // what is done
  int attempts = 1;            // of retry, the most
  int steps = 8;               // of continuation, the most; they begin at 2 and are doubled
  std::vector<double> values;  // of recover, in place of the responses
};

/// Of the input of a study, from its list Failure Policy; retry when there is none. Keeps nothing of it.
FailurePolicy readFailurePolicy(const input::Parameters& study);

/// Whether another way of solving may help: it failed or did not converge. Loads that cannot be carried and values that
/// the scene does not allow stay what they are.
bool mayBeHelped(const results::ConfigurationResult& result);

}  // namespace harmos::study
