#include <harmos/files/detail/StochasticGroup.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::files {

namespace {

using results::ResponseStatistics;
using results::StochasticSummary;

/// Quantiles of a germ, to draw it elsewhere: of even probabilities, and of a few in the tails.
void writeGerm(const Hdf5Group& group, const probability::RandomVector& variables, int i) {
  const probability::Distribution& distribution = *variables.variables()[i].distribution;
  const std::string name = distribution.name();
  const bool isNormal = !variables.isIndependent() || name == "Normal" || name == "Lognormal";
  group.attribute("germ", isNormal ? std::string("Normal") : name);
  std::vector<double> levels, quantiles;
  constexpr int count = 1000;
  for (int k = 0; k < count; ++k) levels.push_back((k + 0.5) / count);
  if (name != "Sample") {
    for (const double tail : {1e-4, 1e-5, 1e-6, 1e-7}) {
      levels.insert(levels.begin(), tail);
      levels.push_back(1.0 - tail);
    }
  }
  std::vector<double> point(variables.dimension(), 0.5);
  for (const double level : levels) {
    point[i] = level;
    quantiles.push_back(variables.germs(point)[i]);
  }
  group.array("germ_levels", levels);
  group.array("germ_quantiles", quantiles);
}

/// What is needed to evaluate the polynomials elsewhere: their recurrence, and how a parameter follows from its germ.
void writeVariable(const Hdf5Group& group, const probability::RandomVector& variables, int i) {
  const probability::Distribution& distribution = *variables.variables()[i].distribution;
  group.attribute("distribution", std::string(distribution.name()));
  group.attribute("mean", distribution.mean());
  group.attribute("standard_deviation", distribution.standardDeviation());
  group.attribute("probability_not_positive", distribution.cumulative(0.0));
  const double origin = distribution.value(0.0), unit = distribution.value(1.0);
  const bool isLognormal = distribution.name() == std::string("Lognormal");
  if (variables.isIndependent() && (distribution.isAffine() || isLognormal)) {
    group.attribute("map", std::string(isLognormal ? "exponential" : "affine"));
    group.attribute("shift", isLognormal ? std::log(origin) : origin);
    group.attribute("scale", isLognormal ? std::log(unit / origin) : unit - origin);
  } else {
    group.attribute("map", std::string("none"));
  }
}

/// Those that the polynomials up to a degree need.
std::vector<double> firstOf(const std::vector<double>& recurrence, int degree) {
  return {recurrence.begin(), recurrence.begin() + degree + 1};
}

void writeBasis(const Hdf5Group& group, const probability::Basis& basis) {
  group.attribute("normalisation", std::string("orthonormal"));
  group.attribute("order", basis.order());
  std::vector<int> degrees;
  for (const auto& index : basis.indices()) degrees.insert(degrees.end(), index.begin(), index.end());
  const probability::RandomVector& variables = basis.variables();
  group.array("degrees", degrees, static_cast<std::size_t>(variables.dimension()));
  for (int i = 0; i < variables.dimension(); ++i) {
    const Hdf5Group germ = group.group(variables.variables()[i].name);
    writeVariable(germ, variables, i);
    writeGerm(germ, variables, i);
    const probability::Polynomials& polynomials = variables.polynomials(i);
    germ.array("recurrence_a", firstOf(polynomials.a(), basis.order()));
    germ.array("recurrence_b", firstOf(polynomials.b(), basis.order()));
  }
}

void writeHats(const Hdf5Group& group, const probability::HatSum& sum) {
  std::vector<int> nodes;
  std::vector<double> factors;
  for (const probability::HatSum::Term& term : sum.terms()) {
    nodes.insert(nodes.end(), term.node.begin(), term.node.end());
    factors.insert(factors.end(), term.factors.begin(), term.factors.end());
  }
  group.array("nodes", nodes, sum.lines().size());
  group.array("factors", factors, sum.terms().empty() ? 1 : sum.terms().front().factors.size());
}

/// What is needed to evaluate the interpolation elsewhere: the nodes of the hats of every germ, and the hats.
void writeInterpolant(const Hdf5Group& group, const results::Interpolant& interpolant,
                      const probability::RandomVector& variables) {
  group.array("calibrations", interpolant.calibrations);
  group.array("floors", interpolant.floors);
  writeHats(group.group("values"), interpolant.values);
  writeHats(group.group("doubt"), interpolant.doubt);
  const Hdf5Group germs = group.group("germs");
  for (int i = 0; i < variables.dimension(); ++i) {
    const Hdf5Group germ = germs.group(variables.variables()[i].name);
    writeVariable(germ, variables, i);
    germ.array("positions", interpolant.values.lines()[i].germs());
  }
}

void writeResponse(const Hdf5Group& group, const ResponseStatistics& response, const StochasticSummary& summary) {
  group.attribute("mean", response.mean);
  group.attribute("standard_deviation", response.standardDeviation);
  group.attribute("skewness", response.skewness);
  group.attribute("kurtosis", response.kurtosis);
  group.attribute("mean_error", response.meanError);
  group.attribute("standard_deviation_error", response.deviationError);
  group.attribute("iteration_error", response.iterationError);
  group.attribute("truncation", response.truncation);
  group.attribute("hold_out_error", response.holdOutError);
  group.attribute("prediction_error", response.predictionError);
  if (response.expansion) group.array("coefficients", response.expansion->coefficients());
  group.array("quantiles", response.quantiles);
  group.array("values", response.values);
  group.array("density", response.density);
  group.array("cumulative", response.cumulative);
  std::vector<std::string> sets;
  std::vector<double> main, total;
  for (const probability::SobolIndex& index : response.sobol) {
    std::string set;
    for (const int germ : index.germs) set += (set.empty() ? "" : "*") + summary.germName(germ);
    sets.push_back(set);
    main.push_back(index.main);
    total.push_back(index.total);
  }
  group.array("sobol_sets", sets);
  group.array("sobol_main", main);
  group.array("sobol_total", total);
}

}  // namespace

