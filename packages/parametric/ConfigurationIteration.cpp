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
// Tangents of the start mislead when the contact status has moved on: without them when the residual has not fallen to
// this share over so many iterations.
constexpr std::size_t iterationsToFall = 4;
constexpr double slow = 0.5;
// Error of solves in single precision from which on they are made in double.
constexpr double tooRough = 1e-5;
// Differences across many changes of status mislead as well.
constexpr std::size_t iterationsToFallLater = 8;

}  // namespace

ConfigurationIteration::ConfigurationIteration(latin::FixedPoint& fixedPoint,
                                               const std::vector<std::shared_ptr<const latin::Response>>& responses,
                                               int neighbours, int memory, double accuracy,
                                               substructure::Precision precision, base::Timers& timers)
    : fixedPoint_(fixedPoint),
      neighbours_(neighbours),
      accuracy_(accuracy),
      precision_(precision),
      timers_(timers),
      gauge_(fixedPoint, responses),
      start_(fixedPoint),
      accelerations_(
          static_cast<std::size_t>(fixedPoint.assembly().steps()),
          latin::AndersonAcceleration(fixedPoint.metric(), neighbours + ReducedBasisStart::furtherColumns + memory)) {}

int ConfigurationIteration::stages() const {
  return fixedPoint_.linearStage().stages() - stagesBefore_;
}

void ConfigurationIteration::updateOffset() {
  const latin::BodyOperators& operators = fixedPoint_.linearStage().operators();
  const std::size_t bodies = fixedPoint_.assembly().bodies.size();
  int here = 0;  // 1: other loads, 2: there are loads
  if (loads_.empty()) {
    loads_.resize(bodies);
    held_.resize(bodies);
    here = 1;
  }
  for (std::size_t b = 0; b < bodies; ++b) {
    const base::Matrix& loads = operators.loads(static_cast<int>(b));
    const base::Matrix& held = operators.held(static_cast<int>(b));
    if (loads.normInf() > 0.0 || held.numCols() > 0) here |= 2;
    if (loads_[b] == loads && held_[b] == held) continue;
    loads_[b] = loads;
    held_[b] = held;
    here |= 1;
  }
  std::vector<int> mine{here & 1, here & 2}, all(2);
  Teuchos::reduceAll(fixedPoint_.layout().comm(), Teuchos::REDUCE_MAX, 2, mine.data(), all.data());
  if (all[0] == 0) return;
  offset_.shape(fixedPoint_.layout().rows(), fixedPoint_.assembly().steps());
  if (all[1] == 0) return;
  const latin::Iterate& unloaded = fixedPoint_.apply(offset_, image_);
  offset_.assign(unloaded.beta());
}

void ConfigurationIteration::prepare() {
  if (precision_ == substructure::Precision::single && fixedPoint_.prepareSingle() > tooRough) {
    precision_ = substructure::Precision::exact;
  }
  const int rows = fixedPoint_.layout().rows();
  for (base::Matrix* field : {&alpha_, &next_, &image_, &beta_}) field->shape(rows, fixedPoint_.assembly().steps());
  for (base::Matrix* field : {&column_, &columnImage_, &columnBeta_, &columnTraction_}) field->shape(rows, 1);
  stagesBefore_ = fixedPoint_.linearStage().stages();
  starts_.clear();
  isFirstMarch_ = true;
  isLost_ = false;
  traction_ = force_ = 0.0;
  for (auto& acceleration : accelerations_) acceleration.restart();
  updateOffset();
}

void ConfigurationIteration::begin(const SolvedStates& states, const std::vector<double>& values) {
  prepare();
  if (states.count() < fewestStates) return;
  const auto running = timers_.start("start");
  start_.begin(states, values, neighbours_, offset_);
  starts_ = start_.starts();
  traction_ = start_.traction();
  force_ = start_.force();
}

Indicators ConfigurationIteration::beginAt(const base::Matrix& alpha) {
  prepare();
  next_.assign(alpha);
  isFirstMarch_ = false;
  return applyAll();
}

Indicators ConfigurationIteration::applyAll() {
  alpha_.assign(next_);
  state_ = &fixedPoint_.apply(alpha_, image_);
  fixedPoint_.shareTractions(alpha_, image_, accuracy_);
  beta_.assign(state_->beta());
  const auto running = timers_.start("indicators");
  const Indicators indicators = gauge_.measure(*state_, alpha_, image_);
  force_ = gauge_.force();
  traction_ = fixedPoint_.metric().norm(state_->hattedTraction()) / std::sqrt(alpha_.numCols());
  return indicators;
}

void ConfigurationIteration::applyLaws() {
  fixedPoint_.pointwiseStage().begin();
  fixedPoint_.pointwiseStage().solveColumn(0, columnBeta_, columnTraction_);
  for (int row = 0; row < column_.numRows(); ++row) {
    columnImage_[0][row] = 2.0 * columnTraction_[0][row] - columnBeta_[0][row];
  }
}

bool ConfigurationIteration::meets(int step, const Indicators& target) {
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
  if (residual_ <= latin::March::noise * std::sqrt(sums[2])) return true;
  const bool isCold = isFirstMarch_ && starts_.empty();
  const double traction = isCold ? std::sqrt((traction_ * traction_ * step + sums[1]) / (step + 1.0)) : traction_;
  if (residual_ > target.force * traction) return false;
  return force_ == 0.0 || gauge_.imbalance(column_, columnBeta_, columnTraction_) <= target.response * force_;
}

