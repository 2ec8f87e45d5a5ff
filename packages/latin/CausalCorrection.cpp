#include <harmos/latin/CausalCorrection.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <harmos/latin/March.hpp>
#include <harmos/latin/StepsAtOnce.hpp>
#include <harmos/latin/detail/FieldDistances.hpp>

namespace harmos::latin {
namespace {

// Share of the way that the residual may hide.
constexpr double allowedToHide = 0.5;
// Of what hides most: what goes on together with that.
constexpr double hidesMuch = 0.5;
// Gauss-Newton steps of a load step after each linear stage.
constexpr int gaussNewtonSteps = 3;
constexpr int halvings = 2;
// A Gauss-Newton step that leaves more than this share of the residual is not worth its local stages.
constexpr double worthwhile = 0.999;
// Of what is gone for: the least residual that a load step which has begun with less than that is brought to.
constexpr double leastTarget = 0.1;
// New directions after which that is given up: what is left may be round-off.
constexpr int mostDirections = 5;
// Times the residual that the tangent predicts, from which on it is found anew.
constexpr double misprediction = 2.0;
// Of the residual that is gone for: errors of single precision that hardly change anything.
constexpr double negligible = 0.1;
// Ways over the residuals, at least, that are reckoned with before directions are known.
constexpr double wayOfResidual = 100.0;
// The least way over the residual: T brings no two points farther apart.
constexpr double leastWay = 0.5;
// Times what the images have promised that the true residual may be.
constexpr double promised = 1.25;
// Times the error that is gone for, that the way of a load step may tell before the correction goes on; share of that
// error that each load step then goes for, and least share of the reduction that it goes to.
constexpr double nearEnough = 1.5;
constexpr double shareOfError = 0.5;
constexpr double furthest = 0.1;
// Linear stages, each of some load steps, in which the largest residual must fall to this share.
constexpr std::size_t patience = 40;
constexpr double slow = 0.8;

double scaledNorm(const StateMetric& metric, const double* a, const double* b) {
  std::vector<double> sum{0.0};
  for (std::size_t row = 0; row < metric.scale().size(); ++row) {
    const double x = metric.scale()[row] * (b == nullptr ? a[row] : a[row] - b[row]);
    sum[0] += x * x;
  }
  metric.sum(sum);
  return std::sqrt(sum[0]);
}

}  // namespace

CausalCorrection::CausalCorrection(FixedPoint& fixedPoint, substructure::Precision precision)
    : fixedPoint_(fixedPoint),
      finest_(fixedPoint.assembly().softens() ? substructure::Precision::exact : precision),
      allowed_(finest_),
      lines_(fixedPoint.assembly(), fixedPoint.searchDirection(), fixedPoint.layout()),
      steps_(static_cast<std::size_t>(fixedPoint.assembly().steps())) {}

double CausalCorrection::evaluate(int step) {
  std::fill_n(residual_[step], residual_.numRows(), 0.0);  // a rank without bodies has a row that nothing writes
  fixedPoint_.pointwiseStage().solveColumn(step, beta_, residual_);  // f^ first
  const double* alpha = (*alpha_)[step];
  for (int row = 0; row < alpha_->numRows(); ++row) {
    residual_[step][row] = 2.0 * residual_[step][row] - beta_[step][row] - alpha[row];
  }
  base::Matrix column(Teuchos::View, residual_[step], residual_.stride(), residual_.numRows(), 1);
  fixedPoint_.linearStage().unfelt().remove(column);
  return scaledNorm(fixedPoint_.metric(), residual_[step], nullptr);
}

bool CausalCorrection::takeStep(int step, const CorrectionSpace::LeastSquares& direction) {
  Step& here = steps_[step];
  const int rows = alpha_->numRows();
  double* state = (*alpha_)[step];
  const std::vector<double> alpha(state, state + rows), beta(beta_[step], beta_[step] + rows);
  double length = 1.0;
  for (int halving = 0; halving <= halvings; ++halving, length *= 0.5) {
    here.tangent->space().move(direction.c, length, state, beta_[step]);
    const double reached = evaluate(step);
    if (reached < here.residual) {
      here.isStale = length < 1.0 || reached > misprediction * direction.left;
      here.residual = reached;
      return true;
    }
    std::copy_n(alpha.begin(), rows, state);
    std::copy_n(beta.begin(), rows, beta_[step]);
  }
  evaluate(step);  // the local stage must have met the state that is kept
  here.isStale = true;
  return false;
}

void CausalCorrection::reduce(int step) {
  Step& here = steps_[step];
  here.residual = evaluate(step);
  const double enough = here.isLeft ? noise_ : targetOf(here);
  for (int i = 0; i < gaussNewtonSteps && here.tangent->space().size() > 0 && here.residual > enough; ++i) {
    const bool isFresh = here.isStale;
    if (isFresh) {
      here.tangent->differentiate(step, fixedPoint_.pointwiseStage());
      here.isStale = false;
    }
    here.tangent->restore();
    const CorrectionSpace::LeastSquares direction = here.tangent->space().solve(residual_[step]);
    if (direction.left > worthwhile * here.residual) break;
    if (!takeStep(step, direction) && isFresh) break;
  }
  here.moved = scaledNorm(fixedPoint_.metric(), (*alpha_)[step], start_.read(step));
  fixedPoint_.pointwiseStage().accept();
}

void CausalCorrection::sweep(int first) {
  PointwiseLocalStage& local = fixedPoint_.pointwiseStage();
  if (first < first_) {
    local.startUnloaded();
    first_ = 0;
  }
  local.begin();
  if (first > first_) {
    for (; first_ < first; ++first_) {
      evaluate(first_);
      local.accept();
    }
    local.startFromHere();
    local.begin();
  }
  for (int t = first; t < end_; ++t) reduce(t);
}

double CausalCorrection::longestWay() const {
  double longest = 0.0;
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    const bool isAhead = static_cast<int>(t) >= end_;
    longest = std::max(longest, isAhead ? leastWay * steps_[t].residual : steps_[t].moved);
  }
  return longest;
}

