#include <harmos/study/detail/ChaosStudy.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/latin/LatinOptions.hpp>
#include <harmos/laws/FaceLaw.hpp>
#include <harmos/laws/FieldLaw.hpp>
#include <harmos/laws/TurnedLaw.hpp>
#include <harmos/scene/TurnedPlaces.hpp>
#include <harmos/study/StochasticTails.hpp>

namespace harmos::study {

namespace {

// Responses that are no polynomials, such as maxima over nodes, are projected with more points than the fields; a
// sample costs no solve.
constexpr int pointsBeyondTheOrder = 5;

std::vector<double> meanValues(const Study& study) {
  std::vector<double> point;
  for (const probability::Variable& variable : study.stochastic->variables->variables()) {
    point.push_back(variable.distribution->mean());
  }
  return *study.plan->complete(point);
}

/// Whose laws change with the parameters of the study, by interface. What joins the pieces of a cut part has no law in
/// the scene and is never random.
std::vector<bool> randomInterfaces(const Study& study, const scene::Scene& scene, const assembly::Assembly& assembly) {
  std::vector<bool> isRandom;
  for (const assembly::Interface& interface : assembly.interfaces) {
    isRandom.push_back(scene.laws.count(interface.name) > 0 && changeLawOf(study.parameters, interface.name));
  }
  return isRandom;
}

/// Only what is linear, or read from fields of interfaces, has an expansion.
void demandExpansions(const scene::Problem& problem) {
  for (const auto& response : problem.responses) {
    if (response->isLinear() || dynamic_cast<const latin::PairResponse*>(response.get())) continue;
    throw base::Error("The response " + base::quoted(response->name()) +
                          " is neither linear nor one of interfaces: it has no expansion.\n"
                          "  Remove it from the scene, or choose the design Collocation.",
                      base::ExitCode::input);
  }
}

}  // namespace

ChaosStudy::ChaosStudy(const Study& study, const laws::LawRegistry& laws, Teuchos::RCP<const Teuchos::Comm<int>> comm,
                       base::Timers& timers)
    : study_(study),
      options_(*study.design.as<ChaosOptions>()),
      laws_(laws),
      comm_(std::move(comm)),
      timers_(timers),
      scene_(study.sceneFor(meanValues(study), laws)),
      problem_(scene::makeProblem(scene_, *comm_, timers)),
      isRandom_(randomInterfaces(study, scene_, problem_.assembly)),
      choice_(chooseLocalStage(study, problem_, *comm_)),
      isGalerkin_(choice_.cost.isGalerkin) {
  demandExpansions(problem_);
  input::ErrorList errors;
  if (demandsPlaces()) checkTails(study, laws, demandOfPlaces(), errors);
  errors.throwIfAny();
  demandMemory(study, choice_, *comm_);
}

latin::Outcome ChaosStudy::solve() {
  const latin::Outcome outcome = options_.tolerance ? raiseOrder() : (start(options_.order), run(nullptr));
  if (outcome != latin::Outcome::certified || study_.stochastic->sweeps.empty()) return outcome;
  return sweep();
}

void ChaosStudy::start(int order) {
  const probability::RandomVector& variables = *study_.stochastic->variables;
  const auto counts = gaussPoints(variables, order, options_.points, isGalerkin_);
  projection_ = std::make_shared<stochastic::Projection>(
      std::make_shared<probability::Basis>(study_.stochastic->variables, order),
      probability::tensorQuadrature(variables, counts));
  const latin::LatinOptions& latinOptions = scene_.solver;
  stochastic::StochasticOptions options;
  options.method = isGalerkin_ ? stochastic::Method::galerkin : stochastic::Method::pseudoSpectral;
  options.accuracy = latinOptions.accuracy;
  options.maximumIterations = latinOptions.maximumIterations;
  options.memory = latinOptions.memory;
  options.stages = latinOptions.stages;
  solver_ = std::make_unique<stochastic::StochasticSolver>(problem_.assembly, projection_, options, comm_, timers_);
  for (const auto& response : problem_.responses) solver_->addResponse(response);
  if (interrupted_) solver_->setInterrupt(interrupted_);
  solver_->setLaws(realise(variables));
}

latin::Outcome ChaosStudy::run(const base::Matrix* start) {
  result_ = solver_->solve(start);
  columns_ += result_.columns;
  reason_ = result_.reason;
  if (result_.outcome == latin::Outcome::certified) expansions_ = expansions();
  return result_.outcome;
}

stochastic::Realisations ChaosStudy::realise(const probability::RandomVector& variables) const {
  stochastic::Realisations laws;
  for (const auto& germs : projection_->quadrature().points) {
    const scene::Scene scene = study_.sceneFor(*study_.plan->complete(variables.values(germs)), laws_);
    auto& row = laws.emplace_back();
    for (std::size_t i = 0; i < isRandom_.size(); ++i) {
      const assembly::Interface& interface = problem_.assembly.interfaces[i];
      row.push_back(isRandom_[i] ? laws::inPlaceOf(*interface.law, scene.laws.at(interface.name)) : interface.law);
    }
  }
  return laws;
}

bool ChaosStudy::demandsPlaces() const {
  const auto& interfaces = problem_.assembly.interfaces;
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    if (isRandom_[i] && laws::roleOf<laws::TurnedLaw>(*interfaces[i].law) != nullptr) return true;
  }
  return false;
}

Demand ChaosStudy::demandOfPlaces() const {
  return [this](const scene::Scene& scene) { scene::demandPlaces(problem_.assembly, scene.laws); };
}

