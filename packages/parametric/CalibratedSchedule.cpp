#include <harmos/parametric/CalibratedSchedule.hpp>

#include <algorithm>
#include <numeric>
#include <random>

#include <harmos/base/Error.hpp>
#include <harmos/results/StatusName.hpp>

namespace harmos::parametric {
namespace {

constexpr int auditEvery = 100;
constexpr int attemptsToCalibrate = 10;
// An iteration that needs more than this many times the median number of stages has lost its way.
constexpr int stagesOverMedian = 4;
constexpr int leastLimit = 20;
constexpr int coldLimit = 150;
// A march that has met its target ends a little above or below it; one that was not enough goes so much further.
constexpr double further = 0.7;
// A tight stop: indicators below these shares of the accuracy, and change of what is promised by a march so much
// further.
constexpr double rung = 0.3;
constexpr double tightForce = 0.01;
constexpr double tightResponse = 0.05;
constexpr double tightChange = 0.03;
// An audit may end before, with an estimate below this share of the accuracy, which is added to the error that it
// finds.
constexpr double referenceShare = 0.2;
constexpr int tightLimit = 100;

constexpr int lastCalibration = 16;
constexpr unsigned seedOfOrder = 20040601;

/// Calibrations that a study should have after so many configurations: numbers 1, 2, 4, 8 and 16 are.
int calibrationsUntil(int number) {
  int count = 0;
  for (int next = 1; next <= std::min(number, lastCalibration); next *= 2) ++count;
  return count;
}

/// The same on every rank, in every run and on every machine.
std::vector<std::size_t> randomOrder(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 generator(seedOfOrder);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[generator() % i]);
  return order;
}

/// Largest relative difference of responses, and of the field of forces.
std::pair<double, double> errorsAgainst(const latin::Snapshot& reference, const latin::Snapshot& state) {
  const std::vector<double> distance = reference.distance(state);
  const auto fields = distance.end() - 2;
  return {fields == distance.begin() ? 0.0 : *std::max_element(distance.begin(), fields), *fields};
}

}  // namespace

CalibratedSchedule::Purpose CalibratedSchedule::purposeOfNext() {
  ++number_;
  if (calibration_.runs() < calibrationsUntil(number_) && attempts_ < attemptsToCalibrate) {
    ++attempts_;
    return Purpose::calibration;
  }
  return number_ % auditEvery == auditEvery / 2 ? Purpose::audit : Purpose::result;
}

int CalibratedSchedule::stageLimit() const {
  if (stagesOfAccepted_.empty()) return coldLimit;
  std::vector<int> stages = stagesOfAccepted_;
  const auto middle = stages.begin() + static_cast<std::ptrdiff_t>(stages.size() / 2);
  std::nth_element(stages.begin(), middle, stages.end());
  return std::max(leastLimit, stagesOverMedian * *middle);
}

void CalibratedSchedule::estimate(const Indicators& indicators, results::ConfigurationResult& result) const {
  Indicators ofResponses = indicators;
  ofResponses.force = 0.0;
  result.errorEstimate = calibration_.estimate(indicators);
  result.curveErrors.assign(solver_.responses().size(), calibration_.estimate(ofResponses));
}

bool CalibratedSchedule::addRanges(results::ConfigurationResult& result) {
  const double accuracy = solver_.options().accuracy;
  const auto ranges = solver_.iteration().ranges(solver_.responses());
  const latin::Snapshot last(solver_.iteration().state(), solver_.responses());
  bool isUnique = true;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!(ranges[i].width() > accuracy * last.size(i))) continue;
    isUnique = false;
    result.reason += "; " + latin::describe(solver_.responses()[i]->name(), ranges[i], result.curves[i]);
  }
  return isUnique;
}

void CalibratedSchedule::deliver(results::ConfigurationResult& result) {
  const bool isCertified = results::isCertified(result.status);
  result.reason = isCertified ? "the error estimate of a certificate is below the accuracy asked for"
                              : "the calibrated error estimate is below the accuracy asked for";
  result.curves.clear();
  for (const auto& response : solver_.responses())
    result.curves.push_back(response->evaluate(solver_.iteration().state()));
  estimate(indicators_, result);
  const bool isUnique = addRanges(result);
  if (isCertified) {
    result.status = isUnique ? results::Status::certified : results::Status::certifiedNotUnique;
  } else {
    result.status = isUnique ? results::Status::calibrated : results::Status::calibratedNotUnique;
  }
}

