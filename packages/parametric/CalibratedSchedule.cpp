#include <harmos/parametric/CalibratedSchedule.hpp>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

#include <harmos/base/Error.hpp>
#include <harmos/results/StatusName.hpp>

namespace harmos::parametric {
namespace {

constexpr int auditEvery = 100;
constexpr int attemptsToCalibrate = 10;
// When so many have led to none, there will be none.
constexpr int attemptsAtFirst = 4;
// A march that has met its target ends a little above or below it; one that was not enough goes so much further.
constexpr double further = 0.7;
// States on the way of a configuration that calibrates: each goes so much further, within so many linear stages.
constexpr int statesOnWay = 2;
constexpr double rung = 0.3;
constexpr int stagesToFirst = 150;
constexpr int stagesToNext = 20;
// Of the accuracy: what calibrates and audits is certified to this share, which is added to the errors it finds.
constexpr double tightShare = 0.1;
// Of these a start can be made.
constexpr int fewestStates = 3;

// Configurations that march side by side: at most so many, and one for so many that are solved, since none of them
// is a start for the others.
constexpr int solvedForEach = 8;

constexpr int lastCalibration = 16;
constexpr unsigned seedOfOrder = 20040601;

/// The same on every rank, in every run and on every machine.
std::vector<std::size_t> randomOrder(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 generator(seedOfOrder);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[generator() % i]);
  return order;
}

/// Relative differences: of each response, then of the field of forces.
std::vector<double> errorsAgainst(const latin::Snapshot& reference, const latin::Snapshot& state) {
  std::vector<double> errors = reference.distance(state);
  errors.pop_back();  // displacements
  return errors;
}

}  // namespace

CalibratedSchedule::Purpose CalibratedSchedule::purposeOfNext() {
  ++number_;
  if (calibration_.runs() < calibrationsUntil(number_) && attempts_ < attemptsToCalibrate) {
    ++attempts_;
    return Purpose::calibration;
  }
  if (number_ % auditEvery == auditEvery / 2) isAuditDue_ = true;
  return std::exchange(isAuditDue_, false) ? Purpose::audit : Purpose::result;
}

std::size_t CalibratedSchedule::mostTogether() const {
  const bool mayCalibrate = number_ < lastCalibration ||
                            (calibration_.runs() < calibrationsUntil(number_) && attempts_ < attemptsToCalibrate);
  return static_cast<std::size_t>(mayCalibrate ? 1 : sideBySide(solver_.states().count(), widest_));
}

int CalibratedSchedule::sideBySide(int solved, int widest) {
  return std::clamp(solved / solvedForEach, 1, widest);
}

int CalibratedSchedule::calibrationsUntil(int number) {
  int count = 0;
  for (int next = 1; next <= std::min(number, lastCalibration); next *= 2) ++count;
  return count;
}

int CalibratedSchedule::freePlace() const {
  int place = 0;
  const auto isTaken = [&](const Attempt& attempt) { return attempt.place == place; };
  while (std::any_of(underWay_.begin(), underWay_.end(), isTaken)) ++place;
  return place;
}

bool CalibratedSchedule::march(const results::Indicators& target, bool isToBeKept,
                               results::ConfigurationResult& result) {
  return takeMarch(solver_.iteration().march(target), isToBeKept, result);
}

bool CalibratedSchedule::takeMarch(const results::Indicators& indicators, bool isToBeKept,
                                   results::ConfigurationResult& result) {
  indicators_ = indicators;
  if (solver_.mustStop()) return false;
  ++result.iterations;
  if (isToBeKept && !solver_.iteration().isLost()) {
    way_.push_back(indicators_);
    snapshots_.push_back(std::make_unique<latin::Snapshot>(solver_.iteration().state(), solver_.responses()));
  }
  return true;
}

