#include <harmos/setup/StochasticTails.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include <harmos/base/Error.hpp>

namespace harmos::setup {

namespace {

using Method = StochasticPlan::Method;

// What is left of the mean at the outermost Gauss point, below which a user is warned.
constexpr double narrowMargin = 0.2;
// Stiffness 0 is admissible by itself, but not as the edge of what is indefinite.
constexpr double beyondTheEdge = 1.0 + 1e-9;

bool usesGaussPoints(const StochasticPlan& plan) {
  return plan.method == Method::chaos || plan.method == Method::collocation;
}

chaos::GaussRule ruleOf(const Study& study, const chaos::RandomVector& variables, int germ) {
  const StochasticPlan& plan = *study.stochastic;
  const base::Parameters& design = study.input.list("Design");
  const bool mayBeGalerkin = plan.method == Method::chaos && design.text("Local Stage") != "Pseudo-Spectral";
  const auto counts = gaussPoints(variables, plan.order, design.integer("Points"), mayBeGalerkin);
  return variables.polynomials(germ).gauss(counts[static_cast<std::size_t>(germ)]);
}

/// The combination of Gauss points at which a parameter has its least or largest value, with its other germs in the
/// middle. A parameter grows or falls with each germ.
std::vector<double> extremeGerms(const Study& study, const chaos::RandomVector& variables, int i, bool isLeast) {
  const auto place = static_cast<std::size_t>(i);
  const std::vector<double> middle =
      variables.germs(std::vector<double>(static_cast<std::size_t>(variables.dimension()), 0.5));
  std::vector<double> extreme = middle;
  for (std::size_t g = 0; g < middle.size(); ++g) {
    if (variables.isIndependent() ? g != place : g > place) continue;
    const chaos::GaussRule rule = ruleOf(study, variables, static_cast<int>(g));
    const auto valueAt = [&](double germ) {
      std::vector<double> germs = middle;
      germs[g] = germ;
      return variables.values(germs)[place];
    };
    const bool isFrontLower = valueAt(rule.points.front()) <= valueAt(rule.points.back());
    extreme[g] = beyondTheEdge * (isFrontLower == isLeast ? rule.points.front() : rule.points.back());
  }
  return extreme;
}

/// How far a parameter is from its mean there, in standard deviations, of which it must have some.
double reach(const chaos::RandomVector& variables, int i, const std::vector<double>& germs) {
  const chaos::Distribution& distribution = *variables.variables()[static_cast<std::size_t>(i)].distribution;
  const double value = variables.values(germs)[static_cast<std::size_t>(i)];
  return std::abs(value - distribution.mean()) / distribution.standardDeviation();
}

std::string text(double value) {
  std::ostringstream stream;
  stream << std::setprecision(4) << value;
  return stream.str();
}

std::string remedy(const chaos::Distribution& distribution, double deviations) {
  std::string text = "Take a distribution that admits only what the scene does (Lognormal for what is positive)";
  if (distribution.name() == std::string("Normal")) {
    std::ostringstream limit;
    limit << std::setprecision(3) << 1.0 / deviations;
    text += ", a coefficient of variation well below " + limit.str();
  }
  return text + ", or a lower Order.";
}

void checkVariable(const Study& study, const laws::LawRegistry& laws, const chaos::RandomVector& variables, int i,
                   const std::string& where, base::ErrorList& errors) {
  const chaos::Variable& variable = variables.variables()[static_cast<std::size_t>(i)];
  for (const bool isLeast : {true, false}) {
    const std::vector<double> germs = extremeGerms(study, variables, i, isLeast);
    const std::vector<double> values = variables.values(germs);
    try {
      study.sceneFor(*study.plan->complete(values), laws);
    } catch (const base::Error& error) {
      if (error.code() != base::ExitCode::input) throw;
      const double deviations = reach(variables, i, germs);
      errors.add(where,
                 "an expansion of order " + std::to_string(study.stochastic->order) + " needs " + variable.name +
                     " = " + text(values[static_cast<std::size_t>(i)]) + ", " + text(deviations) +
                     " standard deviations from its mean, which the scene refuses: " + error.what(),
                 remedy(*variable.distribution, deviations));
      return;
    }
  }
}

/// Of a normal parameter with this coefficient of variation; empty when its tail does not matter.
std::string warningOf(const Study& study, int i, double coefficient) {
  const StochasticPlan& plan = *study.stochastic;
  const chaos::Distribution& distribution = plan.distribution(static_cast<std::size_t>(i));
  if (!usesGaussPoints(plan) || distribution.name() != std::string("Normal")) return "";
  const chaos::RandomVector& variables = *plan.variables;
  const chaos::GaussRule rule = ruleOf(study, variables, i);
  const double deviations = distribution.standardDeviation() > 0.0
                                ? reach(variables, i, extremeGerms(study, variables, i, true))
                                : std::abs(rule.points.front());
  const double margin = 1.0 - coefficient * deviations;
  // What the scene allows to be negative is no stiffness.
  if (margin <= 0.0 || margin >= narrowMargin) return "";
  return "; WARNING: at the outermost of " + std::to_string(rule.points.size()) + " Gauss points only " +
         text(100.0 * margin) +
         " % of the mean is left: what follows from the tail is an artefact of the normal distribution";
}

}  // namespace

void checkTails(const Study& study, const laws::LawRegistry& laws, base::ErrorList& errors) {
  const StochasticPlan& plan = *study.stochastic;
  if (!usesGaussPoints(plan)) return;
  for (int i = 0; i < plan.variables->dimension(); ++i) {
    const StudyParameter& parameter = study.parameters[plan.places[static_cast<std::size_t>(i)]];
    checkVariable(study, laws, *plan.variables, i, parameter.where + " / Distribution", errors);
  }
  std::vector<double> largest;
  for (const auto& sweep : plan.sweeps) {
    largest.push_back(*std::max_element(sweep.coefficients.begin(), sweep.coefficients.end()));
  }
  const auto widest = withSpread(plan, largest);
  for (const auto& sweep : plan.sweeps) {
    const auto& lists = study.input.lists("Sweep");
    const auto list =
        std::find_if(lists.begin(), lists.end(), [&](const auto& each) { return each.name() == sweep.name; });
    checkVariable(study, laws, *widest, static_cast<int>(sweep.variable), list->where("Values"), errors);
  }
}

std::vector<std::string> describeTails(const Study& study) {
  const StochasticPlan& plan = *study.stochastic;
  std::vector<std::string> sentences;
  for (int i = 0; i < plan.variables->dimension(); ++i) {
    const chaos::Variable& variable = plan.variables->variables()[static_cast<std::size_t>(i)];
    const chaos::Distribution& distribution = *variable.distribution;
    const double mean = distribution.mean(), deviation = distribution.standardDeviation();
    std::string sentence = variable.name + ": " + distribution.name() + ", mean " + text(mean) +
                           ", standard deviation " + text(deviation) + ", P(" + variable.name +
                           " <= 0) = " + text(distribution.cumulative(0.0));
    if (mean != 0.0) sentence += warningOf(study, i, deviation / std::abs(mean));
    sentences.push_back(std::move(sentence));
  }
  return sentences;
}

std::vector<std::string> describeSweeps(const Study& study) {
  std::vector<std::string> sentences;
  for (const StochasticPlan::Sweep& sweep : study.stochastic->sweeps) {
    std::vector<double> coefficients = sweep.coefficients;
    std::sort(coefficients.begin(), coefficients.end());
    std::string sentence = sweep.name + ": coefficient of variation of " +
                           study.parameters[study.stochastic->places[sweep.variable]].name + ", " +
                           std::to_string(coefficients.size()) + " values up to " + text(coefficients.back());
    for (const double coefficient : coefficients) {
      const std::string warning = warningOf(study, static_cast<int>(sweep.variable), coefficient);
      if (warning.empty()) continue;
      sentence += ", of " + text(coefficient) + warning;
      break;
    }
    sentences.push_back(std::move(sentence));
  }
  return sentences;
}

}  // namespace harmos::setup
