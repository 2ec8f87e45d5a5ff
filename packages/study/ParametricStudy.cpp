#include <harmos/study/ParametricStudy.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numeric>
#include <random>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::study {
namespace {

constexpr int fewConfigurations = 10;
constexpr int auditEvery = 100;
constexpr int attemptsToCalibrate = 10;
// More neighbours make a better and dearer start, which pays when stages are to be saved.
constexpr double demanding = 5e-3;
constexpr int neighbours = 12;
constexpr int neighboursWhenDemanding = 24;
// An iteration that needs more than this many times the median number of stages has lost its way.
constexpr int patience = 4;
constexpr int leastLimit = 20;
constexpr int coldLimit = 150;
// A tight stop: indicators below these shares of the accuracy, and changes of what is promised over the last stages.
constexpr double tightForce = 0.01;
constexpr double tightResponse = 0.05;
constexpr double tightChange = 0.03;
constexpr std::size_t tightStages = 4;
constexpr int tightLimit = 80;
constexpr std::size_t memoryForStates = std::size_t{1} << 30;  // byte, all ranks alike

double cpuSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Status statusOf(latin::Outcome outcome) {
  switch (outcome) {
    case latin::Outcome::certified:
      return Status::certified;
    case latin::Outcome::noEquilibrium:
      return Status::noEquilibrium;
    case latin::Outcome::iterationLimit:
    case latin::Outcome::interrupted:
      break;
  }
  return Status::notConverged;
}

/// Calibrations that a study should have after so many configurations: numbers 1, 2, 4, 8 and 16 are.
int calibrationsUntil(int number) {
  int count = 0;
  for (int next = 1; next <= std::min(number, 16); next *= 2) ++count;
  return count;
}

/// The same on every rank, in every run and on every machine.
std::vector<std::size_t> randomOrder(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 generator(20040601);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[generator() % i]);
  return order;
}

int statesThatFit(const latin::TraceLayout& layout, int steps) {
  const std::size_t one = 2 * sizeof(float) * static_cast<std::size_t>(layout.rows()) * static_cast<std::size_t>(steps);
  const int here = static_cast<int>(std::min<std::size_t>(memoryForStates / one, 100000));
  int everywhere = here;
  Teuchos::reduceAll(layout.comm(), Teuchos::REDUCE_MIN, here, Teuchos::outArg(everywhere));
  return std::max(everywhere, 1);
}

/// Largest relative difference of responses, and of the field of forces.
std::pair<double, double> errorsAgainst(const latin::Snapshot& reference, const latin::Snapshot& state) {
  const std::vector<double> distance = reference.distance(state);
  const auto fields = distance.end() - 2;
  return {fields == distance.begin() ? 0.0 : *std::max_element(distance.begin(), fields), *fields};
}

}  // namespace

ParametricStudy::ParametricStudy(interface::Assembly& assembly, Install install,
                                 std::vector<std::shared_ptr<const latin::Response>> responses,
                                 const latin::LatinOptions& options, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                                 base::Timers& timers)
    : install_(std::move(install)),
      responses_(std::move(responses)),
      options_(options),
      solver_(assembly, options, comm, timers),
      fixedPoint_(solver_.fixedPoint()),
      iteration_(fixedPoint_, responses_, options.accuracy < demanding ? neighboursWhenDemanding : neighbours,
                 options.memory, timers),
      calibration_(options.accuracy),
      states_(statesThatFit(fixedPoint_.layout(), assembly.steps())) {
  for (const auto& response : responses_) solver_.addResponse(response);
}

void ParametricStudy::setInterrupt(std::function<bool()> interrupted) {
  solver_.setInterrupt(std::move(interrupted));
}

int ParametricStudy::stageLimit() const {
  if (stagesOfAccepted_.empty()) return coldLimit;
  std::vector<int> stages = stagesOfAccepted_;
  const auto middle = stages.begin() + static_cast<std::ptrdiff_t>(stages.size() / 2);
  std::nth_element(stages.begin(), middle, stages.end());
  return std::max(leastLimit, patience * *middle);
}