bool CalibratedSchedule::march(const Indicators& target, bool isToBeKept, results::ConfigurationResult& result) {
  indicators_ = solver_.iteration().march(target);
  if (solver_.mustStop()) return false;
  ++result.iterations;
  if (isToBeKept && !solver_.iteration().isLost()) {
    way_.push_back(indicators_);
    snapshots_.push_back(std::make_unique<latin::Snapshot>(solver_.iteration().state(), solver_.responses()));
  }
  return true;
}

bool CalibratedSchedule::isTight() const {
  const double accuracy = solver_.options().accuracy;
  if (indicators_.force > tightForce * accuracy || indicators_.response > tightResponse * accuracy) return false;
  const auto [response, force] = errorsAgainst(*snapshots_.back(), *snapshots_[snapshots_.size() - 2]);
  return std::max(response, force) <= tightChange * accuracy;
}

bool CalibratedSchedule::tighten(Purpose purpose, results::ConfigurationResult& result) {
  const std::size_t claimed = snapshots_.size() - 1;
  const int before = solver_.iteration().stages();
  Indicators target = indicators_;
  do {
    target = {rung * std::min(target.force, indicators_.force), rung * std::min(target.response, indicators_.response)};
    if (!march(target, true, result)) return false;
  } while (!isTight() && !(purpose == Purpose::audit && isReference()) &&
           solver_.iteration().stages() - before < tightLimit);
  if (isTight()) calibrate(purpose);
  if (purpose != Purpose::audit) return true;
  if (isTight() || isReference()) {
    record(*snapshots_.back(), calibration_.estimate(indicators_), *snapshots_[claimed]);
    return true;
  }
  return refer(*snapshots_[claimed], result);
}

bool CalibratedSchedule::isReference() const {
  return calibration_.estimate(indicators_) <= referenceShare * solver_.options().accuracy;
}

void CalibratedSchedule::record(const latin::Snapshot& reference, double uncertainty, const latin::Snapshot& claimed) {
  const auto [responseError, forceError] = errorsAgainst(reference, claimed);
  const double error = (std::max(responseError, forceError) + uncertainty) / solver_.options().accuracy;
  Trust& summary = solver_.summary();
  ++summary.audits;
  if (error > 1.0) ++summary.falseClaims;
  summary.largestAudit = std::max(summary.largestAudit, error);
}

bool CalibratedSchedule::refer(const latin::Snapshot& claimed, results::ConfigurationResult& result) {
  const base::Matrix tight(solver_.iteration().alpha());
  const int stages = solver_.iteration().stages();
  results::ConfigurationResult certified;
  const int certificates = solver_.summary().certificates;
  const bool goesOn = solver_.certify(&tight, certified);
  solver_.summary().certificates = certificates;  // it is not what is delivered
  if (!goesOn) return false;
  if (results::isCertified(certified.status)) {
    record(latin::Snapshot(solver_.certifiedState(), solver_.responses()), certified.errorEstimate, claimed);
  } else {
    ++solver_.summary().openAudits;
  }
  result.linearStages += stages + certified.linearStages;
  indicators_ = solver_.iteration().beginAt(tight);
  return true;
}

void CalibratedSchedule::calibrate(Purpose purpose) {
  std::vector<Calibration::Observation> run;
  for (std::size_t i = 0; i + 1 < snapshots_.size(); ++i) {
    const auto [responseError, forceError] = errorsAgainst(*snapshots_.back(), *snapshots_[i]);
    run.push_back({way_[i], forceError, responseError});
  }
  if (purpose == Purpose::calibration) ++solver_.summary().calibrations;
  if (calibration_.add(run)) ratioFell_ = true;
}

bool CalibratedSchedule::iterate(const design::Configuration& configuration, Purpose purpose,
                                 const SolvedStates& states, results::ConfigurationResult& result) {
  way_.clear();
  snapshots_.clear();
  ConfigurationIteration& iteration = solver_.iteration();
  iteration.begin(states, configuration.values);
  result.starts = iteration.starts();
  result.status = results::Status::notConverged;
  const int limit = result.starts.empty() ? coldLimit : stageLimit();
  bool isAccepted = false;
  Indicators target = calibration_.target();
  while (!isAccepted && iteration.stages() < limit) {
    if (!march(target, purpose != Purpose::result, result)) return false;
    if (iteration.isLost()) break;
    isAccepted = purpose == Purpose::calibration || calibration_.accepts(indicators_);
    target = {further * target.force, further * target.response};
  }
  if (isAccepted && purpose == Purpose::result && !result.starts.empty())
    stagesOfAccepted_.push_back(iteration.stages());
  const int before = calibration_.runs();
  if (isAccepted && purpose != Purpose::result && !tighten(purpose, result)) return false;
  result.linearStages += iteration.stages();
  const bool hasCalibrated = calibration_.runs() > before;
  if (!isAccepted || (!hasCalibrated && !calibration_.accepts(indicators_))) return true;
  if (hasCalibrated && solver_.summary().certificates == 0 && purpose == Purpose::calibration) {
    if (!confirm(result)) return false;
    if (isContradicted_) {
      result.status = results::Status::notConverged;
      return true;
    }
  }
  deliver(result);
  solver_.remember(configuration);
  accepted_[configuration.id] = {configuration, result, indicators_};
  return true;
}