bool CalibratedSchedule::certifyFromHere(double share, results::ConfigurationResult& result) {
  const base::Matrix start(solver_.iteration().alpha());
  result.linearStages += solver_.iteration().stages();
  try {
    return solver_.certify(&start, result, share);
  } catch (const base::Error& error) {
    result.status = results::Status::failed;
    result.reason = error.what();
  }
  return true;
}

void CalibratedSchedule::learn(results::ConfigurationResult& result) {
  const double uncertainty = result.errorEstimate;
  const latin::Snapshot reference(solver_.certifiedState(), solver_.responses());
  std::vector<Calibration::Observation> run;
  for (std::size_t i = 0; i < snapshots_.size(); ++i) {
    std::vector<double> errors = errorsAgainst(reference, *snapshots_[i]);
    for (double& error : errors) error += uncertainty;
    const double ofForces = errors.back();
    errors.pop_back();
    run.push_back({way_[i], ofForces, std::move(errors)});
  }
  result.evidence.ratios = calibration_.ratiosOf(run);
  if (calibration_.add(*result.evidence.ratios)) ratioFell_ = true;
}

bool CalibratedSchedule::calibrate(const design::Configuration& configuration, results::ConfigurationResult& result) {
  ConfigurationIteration& iteration = solver_.iteration();
  const bool isWarm =
      solver_.states().count() >= fewestStates && record_.favoursWarm(solver_.states().distance(configuration.values));
  // No conditional expression: it would copy the states.
  if (isWarm) {
    iteration.begin(solver_.states(), configuration.values);
  } else {
    iteration.begin(SolvedStates(1), configuration.values);
  }
  result.starts = iteration.starts();
  iteration.setLimit(stagesToFirst);
  results::Indicators target = calibration_.target();
  for (int i = 0; i < statesOnWay; ++i) {
    if (!march(target, true, result)) return false;
    if (iteration.isLost()) {
      result.linearStages += iteration.stages();
      return true;
    }
    target = tightened(rung, target, indicators_);
    iteration.setLimit(iteration.stages() + stagesToNext);
  }
  if (!certifyFromHere(tightShare, result)) return false;
  if (!results::isCertified(result.status)) return true;
  learn(result);
  ++solver_.summary().calibrations;
  solver_.rememberCertified(configuration, result);
  return true;
}

void CalibratedSchedule::accept(const design::Configuration& configuration, results::ConfigurationResult& result) {
  delivery_.deliver(indicators_, result);
  if (!results::isSolved(result.status)) return;
  solver_.remember(configuration);
  accepted_.add(configuration, result);
}

bool CalibratedSchedule::audit(const design::Configuration& configuration, results::ConfigurationResult& result) {
  const base::Matrix accepted(solver_.iteration().alpha());
  const results::ConfigurationResult before = result;
  if (!certifyFromHere(tightShare, result)) return false;
  Trust& summary = solver_.summary();
  if (!results::isCertified(result.status)) {
    ++summary.openAudits;
    const int stages = result.linearStages;
    result = before;
    indicators_ = solver_.iteration().beginAt(accepted);
    result.linearStages = stages + solver_.iteration().stages();
    accept(configuration, result);
    return true;
  }
  const latin::Snapshot reference(solver_.certifiedState(), solver_.responses());
  const std::vector<double> errors = errorsAgainst(reference, *snapshots_.back());
  const double error =
      (*std::max_element(errors.begin(), errors.end()) + result.errorEstimate) / solver_.options().accuracy;
  summary.addAudit(error);
  result.evidence.audit = error;
  learn(result);
  solver_.rememberCertified(configuration, result);
  return true;
}

double CalibratedSchedule::limitFromNeighbours() const {
  return std::min(stagesFromNeighbours, record_.coldStages());
}

void CalibratedSchedule::beginFromNeighbours(Attempt& attempt) {
  ConfigurationIteration& iteration = solver_.iteration();
  iteration.begin(solver_.states(), attempt.configuration.values);
  attempt.result.starts = iteration.starts();
  iteration.setLimit(limitFromNeighbours(), ConfigurationIteration::AtLimit::goesOn);
  iteration.startMarch(calibration_.target());
  attempt.isFromNeighbours = attempt.isMarching = true;
}

