#include <harmos/study/StochasticPlan.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/design/GermDesign.hpp>
#include <harmos/design/RandomDesign.hpp>
#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/Normal.hpp>

namespace harmos::study {

namespace {

using input::Parameters;
using Names = std::vector<std::string>;
using Method = StochasticPlan::Method;

// Beyond the degree of the polynomials, for parameters that are no polynomials of their germs.
constexpr int pointsForNonlinearGerms = 6;

class Reader {
 public:
  Reader(const Parameters& study, const StudyDesign& design, const std::vector<StudyParameter>& parameters,
         input::ErrorList& errors)
      : study_(study), design_(design), parameters_(parameters), errors_(errors) {}

  std::shared_ptr<const StochasticPlan> read() {
    const int before = errors_.count();
    const bool isReadable = std::all_of(parameters_.begin(), parameters_.end(), [](const StudyParameter& parameter) {
      return !parameter.isRandom || parameter.distribution;
    });
    auto plan = std::make_shared<StochasticPlan>();
    const Names names = readVariables(*plan);
    readMethod(*plan);
    if (!study_.lists("Conditions").empty()) {
      errors_.add(study_.lists("Conditions").front().where(),
                  "conditions would change the distributions of the random parameters.",
                  "Remove them; a Truncated Normal distribution has bounds.");
    }
    plan->correlation = readCorrelations(names);
    readSweeps(names, *plan);
    if (plan->method != Method::chaos && !plan->sweeps.empty()) {
      plan->sweeps.clear();
      plan->remarks.emplace_back("the sweep is left out: only a design of the type Chaos makes one");
    }
    if (errors_.count() > before || !isReadable) return nullptr;
    const auto& correlations = study_.lists("Correlations");
    plan->where = correlations.empty() ? design_.where : correlations.front().where();
    errors_.collect(correlations.empty() ? study_.where() : plan->where, [&] {
      plan->variables = std::make_shared<probability::RandomVector>(variables_, plan->correlation);
    });
    if (!plan->variables) return nullptr;
    errors_.collect(design_.where, [&] { choosePoints(*plan); });
    return errors_.count() > before ? nullptr : plan;
  }

 private:
  Names readVariables(StochasticPlan& plan) {
    Names names;
    for (std::size_t p = 0; p < parameters_.size(); ++p) {
      const StudyParameter& parameter = parameters_[p];
      if (parameter.isRandom) {
        variables_.push_back({parameter.name, parameter.distribution});
        plan.places.push_back(p);
        names.push_back(parameter.name);
      } else if (parameter.formula.empty()) {
        errors_.add(parameter.where, "other parameters are random, but this one is chosen by the design.",
                    "Give it a Distribution or a Formula, or set its entry in Scene Overrides.");
      }
    }
    return names;
  }

  void readMethod(StochasticPlan& plan) {
    if (!study_.hasList("Design")) {
      errors_.add(study_.where(), "random parameters want a Design.",
                  "Give one of the Type Chaos, Collocation, Adaptive Collocation, Random, Latin Hypercube or Sobol.");
      return;
    }
    if (const auto* chaos = design_.as<ChaosOptions>()) {
      plan.method = Method::chaos;
      plan.order = chaos->order;
      plan.points = chaos->points;
    } else if (const auto* collocation = design_.as<CollocationOptions>()) {
      plan.method = Method::collocation;
      plan.order = collocation->order;
      plan.points = collocation->points;
    } else if (design_.as<InterpolationOptions>()) {
      plan.method = Method::adaptive;
    } else if (!design_.as<SamplingOptions>()) {
      errors_.add(design_.where, "a design of the type " + design_.type + " does not know the distributions.",
                  "Take Chaos, Collocation, Adaptive Collocation, Random, Latin Hypercube or Sobol.");
    }
    if (plan.method == Method::adaptive && static_cast<int>(variables_.size()) > mostAdaptiveVariables) {
      errors_.add(design_.where, "it is made for one to three random parameters.", "Take Collocation.");
    }
    if (plan.method == Method::chaos) {
      for (const StudyParameter& parameter : parameters_) {
        if (parameter.effect != Effect::Kind::operators) continue;
        errors_.add(parameter.where, "Chaos varies laws and loads only, but this changes bodies.", "Take Collocation.");
      }
    }
    if (plan.method == Method::chaos || plan.method == Method::adaptive) checkResponse(study_.list("Design"));
  }

  void checkResponse(const Parameters& design) {
    if (!design.has("Response")) return;
    Names known;
    for (const Parameters& response : study_.lists("Responses")) known.push_back(response.name());
    if (std::find(known.begin(), known.end(), design.text("Response")) != known.end()) return;
    errors_.add(design.where("Response"), "the study has no response \"" + design.text("Response") + "\".",
                base::suggestName(design.text("Response"), known, "It has"));
  }

  /// Position among the random parameters; nothing when it is none, which is reported.
  std::optional<std::size_t> find(const std::string& name, const std::string& where, const Names& names) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    errors_.add(where, "there is no random parameter \"" + name + "\".",
                base::suggestName(name, names, "Random parameters"));
    return std::nullopt;
  }

  base::Matrix readCorrelations(const Names& names) {
    const auto& lists = study_.lists("Correlations");
    if (lists.empty()) return {};
    const int dimension = static_cast<int>(names.size());
    base::Matrix correlation(dimension, dimension);
    for (int i = 0; i < dimension; ++i) correlation(i, i) = 1.0;
    for (const Parameters& list : lists) {
      const Names& pair = list.texts("Parameters");
      if (pair.size() != 2 || pair[0] == pair[1]) {
        errors_.add(list.where("Parameters"), "a correlation is between two different parameters.",
                    "Give two names; a list for every pair.");
        continue;
      }
      const auto first = find(pair[0], list.where("Parameters"), names);
      const auto second = find(pair[1], list.where("Parameters"), names);
      if (!first || !second) continue;
      const int i = static_cast<int>(*first), j = static_cast<int>(*second);
      if (correlation(i, j) != 0.0) errors_.add(list.where(), "this pair is correlated already.");
      correlation(i, j) = correlation(j, i) = list.number("Coefficient");
    }
    return correlation;
  }

