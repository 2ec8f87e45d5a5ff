#include <harmos/study/detail/StudyRunner.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/results/StatusName.hpp>
#include <harmos/study/detail/Interpolation.hpp>

namespace harmos::study {

namespace {

using design::Configuration;
using results::ConfigurationResult;

// A team calibrates its estimates on its own configurations, so it should have some.
constexpr std::size_t usualLeastRange = 10;

/// Passes a solution on; of a further failure only the reason is added to that of the first.
class SecondChance : public results::ResultSink {
 public:
  SecondChance(ConfigurationResult first, std::string what, results::ResultSink& sink)
      : first_(std::move(first)), what_(std::move(what)), sink_(sink) {}

  void record(const ConfigurationResult& result) override {
    isSolved_ = results::isSolved(result.status);
    if (result.status == results::Status::reopened) return sink_.record(result);
    ConfigurationResult sum = isSolved_ ? result : first_;
    sum.reason = isSolved_ ? result.reason + " (" + what_ + ")" : first_.reason + " " + what_ + ": " + result.reason;
    sum.iterations = first_.iterations + result.iterations;
    sum.linearStages = first_.linearStages + result.linearStages;
    sum.cpuSeconds = first_.cpuSeconds + result.cpuSeconds;
    first_ = sum;
    sink_.record(sum);
  }
  bool isSolved() const { return isSolved_; }

 private:
  ConfigurationResult first_;
  std::string what_;
  results::ResultSink& sink_;
  bool isSolved_ = false;
};

bool isTrueOnAny(bool mine, const Teuchos::Comm<int>& comm) {
  const int one = mine ? 1 : 0;
  int any = one;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, one, Teuchos::outArg(any));
  return any != 0;
}

}  // namespace

StudyRunner::StudyRunner(const Study& study, const laws::LawRegistry& laws, StudyTeams& teams, StudyRecorder& recorder,
                         std::function<bool()> interrupted, base::Timers& timers)
    : study_(study),
      laws_(laws),
      teams_(teams),
      recorder_(recorder),
      interrupted_(std::move(interrupted)),
      timers_(timers),
      policy_(study.policy),
      meshErrors_(recorder.results()) {
  for (const auto& alike : groupByOperators(study.parameters, recorder.results().configurations())) {
    open_.emplace_back();
    earlier_.emplace_back();
    for (const Configuration& configuration : alike) {
      if (needsWork(configuration.id)) open_.back().push_back(configuration);
      if (const ConfigurationResult* result = recorder.results().find(configuration.id))
        earlier_.back().push_back({configuration, *result});
    }
  }
}

void StudyRunner::run(std::unique_ptr<StudyGroup> ready) {
  group_ = std::move(ready);
  teams_.setOffice([this](const std::string& report) { recorder_.receive(report); }, [this] { return nextRange(); });
  while (true) {
    const std::optional<WorkRange> range = mustStop() ? std::nullopt : teams_.nextWork();
    if (!range) break;
    solveRange(*range);
  }
  if (study_.isAdaptive()) study_.stochastic ? refineInterpolation() : refine();
  teams_.finish();
}

bool StudyRunner::isStopped() const {
  return isTrueOnAny(isAbortedHere() || (interrupted_ && interrupted_()), *teams_.all());
}

bool StudyRunner::isAborted() const {
  return isTrueOnAny(isAbortedHere(), *teams_.all());
}

bool StudyRunner::isAbortedHere() const {
  return policy_.kind == FailurePolicy::Kind::abort && recorder_.hasFailed();
}

std::optional<WorkRange> StudyRunner::nextRange() {
  if (mustStopHere()) return std::nullopt;
  while (nextOperators_ < open_.size() && nextConfiguration_ == open_[nextOperators_].size()) {
    ++nextOperators_;
    nextConfiguration_ = 0;
  }
  if (nextOperators_ == open_.size()) return std::nullopt;
  const std::size_t left = open_[nextOperators_].size() - nextConfiguration_;
  const auto teams = static_cast<std::size_t>(teams_.count());
  const auto share = [left](std::size_t parts) { return (left + parts - 1) / parts; };
  const std::size_t size = teams == 1 ? left : std::max(share(2 * teams), std::min(usualLeastRange, share(teams)));
  const std::size_t first = nextConfiguration_;
  nextConfiguration_ += size;
  return WorkRange{nextOperators_, first, nextConfiguration_};
}

