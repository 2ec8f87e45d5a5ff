#pragma once

#include <harmos/probability/PiecewiseLinear.hpp>
#include <harmos/results/StochasticSummary.hpp>
#include <harmos/results/StudyResults.hpp>
#include <harmos/study/Study.hpp>

namespace harmos::study {

/// Standard deviation over the mean up to which a response is constant but for round-off.
inline constexpr double leastSpread = 1e-9;

/// Whether responses may have kinks over the random parameters, because a law is not smooth: contact and friction.
bool mayHaveKinks(const Study& study);

/// What the mean and the standard deviation of a response, from 0, are off because the solutions of the configurations
/// are: a third of its root mean square times its largest error estimate.
double solverError(const Study& study, const results::StudyResults& results, std::size_t response, double mean,
                   double deviation);

/// Adds solverError() to the errors of the moments, which are set, and warns where it hides the spread.
void addSolverErrors(const Study& study, const results::StudyResults& results, results::StochasticSummary& summary);

/// Adds to the errors of the moments, and sets as error bars, what the expansions are off by truncation and quadrature,
/// and warns of kinks.
///
/// The root mean square distance of a response from its expansion is that at the configurations held out, but where
/// kinks may be not less than half of what the coefficients say of them; see probability::kinkedResidual(). A third of
/// it is the error of mean and standard deviation: for kinks anywhere, orders 1 to 12 and 1 to 3 parameters it is 0.1
/// to 2.1 of the true one, see docs/method/stochastic.md.
void addTruncation(const Study& study, bool hasKinks, results::StochasticSummary& summary);

/// The interpolation with error bars: 95 % of the errors at points that are left out of it and at those that are held
/// out lie within 1.96 of them. `summary` has the moments and the errors of the solutions.
results::Interpolant withErrorBars(const probability::PiecewiseLinear& function, const Study& study,
                                   const results::StudyResults& results, const results::StochasticSummary& summary);

}  // namespace harmos::study
