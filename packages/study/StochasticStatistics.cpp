#include <harmos/study/detail/StochasticStatistics.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/design/GermDesign.hpp>
#include <harmos/design/RandomDesign.hpp>
#include <harmos/probability/Regression.hpp>
#include <harmos/probability/SampleStatistics.hpp>
#include <harmos/probability/SampledSobolIndices.hpp>
#include <harmos/results/StatusName.hpp>
#include <harmos/study/StochasticTails.hpp>
#include <harmos/study/detail/Interpolation.hpp>
#include <harmos/study/detail/StochasticErrors.hpp>

namespace harmos::study {

namespace {

using results::ResponseStatistics;
using results::StochasticSummary;
using Method = StochasticPlan::Method;
using Points = std::vector<std::vector<double>>;

// Of expansions that are fitted to samples.
constexpr int highestFittedOrder = 6;
constexpr int samplesPerTerm = 3;
constexpr double worstFit = 0.5;
constexpr int densityPoints = 201;

class Summariser {
 public:
  Summariser(const Study& study, const results::StudyResults& results)
      : study_(study),
        plan_(*study.stochastic),
        results_(results),
        summary_(std::make_shared<StochasticSummary>()),
        firstHeldOut_(plan_.germs.size() - static_cast<std::size_t>(plan_.holdOuts)) {
    for (const probability::Variable& variable : plan_.variables->variables())
      summary_->variables.push_back(variable.name);
    summary_->distributions = describeTails(study);
    summary_->hasIndependentVariables = plan_.variables->isIndependent();
    summary_->levels = study.statistics.levels;
    for (const results::ScalarResponse& response : study.responses) {
      summary_->responses.emplace_back();
      summary_->responses.back().name = response.name;
    }
  }

  std::shared_ptr<const StochasticSummary> ofChaos(const ChaosStudy& chaos) {
    summary_->method = std::string("polynomial chaos of order ") + std::to_string(chaos.basis().order()) +
                       (chaos.isGalerkin() ? ", Galerkin" : ", pseudo-spectral") + " local stage";
    chaos.summarise(*summary_);
    useExpansions();
    fill(chaos.sample(sampleGerms()));
    judge(chaos.sample(heldOutGerms()));
    addTruncation(study_, mayHaveKinks(study_), *summary_);
    return summary_;
  }

  std::shared_ptr<const StochasticSummary> ofCollocation() {
    const probability::Quadrature& quadrature = plan_.quadrature;
    const auto basis = std::make_shared<probability::Basis>(plan_.variables, plan_.order);
    Points values(summary_->responses.size());
    for (int q = 0; q < quadrature.size(); ++q) {
      const int id = q + 1;
      if (!isSolved(id)) return nullptr;
      const std::vector<double> responses = results_.responses(id);
      for (std::size_t r = 0; r < responses.size(); ++r) values[r].push_back(responses[r]);
    }
    for (std::size_t r = 0; r < values.size(); ++r) {
      summary_->responses[r].expansion =
          std::make_shared<probability::Expansion>(probability::project(basis, quadrature, values[r]));
    }
    summary_->method =
        "collocation at " + std::to_string(quadrature.size()) + " points, order " + std::to_string(plan_.order);
    summary_->solved = quadrature.size();
    useExpansions();
    fill(evaluateExpansions(sampleGerms()));
    judge(evaluateExpansions(heldOutGerms()));
    addSolverErrors(study_, results_, *summary_);
    addTruncation(study_, mayHaveKinks(study_), *summary_);
    return summary_;
  }

  std::shared_ptr<const StochasticSummary> ofInterpolation() {
    const Interpolation interpolation(study_, results_);
    if (!interpolation.isComplete()) return nullptr;
    const probability::PiecewiseLinear& function = interpolation.function();
    summary_->method = "piecewise linear interpolation of " + std::to_string(interpolation.count()) + " configurations";
    summary_->solved = interpolation.count();
    const auto evaluate = [&](const Points& germs) {
      Points values(summary_->responses.size());
      for (const auto& point : germs) {
        const std::vector<double> at = function.evaluate(point);
        for (std::size_t r = 0; r < at.size(); ++r) values[r].push_back(at[r]);
      }
      return values;
    };
    const Points sample = evaluate(sampleGerms());
    fill(sample);
    for (std::size_t r = 0; r < summary_->responses.size(); ++r) {
      const probability::SampleStatistics statistics(sample[r]);
      ResponseStatistics& response = summary_->responses[r];
      response.mean = function.mean(static_cast<int>(r));
      response.standardDeviation = function.standardDeviation(static_cast<int>(r));
      response.skewness = statistics.skewness();
      response.kurtosis = statistics.kurtosis();
    }
    judge(evaluate(heldOutGerms()));
    addSolverErrors(study_, results_, *summary_);
    for (std::size_t r = 0; r < summary_->responses.size(); ++r) {
      ResponseStatistics& response = summary_->responses[r];
      const double error = function.errorIndicator(static_cast<int>(r)) * response.standardDeviation;
      response.meanError += error;
      response.deviationError += error;
    }
    summary_->randomness = plan_.variables;
    summary_->interpolant =
        std::make_shared<results::Interpolant>(withErrorBars(function, study_, results_, *summary_));
    const Points all = sampleGerms(2);
    const auto half = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    const auto indices = probability::sobolIndices(evaluate, {all.begin(), half}, {half, all.end()});
    for (std::size_t r = 0; r < indices.size(); ++r) summary_->responses[r].sobol = indices[r];
    return summary_;
  }