void StudyRunner::solveRange(const WorkRange& range) {
  const std::size_t operators = range.operators;
  const auto first = open_[operators].begin();
  const std::vector<Configuration> configurations(first + static_cast<std::ptrdiff_t>(range.begin),
                                                  first + static_cast<std::ptrdiff_t>(range.end));
  alike_ = groupByOperators(study_.parameters, recorder_.results().configurations())[operators];
  if (!group_ || groupNumber_ != operators) {
    group_.reset();
    try {
      group_ = std::make_unique<StudyGroup>(study_, configurations, laws_, teams_.team(), timers_);
      groupNumber_ = operators;
      handedOn_.clear();
    } catch (const base::Error& error) {
      if (error.code() != base::ExitCode::input) throw;
      for (const Configuration& configuration : configurations) recordFailure(configuration, error);
      return;
    }
  }
  if (range.begin == 0) handOn(operators);
  solve(configurations);
}

void StudyRunner::handOn(std::size_t operators) {
  // An adaptive design may begin with no configuration.
  if (operators >= earlier_.size() || earlier_[operators].empty()) return;
  handedOn_.clear();
  for (const parametric::EarlierResult& one : earlier_[operators]) {
    if (results::isSolved(one.result.status)) handedOn_.push_back(one.configuration);
  }
  group_->setEarlier(std::exchange(earlier_[operators], {}));
}

void StudyRunner::solve(const std::vector<Configuration>& configurations) {
  group_->setInterrupt([this] { return mustStopHere(); });
  group_->setMeshErrorSample(meshErrors_);
  std::vector<Configuration> open;
  for (const Configuration& configuration : configurations) {
    const ConfigurationResult* result = recorder_.results().find(configuration.id);
    const bool isAgain = result && policy_.kind == FailurePolicy::Kind::abort && mayBeHelped(*result);
    if (!result || result->status == results::Status::reopened || isAgain) open.push_back(configuration);
  }
  try {
    group_->solve(open, recorder_);
  } catch (const base::Error& error) {
    // An operator that cannot be factored, on one rank of the team perhaps: the others wait for it.
    if (teams_.team()->getSize() > 1 && error.code() != base::ExitCode::input) throw;
    if (recorder_.cannotWrite()) throw;
    for (const Configuration& configuration : configurations) {
      const ConfigurationResult* result = recorder_.results().find(configuration.id);
      if (!result || result->status == results::Status::reopened) recordFailure(configuration, error);
    }
    return;
  }
  std::vector<Configuration> touched(configurations);
  touched.insert(touched.end(), handedOn_.begin(), handedOn_.end());  // some may have been taken up again
  for (const Configuration& configuration : touched) {
    const ConfigurationResult* result = recorder_.results().find(configuration.id);
    if (!result || !mayBeHelped(*result)) continue;
    if (mustStop()) return;
    if (policy_.kind == FailurePolicy::Kind::retry) retry(configuration, *result);
    if (policy_.kind == FailurePolicy::Kind::continuation) walkTo(configuration, *result);
  }
}

void StudyRunner::refine() {
  const AdaptiveOptions& options = *study_.design.as<AdaptiveOptions>();
  design::Refinement refinement(study_.plan->axes(), options.refinement,
                                [this](const auto& point) { return study_.plan->complete(point).has_value(); });
  const results::StudyResults& results = recorder_.results();
  const auto& responses = results.description().responses;
  const auto isMeant = [&](const auto& each) { return each.name == options.response; };
  const auto response =
      static_cast<std::size_t>(std::find_if(responses.begin(), responses.end(), isMeant) - responses.begin());
  while (!mustStop()) {
    design::Refinement::Points points;
    std::vector<double> values;
    for (const Configuration& configuration : results.configurations()) {
      auto& point = points.emplace_back();
      for (std::size_t p = 0; p < study_.parameters.size(); ++p) {
        if (study_.parameters[p].formula.empty()) point.push_back(configuration.values[p]);
      }
      const ConfigurationResult* result = results.find(configuration.id);
      const bool isSolved = result && results::isSolved(result->status);
      values.push_back(isSolved ? results.responses(configuration.id)[response]
                                : std::numeric_limits<double>::quiet_NaN());
    }
    const auto batch = refinement.next(points, values, results.description().accuracy);
    recorder_.note(
        "surface of " + responses[response].name,
        {(refinement.isReached() ? "reached: " : "not reached: ") + refinement.summary(), !refinement.isReached()});
    if (batch.empty()) return;
    solveAdded(batch);
  }
}