bool CalibratedSchedule::endFromNeighbours(Attempt& attempt) {
  ConfigurationIteration& iteration = solver_.iteration();
  const bool isAudit = attempt.purpose == Purpose::audit;
  results::Indicators target = calibration_.target();
  if (!takeMarch(iteration.endMarch(), isAudit, attempt.result)) return false;
  while (!calibration_.accepts(indicators_) && iteration.stages() < limitFromNeighbours()) {
    target = tightened(further, target, target);
    if (!march(target, isAudit, attempt.result)) return false;
  }
  const bool isAccepted = calibration_.accepts(indicators_);
  attempt.wasAudited = isAccepted && isAudit;
  if (attempt.wasAudited) return audit(attempt.configuration, attempt.result);
  if (!isAccepted) {
    if (!certifyFromHere(1.0, attempt.result)) return false;
    if (results::isCertified(attempt.result.status)) solver_.rememberCertified(attempt.configuration, attempt.result);
    return true;
  }
  attempt.result.linearStages += iteration.stages();
  accept(attempt.configuration, attempt.result);
  return true;
}

bool CalibratedSchedule::certifyAnew(const design::Configuration& configuration, results::ConfigurationResult& result) {
  const int before = result.linearStages;
  if (!solver_.certifyAnew(configuration, result)) return false;
  if (results::isCertified(result.status)) record_.addCold(result.linearStages - before);
  return true;
}

void CalibratedSchedule::begin(const design::Configuration& configuration, Purpose purpose) {
  Attempt attempt{configuration, purpose, freePlace()};
  results::ConfigurationResult& result = attempt.result;
  const double begin = cpuSeconds();
  // What a configuration that is taken up again has cost before counts as well.
  const results::ConfigurationResult before = accepted_.take(configuration.id);
  attempt.isOpen = solver_.install(configuration, result);
  if (attempt.isOpen) {
    solver_.keep(attempt.place);
    attempt.stagesBefore = before.linearStages;
    result.iterations = before.iterations;
    result.linearStages = before.linearStages;
    result.status = results::Status::notConverged;
    attempt.distance = solver_.states().distance(configuration.values);
    const bool isWarm = attempt.purpose != Purpose::calibration && calibration_.runs() > 0 &&
                        solver_.states().count() >= fewestStates && record_.favoursWarm(attempt.distance);
    try {
      const bool mayLack = attempt.purpose == Purpose::calibration || solver_.isNearLack(configuration);
      attempt.isOpen = !mayLack || !solver_.lacksEquilibrium(configuration, result);
      if (attempt.isOpen && isWarm) beginFromNeighbours(attempt);
    } catch (const base::Error& error) {
      result.status = results::Status::failed;
      result.reason = error.what();
    }
  }
  attempt.cpuSeconds = before.cpuSeconds + cpuSeconds() - begin;
  underWay_.push_back(std::move(attempt));
}

void CalibratedSchedule::march() {
  const double begin = cpuSeconds();
  std::vector<int> places;
  for (const Attempt& attempt : underWay_) places.push_back(attempt.place);
  const std::vector<StudySolver::Marched> marched = solver_.march(places);
  const double share = (cpuSeconds() - begin) / static_cast<double>(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    Attempt& attempt = underWay_[i];
    attempt.cpuSeconds += share;
    attempt.isMarching = marched[i].waits;
    if (marched[i].error.empty()) continue;
    attempt.isFromNeighbours = false;
    attempt.result.status = results::Status::failed;
    attempt.result.reason = marched[i].error;
  }
}