void ParametricStudy::estimate(const Indicators& indicators, ConfigurationResult& result) const {
  Indicators ofResponses = indicators;
  ofResponses.force = 0.0;
  result.errorEstimate = calibration_.estimate(indicators);
  result.curveErrors.assign(responses_.size(), calibration_.estimate(ofResponses));
}

void ParametricStudy::deliver(const Indicators& indicators, ConfigurationResult& result) const {
  result.status = Status::calibrated;
  result.reason = "the calibrated error estimate is below the accuracy asked for";
  result.curves.clear();
  for (const auto& response : responses_) result.curves.push_back(response->evaluate(fixedPoint_));
  estimate(indicators, result);
}

void ParametricStudy::remember(const Configuration& configuration) {
  states_.add(configuration.id, configuration.values, iteration_.alpha(), iteration_.linear());
}

void ParametricStudy::observe() {
  way_.push_back(indicators_);
  snapshots_.push_back(std::make_unique<latin::Snapshot>(fixedPoint_, responses_));
}

bool ParametricStudy::certify(const base::Matrix* start, ConfigurationResult& result) {
  const latin::LatinResult solution = solver_.solve(start);
  result.status = statusOf(solution.outcome);
  result.reason = solution.reason;
  result.iterations += solution.iterations;
  result.linearStages += solution.linearStages;
  result.errorEstimate = solution.errorEstimate;
  result.curves.clear();
  result.curveErrors.clear();
  for (const auto& response : solution.responses) {
    result.curves.push_back(response.values);
    result.curveErrors.push_back(response.errorEstimate);
  }
  if (result.status == Status::certified) ++summary_.certificates;
  return solution.outcome != latin::Outcome::interrupted;
}

bool ParametricStudy::tighten(Purpose purpose, ConfigurationResult& result) {
  const std::size_t claimed = snapshots_.size() - 1;
  for (int stage = 0; stage < tightLimit; ++stage) {
    const std::size_t n = snapshots_.size();
    if (n > tightStages && indicators_.force <= tightForce * options_.accuracy &&
        indicators_.response <= tightResponse * options_.accuracy) {
      const auto [response, force] = errorsAgainst(*snapshots_[n - 1], *snapshots_[n - 1 - tightStages]);
      if (std::max(response, force) <= tightChange * options_.accuracy) {
        std::vector<Calibration::Observation> run;
        for (std::size_t i = 0; i + 1 < n; ++i) {
          const auto [responseError, forceError] = errorsAgainst(*snapshots_[n - 1], *snapshots_[i]);
          run.push_back({way_[i], forceError, responseError});
        }
        if (purpose == Purpose::audit) {
          const auto [responseError, forceError] = errorsAgainst(*snapshots_[n - 1], *snapshots_[claimed]);
          const double error = std::max(responseError, forceError) / options_.accuracy;
          ++summary_.audits;
          if (error > 1.0) ++summary_.falseClaims;
          summary_.largestAudit = std::max(summary_.largestAudit, error);
        } else {
          ++summary_.calibrations;
        }
        if (calibration_.add(run)) ratioFell_ = true;
        return true;
      }
    }
    if (solver_.mustStop()) return false;
    indicators_ = iteration_.iterate();
    ++result.iterations;
    observe();
  }
  return true;
}

