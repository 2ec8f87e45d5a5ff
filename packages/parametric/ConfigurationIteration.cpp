#include <harmos/parametric/ConfigurationIteration.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/latin/LawCheck.hpp>
#include <harmos/latin/March.hpp>

namespace harmos::parametric {
namespace {

// Fewer solved states are worth less than a cold start: the iteration first has to get rid of their contact status.
constexpr int fewestStates = 3;
// Tangents mislead when the contact status has moved on: they are found anew when the residual has not fallen to this
// share over so many iterations.
constexpr std::size_t iterationsToFall = 3;
constexpr double slow = 0.5;
// Of |f^|: where nothing resists a motion, there is always less residual still farther away. Ways to less that lead
// somewhere have been below 0.7 of it, others 15 to 1e13 times (`study_any_mesh`).
constexpr double farthest = 1.0;
// Differences across many changes of status mislead as well.
constexpr std::size_t iterationsToFallLater = 8;

/// The values themselves, whose copies are views as well.
base::Matrix viewOf(const base::Matrix& matrix) {
  return {Teuchos::View, matrix.values(), matrix.stride(), matrix.numRows(), matrix.numCols()};
}

}  // namespace

ConfigurationIteration::ConfigurationIteration(latin::FixedPoint& fixedPoint, StepSolver& solver,
                                               const std::vector<std::shared_ptr<const latin::Response>>& responses,
                                               const Remembered& remembered, double accuracy, base::Timers& timers)
    : fixedPoint_(fixedPoint),
      solver_(solver),
      local_(fixedPoint.assembly(), fixedPoint.searchDirection(), fixedPoint.layout(), fixedPoint.formulation()),
      remembered_(remembered),
      accuracy_(accuracy),
      timers_(timers),
      gauge_(fixedPoint, responses),
      start_(fixedPoint, local_, remembered.changes),
      acceleration_(fixedPoint.metric(), remembered.neighbours + ReducedBasisStart::furtherColumns +
                                             remembered.changes + remembered.differences) {
  local_.setReference(fixedPoint.reference());
}

int ConfigurationIteration::stages() const {
  const int steps = fixedPoint_.assembly().steps();
  return static_cast<int>((columns_ + steps / 2) / steps);
}

void ConfigurationIteration::prepare() {
  const int rows = fixedPoint_.layout().rows();
  for (base::Matrix* field : {&alpha_, &next_, &image_, &beta_}) field->shape(rows, fixedPoint_.assembly().steps());
  for (base::Matrix* field : {&column_, &columnImage_, &columnBeta_, &columnTraction_, &change_, &changeImage_}) {
    field->shape(rows, 1);
  }
  starts_.clear();
  isFirstMarch_ = true;
  isLost_ = false;
  traction_ = 0.0;
  forces_.clear();
  const long before = fixedPoint_.linearStage().columns();
  solver_.updateLoads();
  offset_ = solver_.offset();
  columns_ = fixedPoint_.linearStage().columns() - before;
}

void ConfigurationIteration::begin(const SolvedStates& states, const std::vector<double>& values) {
  prepare();
  if (states.count() < fewestStates) return;
  const auto running = timers_.start("start");
  start_.begin(states, values, remembered_.neighbours, *offset_);
  starts_ = start_.starts();
  traction_ = start_.traction();
  forces_ = start_.forces();
}

results::Indicators ConfigurationIteration::beginAt(const base::Matrix& alpha) {
  prepare();
  next_.assign(alpha);
  isFirstMarch_ = false;
  return applyAll();
}

results::Indicators ConfigurationIteration::applyAll() {
  alpha_.assign(next_);
  columns_ += alpha_.numCols();
  state_ = &fixedPoint_.apply(alpha_, image_);
  fixedPoint_.shareTractions(alpha_, image_, accuracy_);
  beta_.assign(state_->beta());
  const auto running = timers_.start("indicators");
  results::Indicators indicators = gauge_.measure(*state_, alpha_, image_);
  forces_ = gauge_.forces();
  traction_ = fixedPoint_.metric().norm(state_->hattedTraction()) / std::sqrt(alpha_.numCols());
  return indicators;
}

void ConfigurationIteration::applyLaws() {
  local_.begin();
  local_.solveColumn(0, columnBeta_, columnTraction_);
  for (int row = 0; row < column_.numRows(); ++row) {
    columnImage_[0][row] = 2.0 * columnTraction_[0][row] - columnBeta_[0][row];
  }
}

bool ConfigurationIteration::meetsTarget() {
  const std::vector<double>& scale = fixedPoint_.metric().scale();
  std::vector<double> sums(3, 0.0);
  for (std::size_t row = 0; row < scale.size(); ++row) {
    const double residual = scale[row] * (columnImage_[0][row] - column_[0][row]);
    const double traction = scale[row] * columnTraction_[0][row];
    const double image = scale[row] * columnImage_[0][row];
    sums[0] += residual * residual;
    sums[1] += traction * traction;
    sums[2] += image * image;
  }
  fixedPoint_.metric().sum(sums);
  residual_ = std::sqrt(sums[0]);
  if (residual_ <= latin::FixedPoint::noise * std::sqrt(sums[2])) return true;
  const bool isCold = isFirstMarch_ && starts_.empty();
  const double traction = isCold ? std::sqrt((traction_ * traction_ * step_ + sums[1]) / (step_ + 1.0)) : traction_;
  if (residual_ > gauge_.allowedForce(target_, forces_) * traction) return false;
  const double allowed = gauge_.allowedImbalance(target_, forces_);
  return std::isinf(allowed) || gauge_.imbalance(column_, columnBeta_, columnTraction_) <= allowed;
}

void ConfigurationIteration::findStart() {
  const auto running = timers_.start("start");
  start_.find(step_, gauge_.allowedForce(target_, forces_) * traction_);
  column_.assign(start_.state());
  columnBeta_.assign(start_.beta());
  applyLaws();
  isThere_ = meetsTarget();
  if (isThere_) return;
  if (!start_.hasTangents()) start_.differentiate();
  seed();
}

void ConfigurationIteration::seed() {
  acceleration_.seed({viewOf(start_.residualTangents())}, {viewOf(start_.imageTangents())});
}

void ConfigurationIteration::improve() {
  start_.improve(column_, columnBeta_, gauge_.allowedForce(target_, forces_) * traction_);
  base::Matrix change(start_.state());
  change -= column_;
  if (fixedPoint_.metric().norm(change) > farthest * traction_) {
    start_.forget();
    applyLaws();
    return;
  }
  column_.assign(start_.state());
  columnBeta_.assign(start_.beta());
  applyLaws();
  isThere_ = meetsTarget();
}

void ConfigurationIteration::beginAnew() {
  acceleration_.restart();
  residuals_.clear();
  if (starts_.empty()) return;
  const auto running = timers_.start("start");
  if (remembered_.changes > 0) improve();
  if (isThere_) return;
  start_.differentiate();
  seed();
}

bool ConfigurationIteration::isSlow() {
  residuals_.push_back(residual_);
  const std::size_t back = wasSlow_ ? iterationsToFallLater : iterationsToFall;
  const bool isSlow = residuals_.size() > back && residual_ > slow * residuals_[residuals_.size() - 1 - back];
  wasSlow_ = wasSlow_ || isSlow;
  return isSlow;
}

void ConfigurationIteration::extrapolate() {
  const std::vector<double>& times = fixedPoint_.assembly().times;
  const auto t = static_cast<std::size_t>(step_);
  column_.putScalar(0.0);
  columnBeta_.putScalar(0.0);
  const auto add = [&](int from, double share) {
    for (int row = 0; row < column_.numRows(); ++row) {
      column_[0][row] += share * alpha_[from][row];
      columnBeta_[0][row] += share * (beta_[from][row] - (*offset_)[from][row]);
    }
  };
  const double ratio = step_ < 2 ? 0.0 : (times[t] - times[t - 1]) / (times[t - 1] - times[t - 2]);
  if (step_ > 0) add(step_ - 1, 1.0 + ratio);
  if (step_ > 1) add(step_ - 2, -ratio);
  for (int row = 0; row < column_.numRows(); ++row) columnBeta_[0][row] += (*offset_)[step_][row];
  applyLaws();
}

int ConfigurationIteration::iterationsLeft() const {
  const double left = limit_ * alpha_.numCols() - static_cast<double>(columns_);
  return static_cast<int>(std::clamp(left, 0.0, static_cast<double>(latin::March::maximumIterations)));
}

void ConfigurationIteration::startStep() {
  local_.select({step_});
  acceleration_.restart();
  if (isFirstMarch_ && !starts_.empty()) {
    findStart();
  } else if (isFirstMarch_) {
    extrapolate();
    isThere_ = meetsTarget();
  } else {
    std::copy_n(alpha_[step_], column_.numRows(), column_[0]);
    std::copy_n(beta_[step_], column_.numRows(), columnBeta_[0]);
    applyLaws();
    isThere_ = meetsTarget();
    if (!isThere_ && !starts_.empty()) {
      start_.gather(step_);
      beginAnew();
    }
  }
  residuals_.clear();
  wasSlow_ = false;
  iterations_ = 0;
  mostIterations_ = iterationsLeft();
  isStarted_ = true;
}

void ConfigurationIteration::propose() {
  for (int row = 0; row < column_.numRows(); ++row) change_[0][row] = -column_[0][row];
  acceleration_.advance(column_, columnImage_);
  change_ += column_;
}

StepSolver::Request ConfigurationIteration::request() {
  return {change_[0], changeImage_[0]};
}

void ConfigurationIteration::take() {
  isWaiting_ = isSolved_ = false;
  ++columns_;
  ++iterations_;
  columnBeta_ += changeImage_;
  if (!starts_.empty()) start_.remember(change_, changeImage_);
  applyLaws();
  isThere_ = meetsTarget();
}

void ConfigurationIteration::endStep() {
  const int rows = column_.numRows();
  std::copy_n(column_[0], rows, alpha_[step_]);
  std::copy_n(columnBeta_[0], rows, beta_[step_]);
  const bool isCold = isFirstMarch_ && starts_.empty();
  if (isFirstMarch_ && !isCold) start_.settle(step_, column_, columnBeta_);
  // The stage of all load steps is one more iteration, where it is known how.
  if (iterations_ > 0) acceleration_.advance(column_, columnImage_);
  std::copy_n(column_[0], rows, next_[step_]);
  if (isCold) {
    const double here = fixedPoint_.metric().norm(columnTraction_);
    traction_ = std::sqrt((traction_ * traction_ * step_ + here * here) / (step_ + 1.0));
  }
  local_.accept();
  local_.startFromHere();
  isStarted_ = false;
  ++step_;
}

void ConfigurationIteration::startMarch(const results::Indicators& target) {
  target_ = target;
  step_ = 0;
  isStarted_ = isWaiting_ = isSolved_ = false;
  local_.startUnloaded();
}

bool ConfigurationIteration::proceed() {
  const auto running = timers_.start("acceleration");
  if (isWaiting_ && !isSolved_) return true;
  if (isWaiting_) take();
  while (step_ < alpha_.numCols()) {
    if (!isStarted_) startStep();
    if (!isThere_ && iterations_ < mostIterations_ && isSlow()) beginAnew();
    if (!isThere_ && iterations_ < mostIterations_) {
      propose();
      return isWaiting_ = true;
    }
    if (!isThere_ && isFirstMarch_ && atLimit_ == AtLimit::isLost) {
      isLost_ = true;
      return false;
    }
    endStep();
  }
  return false;
}

results::Indicators ConfigurationIteration::endMarch() {
  if (isLost_) {
    constexpr double none = std::numeric_limits<double>::infinity();
    return {none, none, std::vector<double>(target_.responses.size(), none)};
  }
  isFirstMarch_ = false;
  return applyAll();
}

results::Indicators ConfigurationIteration::march(const results::Indicators& target) {
  {
    // All load steps are selected again at the end, also when a law throws.
    const latin::FixedPoint::AllStepsAtEnd restore(fixedPoint_);
    startMarch(target);
    while (!(mustStop_ && mustStop_()) && proceed()) {
      solver_.solve({request()});
      markSolved();
    }
  }
  return endMarch();
}

latin::Indeterminacy ConfigurationIteration::indeterminacy(
    const std::vector<std::shared_ptr<const latin::Response>>& responses) {
  return fixedPoint_.indeterminacy(responses, accuracy_);
}

std::string ConfigurationIteration::falseGraph() {
  return latin::lackOfGraph(fixedPoint_, state(), accuracy_);
}

base::Matrix ConfigurationIteration::linear() const {
  base::Matrix linear(beta_);
  linear -= *offset_;
  return linear;
}

}  // namespace harmos::parametric
