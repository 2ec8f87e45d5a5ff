#include <harmos/parametric/StudySolver.hpp>

#include <algorithm>
#include <ctime>
#include <limits>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/latin/LoadBalance.hpp>
#include <harmos/parametric/MarchBatch.hpp>
#include <harmos/results/StatusName.hpp>

namespace harmos::parametric {
namespace {

// Changes that were solved for make a better and dearer basis, which pays when stages are to be saved.
constexpr double demanding = 5e-3;
constexpr int neighbours = 8;
constexpr int changesWhenDemanding = 24;
constexpr double mostStates = 100000;

results::Status statusOf(latin::Outcome outcome, bool isUnique) {
  switch (outcome) {
    case latin::Outcome::certified:
      return isUnique ? results::Status::certified : results::Status::certifiedNotUnique;
    case latin::Outcome::noEquilibrium:
      return results::Status::noEquilibrium;
    case latin::Outcome::iterationLimit:
    case latin::Outcome::roundOff:
    case latin::Outcome::interrupted:
      break;
  }
  return results::Status::notConverged;
}

int statesThatFit(const latin::TraceLayout& layout, int steps) {
  const double one = SolvedStates::bytesOf(layout.rows(), steps);
  const int here = static_cast<int>(std::min(StudySolver::memoryForStates / std::max(one, 1.0), mostStates));
  int everywhere = here;
  Teuchos::reduceAll(layout.comm(), Teuchos::REDUCE_MIN, here, Teuchos::outArg(everywhere));
  return std::max(everywhere, 1);
}

/// Laws are replaced from one configuration to the next: springs of boundaries may change.
latin::LatinOptions forReplacedLaws(latin::LatinOptions options) {
  if (options.stages.elimination == latin::Elimination::affine) {
    options.stages.elimination = latin::Elimination::rigid;
  }
  // States of other configurations are starts only while search directions and reference motions are theirs.
  options.restarts = 0;
  options.recentres = false;
  return options;
}

}  // namespace

StudySolver::StudySolver(assembly::Assembly& assembly, Install install,
                         std::vector<std::shared_ptr<const latin::Response>> responses,
                         const latin::LatinOptions& options, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                         base::Timers& timers)
    : assembly_(assembly),
      install_(std::move(install)),
      responses_(std::move(responses)),
      given_(options),
      options_(forReplacedLaws(options)),
      comm_(comm),
      timers_(timers),
      solver_(assembly, options_, comm, timers),
      fixedPoint_(solver_.fixedPoint()),
      stepSolver_(fixedPoint_,
                  options.stages.solver.invertTrace ? substructure::Precision::single : substructure::Precision::exact),
      states_(statesThatFit(fixedPoint_.layout(), assembly.steps())),
      lacking_(static_cast<int>(mostStates)) {
  for (const auto& response : responses_) solver_.addResponse(response);
  addPlace();
}

void StudySolver::addPlace() {
  const bool isDemanding = options_.accuracy < demanding;
  const ConfigurationIteration::Remembered remembered{neighbours, isDemanding ? changesWhenDemanding : 0,
                                                      options_.memory};
  auto iteration = std::make_unique<ConfigurationIteration>(fixedPoint_, stepSolver_, responses_, remembered,
                                                            options_.accuracy, timers_);
  iteration->setStop([this] { return mustStop(); });
  places_.push_back({std::move(iteration), {}});
}

void StudySolver::putLaws(const Place& place) {
  for (std::size_t i = 0; i < place.laws.size(); ++i) assembly_.interfaces[i].law = place.laws[i];
}

void StudySolver::keep(int place) {
  while (static_cast<int>(places_.size()) <= place) addPlace();
  Laws& laws = places_[place].laws;
  laws.clear();
  for (const assembly::Interface& interface : assembly_.interfaces) laws.push_back(interface.law);
  present_ = place;
}

void StudySolver::present(int place) {
  if (present_ == place) return;
  present_ = place;
  putLaws(places_[place]);
  fixedPoint_.updateLaws();
  stepSolver_.updateLoads();
}

std::vector<StudySolver::Marched> StudySolver::march(const std::vector<int>& places) {
  present(places.front());  // loads of one that does not march may be no numbers
  std::vector<MarchBatch::Member> members;
  for (const int place : places) {
    members.push_back({places_[place].iteration.get(), [this, place] { putLaws(places_[place]); }});
  }
  MarchBatch(fixedPoint_, stepSolver_).run(members, [this] { return mustStop(); });
  putLaws(places_[present_]);
  std::vector<Marched> marched;
  for (MarchBatch::Member& member : members) marched.push_back({member.waits, std::move(member.error)});
  return marched;
}

bool StudySolver::install(const design::Configuration& configuration, results::ConfigurationResult& result) {
  result = {};
  result.id = configuration.id;
  result.errorEstimate = std::numeric_limits<double>::quiet_NaN();
  try {
    install_(configuration.values);
  } catch (const base::Error& error) {
    putLaws(places_[present_]);  // some may have been replaced
    result.status = results::Status::inadmissible;
    result.reason = error.what();
    return false;
  }
  fixedPoint_.updateLaws();
  return true;
}

void StudySolver::widen(const std::vector<double>& values) {
  states_.widen(values);
  lacking_.widen(values);
}

bool StudySolver::lacksEquilibrium(const design::Configuration& configuration, results::ConfigurationResult& result) {
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  if (assembly.path) return false;  // loads that are found have no balance before
  latin::LoadBalance balance(assembly, fixedPoint_.layout().comm(), timers_);
  // The last ones first: they have most to bear.
  for (int t = assembly.steps() - 1; t >= 0; --t) {
    const std::optional<std::string>& contradiction = balance.contradiction(t);
    if (!contradiction) continue;
    result.status = results::Status::noEquilibrium;
    result.reason = *contradiction;
    lacking_.add(configuration.id, configuration.values, {}, {});
    return true;
  }
  return false;
}

bool StudySolver::isNearLack(const design::Configuration& configuration) const {
  return lacking_.distance(configuration.values) < states_.distance(configuration.values);
}

bool StudySolver::certify(const base::Matrix* start, results::ConfigurationResult& result, double share) {
  solver_.setAccuracy(share * options_.accuracy);
  return take(solver_.solve(start), result);
}

bool StudySolver::take(const latin::LatinResult& solution, results::ConfigurationResult& result) {
  result.reason = solution.reason;
  bool isUnique = solution.freePressures.empty();
  for (const auto& response : solution.responses) {
    if (response.range.width() > options_.accuracy * response.size) isUnique = false;
  }
  for (const std::string& remark : solution.remarks) result.reason += "; " + remark;
  result.status = statusOf(solution.outcome, isUnique);
  result.iterations += solution.iterations;
  result.linearStages += solution.linearStages;
  result.errorEstimate = solution.errorEstimate;
  result.curves.clear();
  result.curveErrors.clear();
  for (const auto& response : solution.responses) {
    result.curves.push_back(response.values);
    result.curveErrors.push_back(response.errorEstimate);
  }
  if (results::isCertified(result.status)) ++summary_.certificates;
  return solution.outcome != latin::Outcome::interrupted;
}

bool StudySolver::certifyAnew(const design::Configuration& configuration, results::ConfigurationResult& result) {
  try {
    result.starts.clear();
    if (lacksEquilibrium(configuration, result)) return true;
    if (!certify(nullptr, result)) return false;
    if (results::isCertified(result.status)) rememberCertified(configuration, result);
    const bool mayGoFurther = given_.restarts > options_.restarts || given_.recentres;
    if (result.status == results::Status::notConverged && mayGoFurther) return certifyAlone(configuration, result);
  } catch (const base::Error& error) {
    result.status = results::Status::failed;
    result.reason = error.what();
  }
  return true;
}

bool StudySolver::certifyAlone(const design::Configuration& configuration, results::ConfigurationResult& result) {
  latin::LatinSolver alone(assembly_, given_, comm_, timers_);
  for (const auto& response : responses_) alone.addResponse(response);
  alone.setInterrupt(interrupted_);
  if (!take(alone.solve(), result)) return false;
  if (results::isCertified(result.status) && observer_) observer_(configuration, alone.fixedPoint(), alone.state());
  return true;
}

void StudySolver::observe(const design::Configuration& configuration, const latin::Iterate& state) {
  if (observer_) observer_(configuration, fixedPoint_, state);
}

void StudySolver::remember(const design::Configuration& configuration) {
  states_.add(configuration.id, configuration.values, iteration().alpha(), iteration().linear(), iteration().forces());
  observe(configuration, iteration().state());
}

void StudySolver::rememberCertified(const design::Configuration& configuration, results::ConfigurationResult& result) {
  if (options_.stages.formulation == latin::Formulation::displacement) {
    iteration().beginAt(solver_.alpha());
    result.linearStages += iteration().stages();
    remember(configuration);
    return;
  }
  // Its images are of no use to others.
  const base::Matrix none(solver_.alpha().numRows(), solver_.alpha().numCols());
  states_.add(configuration.id, configuration.values, solver_.alpha(), none);
  observe(configuration, certifiedState());
}

double cpuSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace harmos::parametric