void writeStatistics(const Hdf5Group& group, const StochasticSummary& summary) {
  group.attribute("method", summary.method);
  group.attribute("sample", summary.isSample ? 1 : 0);
  group.attribute("variables", summary.variables);
  group.attribute("distributions", summary.distributions);
  group.attribute("independent", summary.hasIndependentVariables ? 1 : 0);
  group.attribute("solved", summary.solved);
  group.attribute("inadmissible", summary.inadmissible);
  group.attribute("unsolved", summary.unsolved);
  group.attribute("warnings", summary.warnings);
  group.array("levels", summary.levels);
  const auto expanded = std::find_if(summary.responses.begin(), summary.responses.end(),
                                     [](const ResponseStatistics& response) { return response.expansion != nullptr; });
  if (expanded != summary.responses.end()) writeBasis(group.group("basis"), expanded->expansion->basis());
  if (summary.interpolant) writeInterpolant(group.group("interpolant"), *summary.interpolant, *summary.randomness);
  const Hdf5Group responses = group.group("responses");
  std::vector<std::string> names;
  for (const ResponseStatistics& response : summary.responses) {
    names.push_back(response.name);
    writeResponse(responses.group(response.name), response, summary);
  }
  responses.attribute("order", names);
  if (!summary.convergence.empty()) {
    const Hdf5Group convergence = group.group("convergence");
    std::vector<int> sizes;
    std::vector<double> means, deviations;
    for (const auto& order : summary.convergence) {
      sizes.push_back(order.order);
      means.insert(means.end(), order.means.begin(), order.means.end());
      deviations.insert(deviations.end(), order.deviations.begin(), order.deviations.end());
    }
    convergence.array("size", sizes);
    convergence.array("mean", means, names.size());
    convergence.array("standard_deviation", deviations, names.size());
  }
  if (!summary.sweep.empty()) {
    const Hdf5Group sweep = group.group("sweep");
    std::vector<double> coefficients, means, deviations;
    for (const auto& point : summary.sweep) {
      coefficients.insert(coefficients.end(), point.coefficients.begin(), point.coefficients.end());
      means.insert(means.end(), point.means.begin(), point.means.end());
      deviations.insert(deviations.end(), point.deviations.begin(), point.deviations.end());
    }
    sweep.attribute("names", summary.sweepNames);
    sweep.array("coefficients", coefficients, summary.sweepNames.size());
    sweep.array("mean", means, names.size());
    sweep.array("standard_deviation", deviations, names.size());
  }
}

}  // namespace harmos::files