  void readSweeps(const Names& names, StochasticPlan& plan) {
    for (const Parameters& list : study_.lists("Sweep")) {
      checkStudyName(list, errors_);
      const auto variable = find(list.text("Parameter"), list.where("Parameter"), names);
      if (!variable) continue;
      const probability::Distribution* distribution = variables_[*variable].distribution.get();
      const std::string type = distribution ? distribution->name() : "Normal";
      if (type != std::string("Normal") && type != std::string("Lognormal")) {
        errors_.add(list.where("Parameter"), "the distribution of \"" + names[*variable] + "\" is " + type + ".",
                    "A sweep varies the spread of Normal and Lognormal parameters.");
      }
      const auto& values = list.numbers("Values");
      if (values.empty() || std::any_of(values.begin(), values.end(), [](double v) { return !(v >= 0.0); })) {
        errors_.add(list.where("Values"), "coefficients of variation are numbers of at least 0, one or more.");
      }
      plan.sweeps.push_back({list.name(), *variable, values, list.where("Values")});
    }
  }

  void choosePoints(StochasticPlan& plan) const {
    if (const auto* sampling = design_.as<SamplingOptions>()) {
      plan.germs = design::germsOf(*design_.points, sampling->count, *plan.variables);
    } else if (const auto* collocation = design_.as<CollocationOptions>()) {
      if (collocation->isSparse) {
        plan.quadrature = probability::sparseQuadrature(probability::Basis(plan.variables, plan.order));
      } else {
        const auto counts = gaussPoints(*plan.variables, plan.order, plan.points, false);
        demandFewPoints(counts, "Set Points In to Sparse, or lower the Order.");
        demandPolynomials(plan);
        plan.quadrature = probability::tensorQuadrature(*plan.variables, counts);
      }
      plan.germs = plan.quadrature.points;
      holdOut(collocation->holdOuts, plan);
    } else if (const auto* chaos = design_.as<ChaosOptions>()) {
      demandFewPoints(gaussPoints(*plan.variables, plan.order, plan.points, chaos->wantsGalerkin()),
                      "Take Collocation with Points In set to Sparse, or a lower Order.");
      demandPolynomials(plan);
      holdOut(chaos->holdOuts, plan);
    } else if (const auto* interpolation = design_.as<InterpolationOptions>()) {
      holdOut(interpolation->holdOuts, plan);
    }
  }

  static void holdOut(const HoldOutOptions& options, StochasticPlan& plan) {
    plan.holdOuts = options.count;
    if (options.count == 0) return;
    const design::RandomDesign held(options.count, options.seed);
    for (auto& germ : design::germsOf(held, options.count, *plan.variables)) plan.germs.push_back(std::move(germ));
  }

  /// There are as many orthogonal polynomials of every random parameter as an expansion of the order needs.
  static void demandPolynomials(const StochasticPlan& plan) { probability::Basis(plan.variables, plan.order); }

  static void demandFewPoints(const std::vector<int>& counts, const std::string& repair) {
    double points = 1.0;
    for (const int count : counts) points *= count;
    if (points <= mostTensorPoints) return;
    throw base::Error(
        "the tensor grid has more than " + std::to_string(static_cast<int>(mostTensorPoints)) + " points.\n  " + repair,
        base::ExitCode::input);
  }

  const Parameters& study_;
  const StudyDesign& design_;
  const std::vector<StudyParameter>& parameters_;
  input::ErrorList& errors_;
  std::vector<probability::Variable> variables_;
};

}  // namespace

std::shared_ptr<const StochasticPlan> readStochasticPlan(const Parameters& study, const StudyDesign& design,
                                                         const std::vector<StudyParameter>& parameters,
                                                         input::ErrorList& errors) {
  return Reader(study, design, parameters, errors).read();
}

std::shared_ptr<const probability::RandomVector> withSpread(const StochasticPlan& plan,
                                                            const std::vector<double>& coefficients) {
  std::vector<probability::Variable> variables = plan.variables->variables();
  for (std::size_t s = 0; s < plan.sweeps.size(); ++s) {
    auto& distribution = variables[plan.sweeps[s].variable].distribution;
    const double mean = distribution->mean(), deviation = coefficients[s] * std::abs(mean);
    if (distribution->name() == std::string("Normal")) {
      distribution = std::make_shared<probability::Normal>(mean, deviation);
    } else {
      distribution = std::make_shared<probability::Lognormal>(mean, deviation);
    }
  }
  return std::make_shared<probability::RandomVector>(std::move(variables), plan.correlation);
}

std::vector<int> gaussPoints(const probability::RandomVector& variables, int order, int asked, bool isGalerkin) {
  const auto& all = variables.variables();
  if (asked > 0) return std::vector<int>(all.size(), asked);
  // Joined by a copula, one normal parameter is affine in all germs, and its tail forbids points far out.
  const bool hasNormal = std::any_of(all.begin(), all.end(), [](const probability::Variable& variable) {
    return variable.distribution->name() == std::string("Normal");
  });
  std::vector<int> points;
  for (const probability::Variable& variable : all) {
    const bool isAffine = variables.isIndependent() ? variable.distribution->isAffine() : hasNormal;
    points.push_back(order + 1 + (isGalerkin && !isAffine ? pointsForNonlinearGerms : 0));
  }
  return points;
}

}  // namespace harmos::study
