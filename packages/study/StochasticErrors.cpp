#include <harmos/study/detail/StochasticErrors.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include <boost/math/distributions/students_t.hpp>

#include <harmos/probability/SampleStatistics.hpp>
#include <harmos/probability/Truncation.hpp>
#include <harmos/results/StatusName.hpp>

namespace harmos::study {

namespace {

using results::ResponseStatistics;
using results::StochasticSummary;

// Error of a mean and of a standard deviation over the root mean square error of the expansion.
constexpr double errorOfMoments = 1.0 / 3.0;
// Held out configurations show that there is no kink where so many of them, for an expansion of so high an order, have
// an error below this share of what a kink would make; a few may lie where the expansion happens to be right.
constexpr int holdOutsThatTell = 5, orderThatTells = 3;
constexpr double contradiction = 1.0 / 16.0, safetyWhenSmooth = 3.0;
// Share of what the coefficients say of a kink, beside configurations held out: those of low degree are partly smooth.
constexpr double believedOfKink = 0.5;
// Error bars: share of predictions within so many standard deviations.
constexpr double confidence = 0.95, confidentDeviations = 1.96;
// Residual over the standard deviation from which on users are warned, and error of the solutions over it.
constexpr double visibleKink = 0.01, visibleSolverError = 0.1;

/// By which a root mean square of a few errors is to be multiplied, so that 1.96 of it hold 95 % of normal errors.
double smallSampleFactor(int holdOuts) {
  if (holdOuts == 0) return 1.0;
  return boost::math::quantile(boost::math::students_t(holdOuts), 0.5 + 0.5 * confidence) / confidentDeviations;
}

}  // namespace

bool mayHaveKinks(const Study& study) {
  return std::any_of(study.scene.laws.begin(), study.scene.laws.end(),
                     [](const auto& named) { return !named.second->isSmooth(); });
}

double solverError(const Study& study, const results::StudyResults& results, std::size_t response, double mean,
                   double deviation) {
  double largest = 0.0;
  const std::size_t curve = study.responses[response].curve;
  for (const results::ConfigurationResult& result : results.all()) {
    const bool isKnown = results::isSolved(result.status) && curve < result.curveErrors.size();
    if (isKnown && std::isfinite(result.curveErrors[curve])) largest = std::max(largest, result.curveErrors[curve]);
  }
  return errorOfMoments * largest * std::hypot(mean, deviation);
}

void addSolverErrors(const Study& study, const results::StudyResults& results, StochasticSummary& summary) {
  std::string hidden;
  double worst = 0.0;
  for (std::size_t r = 0; r < summary.responses.size(); ++r) {
    ResponseStatistics& response = summary.responses[r];
    const double deviation = response.standardDeviation;
    response.iterationError = solverError(study, results, r, response.mean, deviation);
    response.meanError = std::fmax(response.meanError, 0.0) + response.iterationError;
    response.deviationError = std::fmax(response.deviationError, 0.0) + response.iterationError;
    const bool isConstant = !(deviation > leastSpread * std::abs(response.mean));
    if (isConstant || !(response.iterationError > visibleSolverError * deviation)) continue;
    hidden += (hidden.empty() ? "" : ", ") + response.name;
    worst = std::max(worst, response.iterationError / deviation);
  }
  if (hidden.empty()) return;
  std::ostringstream text;
  text << "the solutions of the configurations may not be exact enough for the spread of " << hidden
       << ": their errors count as " << std::setprecision(2) << 100.0 * worst
       << " % of the standard deviation; ask for a smaller Accuracy";
  summary.warnings.push_back(text.str());
}

void addTruncation(const Study& study, bool hasKinks, StochasticSummary& summary) {
  const StochasticPlan& plan = *study.stochastic;
  std::string kinked;
  double worst = 0.0;
  for (ResponseStatistics& response : summary.responses) {
    const double deviation = response.standardDeviation;
    if (!(deviation > 0.0)) continue;
    const double heldOut = response.holdOutError * deviation;  // not a number without any
    double residual = heldOut;
    if (hasKinks) {
      const double kink = probability::kinkedResidual(*response.expansion);
      const bool isContradicted = plan.holdOuts >= holdOutsThatTell &&
                                  response.expansion->basis().order() >= orderThatTells &&
                                  heldOut < contradiction * kink;
      residual = isContradicted        ? safetyWhenSmooth * heldOut
                 : std::isnan(heldOut) ? kink
                                       : std::max(heldOut, believedOfKink * kink);
      if (!isContradicted && residual > visibleKink * deviation) {
        kinked += (kinked.empty() ? "" : ", ") + response.name;
        worst = std::max(worst, residual / deviation);
      }
    } else if (std::isnan(heldOut)) {
      residual = probability::smoothResidual(*response.expansion);
    }
    response.predictionError = std::fmax(residual, heldOut * smallSampleFactor(plan.holdOuts));
    response.meanError += errorOfMoments * residual;
    response.deviationError += errorOfMoments * residual;
  }
  if (kinked.empty()) {
    if (hasKinks) summary.method += "; no kink of its laws shows, and errors do not count one that it does not meet";
    return;
  }
  std::ostringstream text;
  text << "the laws are not smooth over the random range, and polynomials do not follow kinks: " << kinked
       << " differs from its expansion by up to " << std::setprecision(2) << 100.0 * worst
       << " % of the standard deviation (root mean square); take a design of the type "
       << (plan.variables->dimension() <= mostAdaptiveVariables ? "Adaptive Collocation" : "Sobol or Latin Hypercube");
  summary.warnings.push_back(text.str());
}

results::Interpolant withErrorBars(const probability::PiecewiseLinear& function, const Study& study,
                                   const results::StudyResults& results, const results::StochasticSummary& summary) {
  const std::size_t count = summary.responses.size();
  results::Interpolant interpolant{function.function(), function.doubt(), {}, {}};
  const auto leftOut = function.leftOut();
  const StochasticPlan& plan = *study.stochastic;
  const std::size_t firstHeldOut = plan.germs.size() - static_cast<std::size_t>(plan.holdOuts);
  for (std::size_t r = 0; r < count; ++r) {
    const ResponseStatistics& response = summary.responses[r];
    const double floor = std::max(response.iterationError, leastSpread * std::abs(response.mean));
    std::vector<double> ratios;
    const auto compare = [&](double error, double doubt) {
      if (doubt > 0.0 || error > confidentDeviations * floor) {
        ratios.push_back(std::max(0.0, error - confidentDeviations * floor) / std::max(doubt, floor));
      }
    };
    for (const auto& one : leftOut) compare(one.errors[r], one.doubts[r]);
    for (std::size_t i = firstHeldOut; i < plan.germs.size(); ++i) {
      const int id = static_cast<int>(i) + 1;
      const results::ConfigurationResult* result = results.find(id);
      if (!result || !results::isSolved(result->status)) continue;
      const std::vector<double> doubts = interpolant.doubt.evaluate(plan.germs[i]);
      const double error = std::abs(interpolant.values.evaluate(plan.germs[i])[r] - results.responses(id)[r]);
      compare(error, doubts.empty() ? 0.0 : doubts[r]);
    }
    interpolant.floors.push_back(floor);
    // Of few ratios the next larger one: the point that is predicted is one more of them.
    const auto size = static_cast<double>(ratios.size());
    const double fraction = ratios.empty() ? 1.0 : std::min(1.0, confidence * (size + 1.0) / size);
    interpolant.calibrations.push_back(
        ratios.empty() ? 1.0 : probability::SampleStatistics(ratios).quantile(fraction) / confidentDeviations);
  }
  return interpolant;
}

}  // namespace harmos::study