bool CalibratedSchedule::end(Attempt& attempt) {
  results::ConfigurationResult& result = attempt.result;
  way_.clear();
  snapshots_.clear();
  try {
    if (attempt.purpose == Purpose::calibration && !calibrate(attempt.configuration, result)) return false;
    if (attempt.isFromNeighbours && !endFromNeighbours(attempt)) return false;
  } catch (const base::Error& error) {
    result.status = results::Status::failed;
    result.reason = error.what();
  }
  const bool isEnded =
      results::isSolved(result.status) || (attempt.isFromNeighbours && result.status == results::Status::noEquilibrium);
  if (!isEnded && !certifyAnew(attempt.configuration, result)) return false;
  if (attempt.purpose == Purpose::audit && !attempt.wasAudited) isAuditDue_ = true;
  if (attempt.isFromNeighbours && !attempt.wasAudited)
    record_.addWarm(attempt.distance, result.linearStages - attempt.stagesBefore);
  return true;
}

bool CalibratedSchedule::endThose(results::ResultSink& sink) {
  for (auto attempt = underWay_.begin(); attempt != underWay_.end();) {
    if (attempt->isMarching) {
      ++attempt;
      continue;
    }
    const double begin = cpuSeconds();
    results::ConfigurationResult& result = attempt->result;
    if (attempt->isOpen) {
      solver_.present(attempt->place);
      if (!end(*attempt)) return false;
    }
    result.cpuSeconds = attempt->cpuSeconds + cpuSeconds() - begin;
    accepted_.update(result);
    // Before what taught it, so that no run that ends here leaves claims of which its record knows better.
    reopen(sink);
    sink.record(result);
    attempt = underWay_.erase(attempt);
  }
  return true;
}

void CalibratedSchedule::reopen(results::ResultSink& sink) {
  if (!std::exchange(ratioFell_, false)) return;
  reopened_ = accepted_.review(sink);
}

void CalibratedSchedule::resume(const std::vector<EarlierResult>& earlier) {
  Trust& summary = solver_.summary();
  for (const auto& [configuration, result] : earlier) {
    if (result.status == results::Status::reopened) {
      accepted_.addWithdrawn(result);
      continue;
    }
    ++number_;
    const results::Evidence& evidence = result.evidence;
    if (evidence.ratios) calibration_.add(*evidence.ratios);
    if (evidence.audit) summary.addAudit(*evidence.audit);
    if (evidence.ratios && !evidence.audit) ++summary.calibrations;
    if (results::isCertified(result.status)) ++summary.certificates;
    if (evidence.indicators && evidence.indicators->responses.size() == solver_.responses().size() &&
        results::isSolved(result.status))
      accepted_.add(configuration, result);
  }
  attempts_ = calibration_.runs();
  summary.ratios = calibration_.ratios();
  ratioFell_ = true;  // another team of ranks may have found what this one has to look at
}

std::vector<design::Configuration> CalibratedSchedule::run(const std::vector<design::Configuration>& open,
                                                           results::ResultSink& sink) {
  std::vector<design::Configuration> left;
  Trust& summary = solver_.summary();
  const std::vector<std::size_t> order = randomOrder(open.size());
  auto next = order.begin();
  underWay_.clear();
  reopened_.clear();
  reopen(sink);
  while (next != order.end() || !reopened_.empty() || !underWay_.empty()) {
    while (underWay_.size() < mostTogether() && (next != order.end() || !reopened_.empty())) {
      if (!reopened_.empty()) {
        const design::Configuration again = reopened_.back();
        reopened_.pop_back();
        ++summary.reopened;
        begin(again, Purpose::result);
      } else if (calibration_.runs() == 0 && attempts_ >= attemptsAtFirst) {
        left.push_back(open[*next++]);
      } else {
        begin(open[*next++], purposeOfNext());
      }
    }
    const auto allMarch = [&] {
      return !underWay_.empty() &&
             std::all_of(underWay_.begin(), underWay_.end(), [](const Attempt& attempt) { return attempt.isMarching; });
    };
    if (allMarch()) march();
    if (allMarch()) return {};  // interrupted
    if (!endThose(sink)) return {};
    summary.ratios = calibration_.ratios();
  }
  return left;
}

}  // namespace harmos::parametric