double CausalCorrection::targetOf(const Step& step) const {
  const double most = step.weight * step.share * before_;
  if (!isLater_ || step.directions >= mostDirections) return most;
  return std::clamp(step.share * step.before, leastTarget * most, most);
}

double CausalCorrection::smallestSingularValue(const Step& step) {
  return step.tangent ? std::min(step.steepness, step.tangent->space().smallestSingularValue()) : step.steepness;
}

std::vector<int> CausalCorrection::unfinished() {
  std::vector<int> result;
  const double way = longestWay();
  for (int t = begin_; t < end_; ++t) {
    Step& step = steps_[t];
    step.isLeft = step.residual > noise_ &&
                  (step.residual > targetOf(step) || step.residual > allowedToHide * smallestSingularValue(step) * way);
    if (step.isLeft) {
      result.push_back(t);
    } else {
      step.tangent->release();
    }
  }
  return result;
}

std::vector<int> CausalCorrection::foremost(const std::vector<int>& steps) const {
  if (!isLater_) return steps;
  std::vector<int> result;
  std::copy_if(steps.begin(), steps.end(), std::back_inserter(result),
               [this](int t) { return steps_[t].residual > targetOf(steps_[t]); });
  if (!result.empty()) return result;
  const auto hidden = [this](int t) { return steps_[t].residual / smallestSingularValue(steps_[t]); };
  double most = 0.0;
  for (const int t : steps) most = std::max(most, hidden(t));
  std::copy_if(steps.begin(), steps.end(), std::back_inserter(result),
               [&](int t) { return hidden(t) >= hidesMuch * most; });
  return result;
}

substructure::Precision CausalCorrection::precision() {
  if (allowed_ == substructure::Precision::exact) return allowed_;
  // The image of a direction has this relative error, and a step goes along it as far as its residual asks for.
  double way = longestWay(), least = 1.0;
  for (const Step& step : steps_) {
    way = std::max(way, wayOfResidual * step.residual);
    least = std::min(least, step.weight * step.share);
  }
  return fixedPoint_.prepareSingle() * way <= negligible * least * before_ ? substructure::Precision::single
                                                                           : substructure::Precision::exact;
}

