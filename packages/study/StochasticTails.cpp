#include <harmos/study/StochasticTails.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/probability/PiecewiseLinear.hpp>

namespace harmos::study {

namespace {

using Method = StochasticPlan::Method;

// What is left of the mean at the outermost Gauss point, below which a user is warned.
constexpr double narrowMargin = 0.2;
// Parameters whose combinations are all looked at.
constexpr int mostForCorners = 6;
// Stiffness 0 is admissible by itself, but not as the edge of what is indefinite.
constexpr double beyondTheEdge = 1.0 + 1e-9;

bool usesGaussPoints(const StochasticPlan& plan) {
  return plan.method == Method::chaos || plan.method == Method::collocation;
}

/// The order that is certainly solved: with a tolerance it is raised from 1, and 2 is the first to be compared.
int certainOrder(const Study& study) {
  const int order = study.stochastic->order;
  const auto* chaos = study.design.as<ChaosOptions>();
  return chaos && chaos->tolerance ? std::min(order, 2) : order;
}

probability::GaussRule ruleOf(const Study& study, const probability::RandomVector& variables, int i, int order) {
  const auto points = gaussPoints(variables, order, study.stochastic->points, false);
  return variables.polynomials(i).gauss(points[i]);
}

std::string text(double value) {
  std::ostringstream stream;
  stream << std::setprecision(4) << value;
  return stream.str();
}

/// The least and the largest germ at which the scene is asked for.
std::pair<double, double> reachOf(const Study& study, const probability::RandomVector& variables, int i, int order) {
  if (usesGaussPoints(*study.stochastic)) {
    const probability::GaussRule rule = ruleOf(study, variables, i, order);
    return {rule.points.front(), rule.points.back()};
  }
  const auto count = static_cast<std::size_t>(variables.dimension()), at = static_cast<std::size_t>(i);
  const double omitted = probability::PiecewiseLinear::omittedProbability();
  return {variables.germs(std::vector<double>(count, omitted))[at],
          variables.germs(std::vector<double>(count, 1.0 - omitted))[at]};
}

std::string remedy(const Study& study, const probability::Distribution& distribution, double largestGerm) {
  std::string text = "Take a distribution that admits only what the scene does (Lognormal for what is positive)";
  if (distribution.name() == std::string("Normal")) {
    std::ostringstream limit;
    limit << std::setprecision(3) << 1.0 / largestGerm;
    text += ", a coefficient of variation well below " + limit.str();
  }
  return text + (usesGaussPoints(*study.stochastic) ? ", or a lower Order." : ".");
}

/// What the scene says against these values; empty when it allows them.
using Refusal = std::function<std::string(const std::vector<double>& values)>;

std::string refusal(const Study& study, const laws::LawRegistry& laws, const Demand& demand,
                    const std::vector<double>& values) {
  try {
    demand(study.sceneFor(*study.plan->complete(values), laws));
  } catch (const base::Error& error) {
    if (error.code() != base::ExitCode::input) throw;
    return error.what();
  }
  return "";
}

std::string whoNeeds(const Study& study, int order) {
  return (usesGaussPoints(*study.stochastic) ? "an expansion of order " + std::to_string(order)
                                             : std::string("an interpolation over all but the rarest values")) +
         " needs ";
}

/// Both ends of what is needed of one parameter, the others at their medians.
void checkVariable(const Study& study, const Refusal& refuse, const probability::RandomVector& variables, int i,
                   int order, const std::string& where, input::ErrorList& errors) {
  const auto [least, largest] = reachOf(study, variables, i, order);
  const probability::Variable& variable = variables.variables()[i];
  std::vector<double> germs = variables.germs(std::vector<double>(variables.dimension(), 0.5));
  for (const double point : {least, largest}) {
    germs[i] = point * beyondTheEdge;
    const std::vector<double> values = variables.values(germs);
    const std::string reason = refuse(values);
    if (reason.empty()) continue;
    const double value = values[i];
    errors.add(where,
               whoNeeds(study, order) + variable.name + " = " + text(value) + ", " +
                   text(std::abs(value - variable.distribution->mean()) / variable.distribution->standardDeviation()) +
                   " standard deviations from its mean, which the scene refuses: " + reason,
               remedy(study, *variable.distribution, largest));
    return;
  }
}

/// All corners of what is needed: where parameters are correlated, or meet in a formula.
void checkCorners(const Study& study, const Refusal& refuse, const probability::RandomVector& variables, int order,
                  input::ErrorList& errors) {
  const std::size_t dimension = variables.variables().size();
  for (std::size_t corner = 0; corner < (std::size_t{1} << dimension); ++corner) {
    std::vector<double> germs;
    for (std::size_t i = 0; i < dimension; ++i) {
      const auto [least, largest] = reachOf(study, variables, static_cast<int>(i), order);
      germs.push_back(beyondTheEdge * ((corner >> i) % 2 == 0 ? least : largest));
    }
    const std::vector<double> values = variables.values(germs);
    const std::string reason = refuse(values);
    if (reason.empty()) continue;
    std::string point;
    for (std::size_t i = 0; i < dimension; ++i) {
      point += (point.empty() ? "" : ", ") + variables.variables()[i].name + " = " + text(values[i]);
    }
    errors.add(study.stochastic->where, whoNeeds(study, order) + point + ", which the scene refuses: " + reason,
               "Take distributions that admit only what the scene does (Lognormal for what is positive), less spread, "
               "or a lower Order.");
    return;
  }
}

/// How far from its mean the outermost Gauss points of all germs take a normal parameter, in standard deviations.
double reachInDeviations(const Study& study, int i) {
  const probability::RandomVector& variables = *study.stochastic->variables;
  const auto place = static_cast<std::size_t>(i);
  const double deviation = study.stochastic->distribution(place).standardDeviation();
  const int order = certainOrder(study);
  if (variables.isIndependent() || deviation == 0.0) return std::abs(ruleOf(study, variables, i, order).points.front());
  const std::vector<double> middle(variables.variables().size(), 0.0);
  double reach = 0.0;
  for (std::size_t g = 0; g < middle.size(); ++g) {
    std::vector<double> germs = middle;
    germs[g] = ruleOf(study, variables, static_cast<int>(g), order).points.front();
    reach += std::abs(variables.values(germs)[place] - variables.values(middle)[place]) / deviation;
  }
  return reach;
}

/// Of a normal parameter with this coefficient of variation; empty when its tail does not matter.
std::string warningOf(const Study& study, int i, double coefficient) {
  const StochasticPlan& plan = *study.stochastic;
  if (!usesGaussPoints(plan)) return "";
  if (plan.distribution(static_cast<std::size_t>(i)).name() != std::string("Normal")) return "";
  const double margin = 1.0 - coefficient * reachInDeviations(study, i);
  // What the scene allows to be negative is no stiffness.
  if (margin <= 0.0 || margin >= narrowMargin) return "";
  const auto count = ruleOf(study, *plan.variables, i, certainOrder(study)).points.size();
  return "; WARNING: at the outermost of " + std::to_string(count) + " Gauss points only " + text(100.0 * margin) +
         " % of the mean is left: what follows from the tail is an artefact of the normal distribution";
}

}  // namespace

void checkTails(const Study& study, const laws::LawRegistry& laws, const Demand& demand, input::ErrorList& errors) {
  checkTails(study, laws, certainOrder(study), demand, errors);
}

void checkTails(const Study& study, const laws::LawRegistry& laws, int order, const Demand& demand,
                input::ErrorList& errors) {
  const StochasticPlan& plan = *study.stochastic;
  if (plan.method == Method::sampling) return;
  const Refusal refuse = [&](const std::vector<double>& values) { return refusal(study, laws, demand, values); };
  std::vector<double> largest;
  for (const auto& sweep : plan.sweeps) {
    largest.push_back(*std::max_element(sweep.coefficients.begin(), sweep.coefficients.end()));
  }
  const auto widest = withSpread(plan, largest);
  const int before = errors.count();
  if (plan.variables->isIndependent()) {
    for (int i = 0; i < plan.variables->dimension(); ++i) {
      const StudyParameter& parameter = study.parameters[plan.places[i]];
      checkVariable(study, refuse, *plan.variables, i, order, parameter.where + " / Distribution", errors);
    }
    for (const auto& sweep : plan.sweeps) {
      checkVariable(study, refuse, *widest, static_cast<int>(sweep.variable), order, sweep.where, errors);
    }
    if (plan.variables->dimension() > mostForCorners) return;
  }
  if (errors.count() == before) checkCorners(study, refuse, *plan.variables, order, errors);
  if (errors.count() == before && !plan.sweeps.empty()) checkCorners(study, refuse, *widest, order, errors);
}

std::vector<std::string> describeTails(const Study& study) {
  const StochasticPlan& plan = *study.stochastic;
  std::vector<std::string> sentences;
  for (int i = 0; i < plan.variables->dimension(); ++i) {
    const probability::Variable& variable = plan.variables->variables()[i];
    const probability::Distribution& distribution = *variable.distribution;
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

}  // namespace harmos::study