void ConfigurationIteration::findStart(int step, const Indicators& target) {
  const auto running = timers_.start("start");
  start_.find(step, target.force * traction_);
  column_.assign(start_.state());
  columnBeta_.assign(start_.beta());
  applyLaws();
  if (meets(step, target)) return;
  if (!start_.hasTangents()) start_.differentiate();
  accelerations_[step].seed({start_.residualTangents()}, {start_.imageTangents()});
}

void ConfigurationIteration::extrapolate(int step) {
  const std::vector<double>& times = fixedPoint_.assembly().times;
  const auto t = static_cast<std::size_t>(step);
  column_.putScalar(0.0);
  columnBeta_.putScalar(0.0);
  const auto add = [&](int from, double share) {
    for (int row = 0; row < column_.numRows(); ++row) {
      column_[0][row] += share * alpha_[from][row];
      columnBeta_[0][row] += share * (beta_[from][row] - offset_[from][row]);
    }
  };
  const double ratio = step < 2 ? 0.0 : (times[t] - times[t - 1]) / (times[t - 1] - times[t - 2]);
  if (step > 0) add(step - 1, 1.0 + ratio);
  if (step > 1) add(step - 2, -ratio);
  for (int row = 0; row < column_.numRows(); ++row) columnBeta_[0][row] += offset_[step][row];
  applyLaws();
}

int ConfigurationIteration::iterationsLeft() const {
  const double left = (limit_ - stages()) * alpha_.numCols();
  return static_cast<int>(std::clamp(left, 0.0, static_cast<double>(latin::March::maximumIterations)));
}

bool ConfigurationIteration::iterate(int step, const Indicators& target) {
  latin::AndersonAcceleration& acceleration = accelerations_[step];
  const int rows = column_.numRows();
  base::Matrix change(rows, 1), unused(rows, 1);
  std::vector<double> residuals;  // since the last restart of the acceleration
  std::size_t back = iterationsToFall;
  const int most = iterationsLeft();
  int iterations = 0;
  bool isThere = meets(step, target);
  for (; !isThere && iterations < most; ++iterations) {
    residuals.push_back(residual_);
    if (residuals.size() > back && residual_ > slow * residuals[residuals.size() - 1 - back]) {
      acceleration.restart();
      residuals.clear();
      back = iterationsToFallLater;
    }
    for (int row = 0; row < rows; ++row) change[0][row] = -column_[0][row];
    acceleration.advance(column_, columnImage_);
    change += column_;
    const latin::Iterate& iterate = fixedPoint_.apply(change, unused, precision_);
    for (int row = 0; row < rows; ++row) columnBeta_[0][row] += iterate.beta()[0][row] - offset_[step][row];
    applyLaws();
    isThere = meets(step, target);
  }
  std::copy_n(column_[0], rows, alpha_[step]);
  std::copy_n(columnBeta_[0], rows, beta_[step]);
  if (isFirstMarch_ && !starts_.empty()) start_.settle(step, column_, columnBeta_);
  // The stage of all load steps is one more iteration, where it is known how.
  if (iterations > 0) acceleration.advance(column_, columnImage_);
  std::copy_n(column_[0], rows, next_[step]);
  return isThere;
}

bool ConfigurationIteration::settle(int step, const Indicators& target) {
  const auto running = timers_.start("acceleration");
  if (!isFirstMarch_) {
    std::copy_n(alpha_[step], column_.numRows(), column_[0]);
    std::copy_n(beta_[step], column_.numRows(), columnBeta_[0]);
    accelerations_[step].resume();
    applyLaws();
  } else if (starts_.empty()) {
    extrapolate(step);
  } else {
    findStart(step, target);
  }
  const bool isThere = iterate(step, target);
  if (isFirstMarch_ && starts_.empty()) {
    const double here = fixedPoint_.metric().norm(columnTraction_);
    traction_ = std::sqrt((traction_ * traction_ * step + here * here) / (step + 1.0));
  }
  return isThere;
}

Indicators ConfigurationIteration::march(const Indicators& target) {
  {
    // All load steps are selected again at the end, also when a law throws.
    const latin::FixedPoint::AllStepsAtEnd restore(fixedPoint_);
    fixedPoint_.startUnloaded();
    for (int t = 0; t < alpha_.numCols(); ++t) {
      if (mustStop_ && mustStop_()) break;
      fixedPoint_.select({t});
      const bool isThere = settle(t, target);
      if (!isThere && isFirstMarch_) {
        isLost_ = true;
        const double unknown = std::numeric_limits<double>::infinity();
        return {unknown, unknown};
      }
      fixedPoint_.pointwiseStage().accept();
      fixedPoint_.startFromHere();
    }
  }
  isFirstMarch_ = false;
  return applyAll();
}

std::vector<latin::ResponseRange> ConfigurationIteration::ranges(
    const std::vector<std::shared_ptr<const latin::Response>>& responses) {
  return fixedPoint_.indeterminacy(responses, accuracy_).responses;
}

std::string ConfigurationIteration::falseGraph() {
  return latin::checkLaws(fixedPoint_, state(), accuracy_).falseGraph;
}

base::Matrix ConfigurationIteration::linear() const {
  base::Matrix linear(beta_);
  linear -= offset_;
  return linear;
}

}  // namespace harmos::parametric