bool ParametricStudy::iterate(const Configuration& configuration, Purpose purpose, const SolvedStates& states,
                              ConfigurationResult& result) {
  way_.clear();
  snapshots_.clear();
  iteration_.begin(states, configuration.values);
  result.starts = iteration_.starts();
  const int limit = result.starts.empty() ? coldLimit : stageLimit();
  bool isAccepted = false;
  while (!isAccepted && iteration_.stages() < limit) {
    if (solver_.mustStop()) return false;
    indicators_ = iteration_.iterate();
    ++result.iterations;
    if (purpose != Purpose::result) observe();
    isAccepted = purpose == Purpose::calibration || calibration_.accepts(indicators_);
  }
  if (isAccepted && purpose == Purpose::result && !result.starts.empty())
    stagesOfAccepted_.push_back(iteration_.stages());
  const int before = summary_.calibrations + summary_.audits;
  if (isAccepted && purpose != Purpose::result && !tighten(purpose, result)) return false;
  result.linearStages += iteration_.stages();
  const bool isTight = summary_.calibrations + summary_.audits > before;
  if (isAccepted && !isTight && purpose == Purpose::audit) ++summary_.openAudits;
  if (isAccepted && (isTight || calibration_.accepts(indicators_))) {
    if (isTight && summary_.certificates == 0 && purpose == Purpose::calibration) {
      if (!confirm(result)) return false;
      if (isContradicted_) {
        result.status = Status::notConverged;
        return true;
      }
    }
    const bool isCertified = result.status == Status::certified;
    deliver(indicators_, result);
    if (isCertified) {
      result.status = Status::certified;
      result.reason = "the error estimate of a certificate is below the accuracy asked for";
    }
    if (observer_) observer_(configuration, fixedPoint_);
    remember(configuration);
    accepted_[configuration.id] = {configuration, result, indicators_};
    return true;
  }
  result.status = Status::notConverged;
  return true;
}

ParametricStudy::Purpose ParametricStudy::purposeOfNext() {
  ++number_;
  if (calibration_.runs() < calibrationsUntil(number_) && attempts_ < attemptsToCalibrate) {
    ++attempts_;
    return Purpose::calibration;
  }
  return number_ % auditEvery == auditEvery / 2 ? Purpose::audit : Purpose::result;
}

bool ParametricStudy::confirm(ConfigurationResult& result) {
  const base::Matrix tight(iteration_.alpha());
  const latin::Snapshot claimed(fixedPoint_, responses_);
  if (!certify(&tight, result)) return false;
  const latin::Snapshot certified(fixedPoint_, responses_);
  const auto [responseError, forceError] = errorsAgainst(certified, claimed);
  isContradicted_ = result.status == Status::certified && std::max(responseError, forceError) > options_.accuracy;
  iteration_.beginAt(tight);
  indicators_ = iteration_.iterate();
  result.linearStages += iteration_.stages();
  return true;
}

bool ParametricStudy::solve(const Configuration& configuration, bool isNew, ResultSink& sink) {
  const double begin = cpuSeconds();
  ConfigurationResult result;
  result.id = configuration.id;
  result.errorEstimate = std::numeric_limits<double>::quiet_NaN();
  // What a configuration that is taken up again has cost before counts as well.
  double secondsBefore = 0.0;
  if (const auto before = accepted_.find(configuration.id); before != accepted_.end()) {
    result.iterations = before->second.result.iterations;
    result.linearStages = before->second.result.linearStages;
    secondsBefore = before->second.result.cpuSeconds;
  }
  const auto report = [&] {
    result.cpuSeconds = secondsBefore + cpuSeconds() - begin;
    const auto accepted = accepted_.find(result.id);
    if (accepted != accepted_.end()) accepted->second.result = result;
    sink.record(result);
  };
  try {
    install_(configuration.values);
  } catch (const base::Error& error) {
    result.status = Status::inadmissible;
    result.reason = error.what();
    report();
    return true;
  }
  accepted_.erase(configuration.id);
  fixedPoint_.updateLaws();
  const Purpose purpose = isNew ? purposeOfNext() : Purpose::result;
  try {
    if (!iterate(configuration, purpose, states_, result)) return false;
    if (result.status == Status::notConverged && !result.starts.empty() && !isContradicted_) {
      if (!iterate(configuration, purpose, SolvedStates(1), result)) return false;
    }
  } catch (const base::Error& error) {
    result.status = Status::failed;
    result.reason = error.what();
  }
  if (result.status == Status::calibrated || result.status == Status::certified) {
    report();
    return true;
  }
  // Without anything that may mislead.
  try {
    result.starts.clear();
    if (!certify(nullptr, result)) return false;
    if (result.status == Status::certified) {
      iteration_.beginAt(solver_.alpha());
      indicators_ = iteration_.iterate();
      result.linearStages += iteration_.stages();
      remember(configuration);
      if (observer_) observer_(configuration, fixedPoint_);
    }
  } catch (const base::Error& error) {
    result.status = Status::failed;
    result.reason = error.what();
  }
  report();
  return true;
}