latin::Outcome ChaosStudy::raiseOrder() {
  const int largest = options_.order;
  const double tolerance = *options_.tolerance;
  const auto isAsked = [&](std::size_t r) {
    return !options_.response || *options_.response == study_.responses[r].name;
  };
  for (int order = 1; order <= largest; ++order) {
    if (order > 2 && !admits(order)) {
      reason_ = "the standard deviations still change by more than the tolerance at order " +
                std::to_string(order - 1) + ", and the next order needs values that the scene refuses";
      return latin::Outcome::iterationLimit;
    }
    start(order);
    const latin::Outcome outcome = run(nullptr);
    if (outcome != latin::Outcome::certified) return outcome;
    orders_.push_back(momentsAt(order));
    if (order == 1) continue;
    const auto &before = orders_[orders_.size() - 2].deviations, &now = orders_.back().deviations;
    double largestChange = 0.0;
    for (std::size_t r = 0; r < now.size(); ++r) {
      if (isAsked(r) && now[r] > 0.0) largestChange = std::max(largestChange, std::abs(now[r] - before[r]) / now[r]);
    }
    if (observer_) {
      std::ostringstream text;
      text << "order " << order << ": standard deviations changed by " << std::setprecision(2) << largestChange;
      observer_(text.str());
    }
    if (largestChange <= tolerance) return outcome;
  }
  std::ostringstream text;
  text << "the standard deviations still change by more than the tolerance " << tolerance << " at order " << largest;
  reason_ = text.str();
  return latin::Outcome::iterationLimit;
}

bool ChaosStudy::admits(int order) const {
  input::ErrorList errors;
  checkTails(study_, laws_, order, demandOfPlaces(), errors);
  return errors.count() == 0;
}

latin::Outcome ChaosStudy::sweep() {
  const StochasticPlan& plan = *study_.stochastic;
  const std::vector<probability::Expansion> own = expansions_;
  base::Matrix start = solver_->alpha();
  const base::Matrix first = start;
  std::vector<std::size_t> at(plan.sweeps.size(), 0);
  latin::Outcome outcome = latin::Outcome::certified;
  while (true) {
    std::vector<double> coefficients;
    for (std::size_t s = 0; s < at.size(); ++s) coefficients.push_back(plan.sweeps[s].coefficients[at[s]]);
    solver_->setLaws(realise(*withSpread(plan, coefficients)));
    outcome = run(&start);
    start = solver_->alpha();
    if (outcome != latin::Outcome::certified) break;
    const auto moments = momentsAt(basis().order());
    points_.push_back({coefficients, moments.means, moments.deviations});
    std::size_t s = at.size();
    while (s > 0 && ++at[s - 1] == plan.sweeps[s - 1].coefficients.size()) at[--s] = 0;
    if (s == 0) break;
  }
  // The fields and samples are those of the study's own distributions.
  const std::string reason = reason_;
  solver_->setLaws(realise(*plan.variables));
  const latin::Outcome last = run(&first);
  if (outcome == latin::Outcome::certified) {
    outcome = last;
  } else {
    reason_ = "the sweep ended early: " + reason;
  }
  expansions_ = own;
  return outcome;
}

std::vector<std::vector<double>> ChaosStudy::sample(const std::vector<std::vector<double>>& germs) const {
  const auto sampler = solver_->sampler();
  std::vector<base::Matrix> curves;  // of the scene's responses: load steps x points
  for (std::size_t c = 0; c < problem_.responses.size(); ++c) {
    curves.push_back(sampler.sample(static_cast<int>(c), germs));
  }
  std::vector<std::vector<double>> values;
  for (const results::ScalarResponse& response : study_.responses) {
    const base::Matrix& curve = curves[response.curve];
    auto& row = values.emplace_back();
    for (int point = 0; point < curve.numCols(); ++point) {
      row.push_back(response.evaluate(scene_.times, {curve[point], curve[point] + curve.numRows()}));
    }
  }
  return values;
}

std::vector<probability::Expansion> ChaosStudy::expansions() const {
  const probability::RandomVector& variables = *study_.stochastic->variables;
  const int count = projection_->basis()->order() + pointsBeyondTheOrder;
  const bool isFine = std::pow(count, variables.dimension()) <= probability::mostPointsWithoutSolves;
  const probability::Quadrature quadrature =
      isFine ? probability::tensorQuadrature(variables, count) : projection_->quadrature();
  std::vector<probability::Expansion> expansions;
  for (const auto& values : sample(quadrature.points)) {
    expansions.push_back(probability::project(projection_->basis(), quadrature, values));
  }
  return expansions;
}

results::StochasticSummary::Order ChaosStudy::momentsAt(int order) const {
  results::StochasticSummary::Order moments;
  moments.order = order;
  for (const probability::Expansion& expansion : expansions_) {
    moments.means.push_back(expansion.mean());
    moments.deviations.push_back(expansion.standardDeviation());
  }
  return moments;
}

void ChaosStudy::summarise(results::StochasticSummary& summary) const {
  summary.convergence = orders_;
  for (const auto& sweep : study_.stochastic->sweeps) summary.sweepNames.push_back(sweep.name);
  summary.sweep = points_;
  for (std::size_t r = 0; r < expansions_.size(); ++r) {
    results::ResponseStatistics& response = summary.responses[r];
    response.expansion = std::make_shared<probability::Expansion>(expansions_[r]);
    const double error = result_.responses[study_.responses[r].curve].errorEstimate;
    response.meanError = error * std::abs(expansions_[r].mean());
    response.deviationError = error * std::max(expansions_[r].standardDeviation(),
                                               stochastic::smallestSpread * std::abs(expansions_[r].mean()));
    response.iterationError = std::max(response.meanError, response.deviationError);
  }
}

}  // namespace harmos::study