  std::shared_ptr<const StochasticSummary> ofSample() {
    Points values(summary_->responses.size()), germs;
    for (const design::Configuration& configuration : results_.configurations()) {
      const results::ConfigurationResult* result = results_.find(configuration.id);
      if (result && result->status == results::Status::inadmissible) ++summary_->inadmissible;
      if (!isSolved(configuration.id)) {
        if (result && result->status != results::Status::inadmissible) ++summary_->unsolved;
        continue;
      }
      ++summary_->solved;
      germs.push_back(plan_.germs[configuration.id - 1]);
      const std::vector<double> responses = results_.responses(configuration.id);
      for (std::size_t r = 0; r < responses.size(); ++r) values[r].push_back(responses[r]);
    }
    if (summary_->solved < 2) return nullptr;
    if (summary_->unsolved > 0) {
      summary_->warnings.push_back(std::to_string(summary_->unsolved) +
                                   " draws have no solution and are left out of all figures, which are therefore not "
                                   "those of the distributions");
    }
    summary_->isSample = true;
    summary_->method = study_.design.type + " sample of " + std::to_string(summary_->solved) + " configurations";
    fill(values);
    for (std::size_t r = 0; r < values.size(); ++r) {
      const probability::SampleStatistics statistics(values[r]);
      ResponseStatistics& response = summary_->responses[r];
      response.mean = statistics.mean();
      response.standardDeviation = statistics.standardDeviation();
      response.skewness = statistics.skewness();
      response.kurtosis = statistics.kurtosis();
      response.meanError = statistics.meanError();
      response.deviationError = statistics.standardDeviationError();
    }
    addSolverErrors(study_, results_, *summary_);
    fit(germs, values);
    return summary_;
  }

 private:
  /// Expansions through a sample, for Sobol' indices and for others to evaluate. Kept where they explain the values.
  void fit(const Points& germs, const Points& values) {
    int order = 0;
    std::unique_ptr<const probability::Regression> squares;
    while (order < highestFittedOrder) {
      auto next = leastSquares(order + 1, germs);
      if (!next) break;
      squares = std::move(next);
      ++order;
    }
    if (!squares) return;
    for (std::size_t r = 0; r < values.size(); ++r) {
      const probability::Regression::Fit fit = squares->fit(values[r]);
      if (!(fit.leaveOneOutError < worstFit)) continue;
      ResponseStatistics& response = summary_->responses[r];
      response.expansion = std::make_shared<probability::Expansion>(fit.expansion);
      response.sobol = probability::sobolIndices(fit.expansion);
      response.truncation = fit.expansion.lastDegreeShare();
      response.holdOutError = fit.leaveOneOutError;
      response.predictionError = fit.leaveOneOutError * response.standardDeviation;
    }
    summary_->method += ", Sobol' indices by least squares of order " + std::to_string(order);
  }

  /// Null when the sample does not tell all polynomials of this order apart.
  std::unique_ptr<const probability::Regression> leastSquares(int order, const Points& germs) const {
    try {
      auto basis = std::make_shared<probability::Basis>(plan_.variables, order);
      if (samplesPerTerm * basis->size() > summary_->solved) return nullptr;
      return std::make_unique<const probability::Regression>(std::move(basis), germs);
    } catch (const base::Error& error) {
      // A parameter of few different values has few polynomials, and the user has asked for no order.
      if (error.code() != base::ExitCode::input) throw;
      return nullptr;
    }
  }

  bool isSolved(int id) const {
    const results::ConfigurationResult* result = results_.find(id);
    return result && results::isSolved(result->status);
  }

  /// `times` as many as the user wants.
  Points sampleGerms(int times = 1) const {
    const int count = times * study_.statistics.samples;
    return design::germsOf(design::RandomDesign(count, study_.statistics.seed), count, *plan_.variables);
  }

  Points heldOutGerms() const {
    return {plan_.germs.begin() + static_cast<std::ptrdiff_t>(firstHeldOut_), plan_.germs.end()};
  }

  Points evaluateExpansions(const Points& germs) const {
    Points values(summary_->responses.size());
    for (std::size_t r = 0; r < values.size(); ++r) {
      for (const auto& point : germs) values[r].push_back(summary_->responses[r].expansion->evaluate(point));
    }
    return values;
  }

  /// Shares of no variance are undefined.
  static void setConstant(ResponseStatistics& response) {
    response.standardDeviation = 0.0;
    response.deviationError = std::fmax(response.deviationError, leastSpread * std::abs(response.mean));
    response.sobol = probability::sobolIndices(*response.expansion);
    for (probability::SobolIndex& index : response.sobol) index.main = index.total = ResponseStatistics::unknown;
  }

