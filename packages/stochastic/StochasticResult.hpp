#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/latin/LatinResult.hpp>
#include <harmos/probability/Expansion.hpp>

namespace harmos::stochastic {

/// A standard deviation below this share of the mean counts as that share where errors are relative to it.
inline constexpr double smallestSpread = 1e-3;

/// One response at every load step as an expansion, with the estimate of its relative error.
struct ResponseExpansion {
  std::string name;                                 ///< of the response
  std::shared_ptr<const probability::Basis> basis;  ///< shared with the projection of the solver
  base::Matrix coefficients;                        ///< terms x load steps, in the unit of the response
  double errorEstimate = 0.0;                       ///< see ChaosSnapshot; not a number when there is none

  /// The response at a load step, from 0, as a function of the germs.
  probability::Expansion at(int step) const {
    const double* values = coefficients[step];
    return {basis, {values, values + coefficients.numRows()}};
  }
};

/// What a run achieved. The fields are read from StochasticSolver::state().
///
/// The estimates are of the iteration: they say nothing of the truncation of the expansion.
struct StochasticResult {
  latin::Outcome outcome = latin::Outcome::iterationLimit;  ///< certified: the estimate is within the accuracy
  std::string reason;                                       ///< one sentence for the user
  std::vector<ResponseExpansion> responses;                 ///< in the order of addResponse()
  double forceErrorEstimate = 0.0;                          ///< relative, field of interface forces
  double displacementErrorEstimate = 0.0;                   ///< relative, field of interface displacements
  double errorEstimate = 0.0;                               ///< largest of all estimates
  int iterations = 0;                                       ///< applications of both stages, in units of all load steps
  long columns = 0;                                         ///< columns that the linear stage has solved
};

}  // namespace harmos::stochastic