bool ParametricStudy::reopen(ResultSink& sink) {
  while (ratioFell_) {
    ratioFell_ = false;
    std::vector<Configuration> again;
    for (auto& [id, one] : accepted_) {
      if (calibration_.accepts(one.indicators)) {
        estimate(one.indicators, one.result);
        sink.record(one.result);
      } else {
        again.push_back(one.configuration);
      }
    }
    for (const Configuration& configuration : again) {
      ++summary_.reopened;
      if (!solve(configuration, false, sink)) return false;
    }
  }
  return true;
}

void ParametricStudy::certifyEach(const std::vector<Configuration>& open, ResultSink& sink) {
  const bool storesStates = options_.stages.formulation == latin::Formulation::displacement;
  base::Matrix start(fixedPoint_.layout().rows(), fixedPoint_.assembly().steps()), unused(start);
  for (const Configuration& configuration : open) {
    const double begin = cpuSeconds();
    ConfigurationResult result;
    result.id = configuration.id;
    result.errorEstimate = std::numeric_limits<double>::quiet_NaN();
    try {
      install_(configuration.values);
    } catch (const base::Error& error) {
      result.status = Status::inadmissible;
      result.reason = error.what();
      sink.record(result);
      continue;
    }
    fixedPoint_.updateLaws();
    const std::vector<int> nearest = states_.nearest(configuration.values, 1);
    for (const bool isWarm : {true, false}) {
      if (isWarm && nearest.empty()) continue;
      try {
        result.starts.clear();
        if (isWarm) {
          result.starts.push_back(states_.id(nearest[0]));
          states_.copy(nearest[0], start, unused);
        }
        if (!certify(isWarm ? &start : nullptr, result)) return;
      } catch (const base::Error& error) {
        result.status = Status::failed;
        result.reason = error.what();
      }
      if (result.status == Status::certified) break;
    }
    if (result.status == Status::certified) {
      base::Matrix linear(start.numRows(), start.numCols());
      if (storesStates) {
        iteration_.beginAt(solver_.alpha());
        iteration_.iterate();
        result.linearStages += iteration_.stages();
        linear = iteration_.linear();
      }
      states_.add(configuration.id, configuration.values, solver_.alpha(), linear);
      if (observer_) observer_(configuration, fixedPoint_);
    }
    result.cpuSeconds = cpuSeconds() - begin;
    sink.record(result);
  }
}

void ParametricStudy::run(const std::vector<Configuration>& open, ResultSink& sink) {
  for (const Configuration& configuration : open) states_.widen(configuration.values);
  if (static_cast<int>(open.size()) + states_.count() < fewConfigurations ||
      options_.stages.formulation == latin::Formulation::velocity ||
      options_.algorithm != latin::Algorithm::accelerated) {
    certifyEach(open, sink);
    return;
  }
  std::vector<Configuration> left;
  for (const std::size_t position : randomOrder(open.size())) {
    if (isContradicted_) {
      left.push_back(open[position]);
      continue;
    }
    if (!solve(open[position], true, sink) || !reopen(sink)) return;
    summary_.forceRatio = calibration_.forceRatio();
    summary_.responseRatio = calibration_.responseRatio();
    summary_.falseClaimBound = falseClaimBound(summary_.audits, summary_.falseClaims);
  }
  certifyEach(left, sink);
}

}  // namespace harmos::study