bool CausalCorrection::extend(const std::vector<int>& steps) {
  const int rows = alpha_->numRows();
  std::vector<int> selected;
  std::vector<std::vector<double>> directions;
  for (const int t : steps) {
    Step& step = steps_[t];
    std::vector<double> v(residual_[t], residual_[t] + rows);
    if (!step.tangent->space().makeIndependent(v.data()) && !(!step.isStale && step.tangent->continueKrylov(v))) {
      step.isStale = true;
      continue;
    }
    selected.push_back(t);
    directions.push_back(std::move(v));
  }
  if (selected.empty()) return false;
  const int count = static_cast<int>(selected.size());
  base::Matrix shifted(rows, count), image(rows, count);
  std::vector<double> lengths;
  for (int i = 0; i < count; ++i) {
    const int t = selected[i];
    // As large as the state itself, so that the difference has its digits.
    const double* start = start_.read(t);
    const double size = std::max(scaledNorm(fixedPoint_.metric(), start, nullptr), steps_[t].residual);
    for (int row = 0; row < rows; ++row) shifted[i][row] = start[row] + size * directions[i][row];
    lengths.push_back(size);
  }
  const substructure::Precision used = precision();
  isRough_ = isRough_ || used == substructure::Precision::single;
  fixedPoint_.solveLinear(selected, shifted, image, used);
  for (int i = 0; i < count; ++i) {
    const int t = selected[i];
    const double* start = startImage_.read(t);
    for (int row = 0; row < rows; ++row) image[i][row] = (image[i][row] - start[row]) / lengths[i];
    if (!steps_[t].isStale) steps_[t].tangent->restore();
    steps_[t].tangent->add(directions[i].data(), image[i], !steps_[t].isStale);
    ++steps_[t].directions;
  }
  return true;
}

double CausalCorrection::largestResidual(int begin, int end) const {
  double largest = 0.0;
  for (int t = begin; t < end; ++t) largest = std::max(largest, steps_[t].residual / steps_[t].weight);
  return largest;
}

double CausalCorrection::hidden() const {
  const double way = longestWay();
  double largest = 0.0;
  for (const Step& step : steps_) {
    if (step.residual <= noise_) continue;
    const double seen = smallestSingularValue(step) * way;
    largest = std::max(largest, seen > 0.0 ? step.residual / seen : std::numeric_limits<double>::infinity());
  }
  return largest;
}

void CausalCorrection::start(const Iterate& iterate, base::Matrix& alpha) {
  const FixedPoint::AllStepsAtEnd restore(fixedPoint_);
  alpha_ = &alpha;
  start_ = fixedPoint_.store(alpha.numRows());
  startImage_ = fixedPoint_.store(alpha.numRows());
  for (int t = 0; t < alpha.numCols(); ++t) {
    start_.write(t, alpha[t]);
    startImage_.write(t, iterate.beta()[t]);
  }
  beta_ = iterate.beta();
  fixedPoint_.releaseFields();
  residual_.shapeUninitialized(alpha.numRows(), alpha.numCols());
  const std::vector<double> squares = fixedPoint_.metric().squaredNorms(alpha);
  first_ = 0;
  noise_ = fixedPoint_.roundOff(std::sqrt(*std::max_element(squares.begin(), squares.end())));
  fixedPoint_.pointwiseStage().begin();
  for (int t = 0; t < alpha.numCols(); ++t) {
    steps_[t].residual = steps_[t].before = evaluate(t);
    steps_[t].moved = 0.0;
    steps_[t].directions = 0;
    steps_[t].isLeft = true;
    fixedPoint_.pointwiseStage().accept();
  }
}

void CausalCorrection::finish() {
  for (base::ColumnStore* field : {&start_, &startImage_}) *field = base::ColumnStore();
  for (base::Matrix* field : {&beta_, &residual_}) *field = base::Matrix();
}

void CausalCorrection::approach(int stages) {
  // All load steps are met from the unloaded state again at the end, also when a law throws.
  const FixedPoint::AllStepsAtEnd restore(fixedPoint_);
  fixedPoint_.releaseFields();
  first_ = 0;
  const int steps = alpha_->numCols(), first = fixedPoint_.linearStage().stages();
  for (begin_ = 0; begin_ < steps; begin_ = end_) {
    end_ = std::min(begin_ + stepsAtOnce, steps);
    for (int t = begin_; t < end_; ++t) {
      if (!steps_[t].tangent) steps_[t].tangent.emplace(fixedPoint_, lines_);
    }
    approachTogether(stages - (fixedPoint_.linearStage().stages() - first));
    if (steps <= stepsAtOnce) continue;
    for (int t = begin_; t < end_; ++t) {
      steps_[t].steepness = smallestSingularValue(steps_[t]);
      steps_[t].tangent.reset();
      steps_[t].isStale = true;
    }
  }
}