  void useExpansions() {
    for (ResponseStatistics& response : summary_->responses) {
      const probability::Expansion& expansion = *response.expansion;
      response.mean = expansion.mean();
      response.standardDeviation = expansion.standardDeviation();
      if (response.standardDeviation <= leastSpread * std::abs(response.mean)) {
        setConstant(response);
        continue;
      }
      response.skewness = expansion.skewness();
      response.kurtosis = expansion.kurtosis();
      response.truncation = expansion.lastDegreeShare();
      response.sobol = probability::sobolIndices(expansion);
    }
    if (!summary_->convergence.empty()) return;
    // What the terms up to each degree hold; no more than that is known without solving lower orders.
    const auto& indices = summary_->responses.front().expansion->basis().indices();
    const int order = summary_->responses.front().expansion->basis().order();
    for (int degree = 1; degree <= order; ++degree) {
      auto& moments = summary_->convergence.emplace_back();
      moments.order = degree;
      for (const ResponseStatistics& response : summary_->responses) {
        const auto& coefficients = response.expansion->coefficients();
        double variance = 0.0;
        for (std::size_t a = 1; a < coefficients.size(); ++a) {
          int total = 0;
          for (const int each : indices[a]) total += each;
          if (total <= degree) variance += coefficients[a] * coefficients[a];
        }
        moments.means.push_back(coefficients[0]);
        moments.deviations.push_back(std::sqrt(variance));
      }
    }
  }

  /// Quantiles and densities of samples, [response][point].
  void fill(const Points& sample) {
    for (std::size_t r = 0; r < sample.size(); ++r) {
      const probability::SampleStatistics statistics(sample[r]);
      ResponseStatistics& response = summary_->responses[r];
      for (const double level : summary_->levels) response.quantiles.push_back(statistics.quantile(level));
      const probability::DensityCurve density = statistics.density(densityPoints);
      response.values = density.points;
      response.density = density.values;
      for (const double value : density.points) response.cumulative.push_back(statistics.cumulative(value));
    }
  }

  /// Root mean square error at the configurations that are held out.
  void judge(const Points& predicted) {
    for (std::size_t r = 0; r < predicted.size(); ++r) {
      double sum = 0.0;
      int count = 0;
      for (std::size_t i = 0; i < predicted[r].size(); ++i) {
        const int id = static_cast<int>(firstHeldOut_ + i) + 1;
        if (!isSolved(id)) continue;
        sum += std::pow(predicted[r][i] - results_.responses(id)[r], 2);
        ++count;
      }
      ResponseStatistics& response = summary_->responses[r];
      if (count > 0 && response.standardDeviation > 0.0) {
        response.holdOutError = std::sqrt(sum / count) / response.standardDeviation;
      }
    }
  }

  const Study& study_;
  const StochasticPlan& plan_;
  const results::StudyResults& results_;
  std::shared_ptr<StochasticSummary> summary_;
  std::size_t firstHeldOut_;
};

}  // namespace

std::shared_ptr<const StochasticSummary> summarise(const Study& study, const results::StudyResults& results,
                                                   const ChaosStudy* chaos) {
  if (study.responses.empty()) return nullptr;  // random fields alone are asked for
  Summariser summariser(study, results);
  switch (study.stochastic->method) {
    case Method::chaos:
      return summariser.ofChaos(*chaos);
    case Method::collocation:
      return summariser.ofCollocation();
    case Method::adaptive:
      return summariser.ofInterpolation();
    case Method::sampling:
      return summariser.ofSample();
  }
  return nullptr;
}

std::string lackOfStatistics(const Study& study, const results::StudyResults& results) {
  const StochasticPlan& plan = *study.stochastic;
  const bool isCollocation = plan.method == Method::collocation;
  if (study.responses.empty() || (!isCollocation && plan.method != Method::sampling)) return "";
  const auto begin = results.configurations().begin();
  const auto end = isCollocation ? begin + plan.quadrature.size() : results.configurations().end();
  const auto solved = std::count_if(begin, end, [&](const design::Configuration& configuration) {
    const results::ConfigurationResult* result = results.find(configuration.id);
    return result != nullptr && results::isSolved(result->status);
  });
  if (!isCollocation) return solved < 2 ? "none, since fewer than two draws have a solution" : "";
  const auto lacking = end - begin - solved;
  if (lacking == 0) return "";
  return "none, since " + std::to_string(lacking) + " of the " + std::to_string(end - begin) +
         " points of the quadrature have no solution; the design Latin Hypercube leaves out what has none, and says so";
}

std::string describe(const ChaosStudy& chaos, latin::Outcome outcome) {
  std::ostringstream text;
  text << (outcome == latin::Outcome::certified ? "" : "NOT all that was asked for: ") << "order "
       << chaos.basis().order() << ", " << chaos.basis().size() << " terms, "
       << (chaos.isGalerkin() ? "Galerkin" : "pseudo-spectral") << " local stage, " << chaos.columns()
       << " columns solved; this local stage " << chaos.choice().why;
  if (!chaos.reason().empty()) text << "; " << chaos.reason();
  return text.str();
}

}  // namespace harmos::study