bool CalibratedSchedule::confirm(results::ConfigurationResult& result) {
  const base::Matrix tight(solver_.iteration().alpha());
  const latin::Snapshot claimed(solver_.iteration().state(), solver_.responses());
  if (!solver_.certify(&tight, result)) return false;
  const latin::Snapshot certified(solver_.certifiedState(), solver_.responses());
  const auto [responseError, forceError] = errorsAgainst(certified, claimed);
  isContradicted_ =
      results::isCertified(result.status) && std::max(responseError, forceError) > solver_.options().accuracy;
  indicators_ = solver_.iteration().beginAt(tight);
  result.linearStages += solver_.iteration().stages();
  return true;
}

bool CalibratedSchedule::attempt(const design::Configuration& configuration, Purpose purpose,
                                 results::ConfigurationResult& result) {
  try {
    if (!iterate(configuration, purpose, solver_.states(), result)) return false;
    // Where a load step came to no end, the march of a certificate knows better ways.
    const bool mayHaveBeenTheStart = !result.starts.empty() && !solver_.iteration().isLost();
    if (result.status == results::Status::notConverged && mayHaveBeenTheStart && !isContradicted_) {
      if (!iterate(configuration, purpose, SolvedStates(1), result)) return false;
    }
  } catch (const base::Error& error) {
    result.status = results::Status::failed;
    result.reason = error.what();
  }
  return results::isSolved(result.status) || solver_.certifyAnew(configuration, result);
}

bool CalibratedSchedule::solve(const design::Configuration& configuration, Purpose purpose, results::ResultSink& sink) {
  const double begin = cpuSeconds();
  results::ConfigurationResult result;
  // What a configuration that is taken up again has cost before counts as well.
  results::ConfigurationResult before;
  if (const auto accepted = accepted_.find(configuration.id); accepted != accepted_.end()) {
    before = accepted->second.result;
    accepted_.erase(accepted);
  }
  if (solver_.install(configuration, result)) {
    result.iterations = before.iterations;
    result.linearStages = before.linearStages;
    if (!attempt(configuration, purpose, result)) return false;
  }
  result.cpuSeconds = before.cpuSeconds + cpuSeconds() - begin;
  if (const auto accepted = accepted_.find(configuration.id); accepted != accepted_.end()) {
    accepted->second.result = result;
  }
  sink.record(result);
  return true;
}

bool CalibratedSchedule::reopen(results::ResultSink& sink) {
  while (ratioFell_) {
    ratioFell_ = false;
    std::vector<design::Configuration> again;
    for (auto& [id, one] : accepted_) {
      if (calibration_.accepts(one.indicators)) {
        estimate(one.indicators, one.result);
        sink.record(one.result);
      } else {
        again.push_back(one.configuration);
      }
    }
    for (const design::Configuration& configuration : again) {
      ++solver_.summary().reopened;
      if (!solve(configuration, Purpose::result, sink)) return false;
    }
  }
  return true;
}

std::vector<design::Configuration> CalibratedSchedule::run(const std::vector<design::Configuration>& open,
                                                           results::ResultSink& sink) {
  std::vector<design::Configuration> left;
  Trust& summary = solver_.summary();
  for (const std::size_t position : randomOrder(open.size())) {
    const design::Configuration& configuration = open[position];
    if (isContradicted_) {
      left.push_back(configuration);
      continue;
    }
    if (!solve(configuration, purposeOfNext(), sink) || !reopen(sink)) return {};
    summary.forceRatio = calibration_.forceRatio();
    summary.responseRatio = calibration_.responseRatio();
    summary.falseClaimBound = falseClaimBound(summary.audits, summary.falseClaims);
  }
  return left;
}

}  // namespace harmos::parametric