void CausalCorrection::approachTogether(int stages) {
  sweep(begin_);
  const int first = fixedPoint_.linearStage().stages();
  std::vector<double> residuals{largestResidual(begin_, end_)};  // after every linear stage
  for (std::vector<int> left = unfinished(); !left.empty(); left = unfinished()) {
    if (fixedPoint_.linearStage().stages() - first >= stages || !(extend(foremost(left)) || extend(left))) break;
    sweep(left.front());
    residuals.push_back(largestResidual(begin_, end_));
    if (residuals.size() > patience && residuals.back() > slow * residuals[residuals.size() - 1 - patience]) break;
  }
}

bool CausalCorrection::sharpen(const Goal& goal) {
  // What is left of the ways when the residuals have fallen as much as they did.
  std::vector<double> left = fieldDistances(fixedPoint_.metric(), *alpha_, beta_, start_, startImage_);
  for (double& error : left) error *= goal.reduction;
  if (!(*std::max_element(left.begin(), left.end()) > nearEnough * goal.error)) return false;
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    if (left[t] > 0.0) steps_[t].weight *= std::clamp(shareOfError * goal.error / left[t], furthest, 1.0);
  }
  return true;
}

const Iterate& CausalCorrection::verify(base::Matrix& image) {
  for (base::Matrix* field : {&beta_, &residual_}) *field = base::Matrix();  // room for both stages
  const Iterate& iterate = fixedPoint_.apply(*alpha_, image);
  const int rows = image.numRows();
  for (int first = 0; first < image.numCols(); first += stepsAtOnce) {
    const int count = std::min(stepsAtOnce, image.numCols() - first);
    base::Matrix residual(Teuchos::Copy, image, rows, count, 0, first);
    residual -= base::Matrix(Teuchos::View, *alpha_, rows, count, 0, first);
    fixedPoint_.linearStage().unfelt().remove(residual);
    for (int j = 0; j < count; ++j) {
      steps_[first + j].residual = scaledNorm(fixedPoint_.metric(), residual[j], nullptr);
    }
  }
  return iterate;
}

bool CausalCorrection::settleThoseNear(const Goal& goal) {
  const std::vector<double> distances = fieldDistances(fixedPoint_.metric(), *alpha_, beta_, start_, startImage_);
  bool areAllSettled = true;
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    if (distances[t] <= goal.near) continue;
    steps_[t].share = goal.reduction;
    areAllSettled = false;
  }
  return areAllSettled;
}

CausalCorrection::Result CausalCorrection::correct(const Iterate& iterate, base::Matrix& alpha, base::Matrix& image,
                                                   const Goal& goal, int stages) {
  start(iterate, alpha);
  before_ = largestResidual();
  Result result;
  result.shares.assign(steps_.size(), 0.0);
  if (before_ <= noise_) {
    finish();
    result.reduction = 0.0;
    return result;
  }
  allowed_ = finest_;
  isLater_ = goal.roughly > goal.reduction;
  std::vector<double> weights;
  for (Step& step : steps_) {
    step.share = std::max(goal.reduction, goal.roughly);
    weights.push_back(step.weight);
  }
  const int first = fixedPoint_.linearStage().stages();
  const auto goOn = [&] { approach(stages - (fixedPoint_.linearStage().stages() - first)); };
  goOn();
  if (isLater_ && !settleThoseNear(goal)) goOn();
  if (sharpen(goal)) goOn();
  if (isRough_) {
    double said = largestResidual();
    for (const Step& step : steps_) said = std::max(said, step.share * before_);
    result.iterate = &verify(image);
    if (!(largestResidual() <= promised * said)) {
      allowed_ = substructure::Precision::exact;
      beta_ = result.iterate->beta();
      residual_.shapeUninitialized(beta_.numRows(), beta_.numCols());
      goOn();
      result.iterate = nullptr;
    }
  }
  result.hidden = hidden();
  result.reduction = 0.0;
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    const double left = steps_[t].residual > noise_ ? steps_[t].residual / (weights[t] * before_) : 0.0;
    result.shares[t] = std::max(left, std::min(steps_[t].share, steps_[t].residual / steps_[t].before));
    result.reduction = std::max(result.reduction, left);
  }
  finish();
  return result;
}

}  // namespace harmos::latin