void StudyRunner::refineInterpolation() {
  while (!mustStop()) {
    const Interpolation interpolation(study_, recorder_.results());
    if (interpolation.wanted().empty()) {
      recorder_.note("interpolation", {interpolation.summary(), !interpolation.isReached()});
      return;
    }
    std::vector<std::vector<double>> points;
    for (const auto& germs : interpolation.wanted()) points.push_back(study_.stochastic->variables->values(germs));
    solveAdded(points);
  }
}

void StudyRunner::solveAdded(const std::vector<std::vector<double>>& points) {
  std::vector<Configuration> added;
  for (const auto& point : points) {
    const int id = static_cast<int>(recorder_.results().configurations().size()) + 1;
    added.push_back({id, *study_.plan->complete(point)});
    recorder_.add(added.back());
  }
  alike_ = recorder_.results().configurations();
  if (!group_) group_ = std::make_unique<StudyGroup>(study_, added, laws_, teams_.team(), timers_);
  handOn(0);  // all share the operators
  solve(added);
}

void StudyRunner::retry(const Configuration& configuration, const ConfigurationResult& result) {
  SecondChance chance(result, "Again from a cold start", recorder_);
  for (int attempt = 0; attempt < policy_.attempts && !chance.isSolved() && !mustStop(); ++attempt) {
    group_->solveAlone(configuration, chance);
  }
}

void StudyRunner::walkTo(const Configuration& configuration, const ConfigurationResult& result) {
  const Configuration* from = nearestSolved(configuration);
  if (!from) return;
  SecondChance chance(result, "Walked to from configuration " + std::to_string(from->id), recorder_);
  for (int steps = 2; steps <= policy_.steps && !chance.isSolved() && !mustStop(); steps *= 2) {
    group_->walk(*from, configuration, steps, chance);
  }
}

/// Null when none is solved. Distances are measured in units of the parameters' ranges.
const Configuration* StudyRunner::nearestSolved(const Configuration& configuration) const {
  const Configuration* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Configuration& other : alike_) {
    const ConfigurationResult* result = recorder_.results().find(other.id);
    if (!result || !results::isSolved(result->status)) continue;
    double square = 0.0;
    for (std::size_t p = 0; p < other.values.size(); ++p) {
      const auto [low, high] = std::minmax_element(
          alike_.begin(), alike_.end(),
          [p](const Configuration& a, const Configuration& b) { return a.values[p] < b.values[p]; });
      const double range = high->values[p] - low->values[p];
      if (range > 0.0) square += std::pow((other.values[p] - configuration.values[p]) / range, 2);
    }
    if (square < least) {
      least = square;
      nearest = &other;
    }
  }
  return nearest;
}

void StudyRunner::recordFailure(const Configuration& configuration, const base::Error& error) {
  ConfigurationResult result;
  result.id = configuration.id;
  result.status = error.code() == base::ExitCode::input ? results::Status::inadmissible : results::Status::failed;
  result.reason = error.what();
  recorder_.record(result);
}

bool StudyRunner::needsWork(int id) const {
  const ConfigurationResult* result = recorder_.results().find(id);
  return !result || result->status == results::Status::reopened || mayBeHelped(*result);
}

bool StudyRunner::mustStopHere() {
  teams_.serve();
  return isAbortedHere() || (interrupted_ && interrupted_());
}

bool StudyRunner::mustStop() {
  return isTrueOnAny(mustStopHere(), *teams_.team());
}

}  // namespace harmos::study
