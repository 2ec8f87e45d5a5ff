#include <harmos/latin/CausalCorrection.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <harmos/latin/March.hpp>
#include <harmos/latin/StepsAtOnce.hpp>
#include <harmos/latin/detail/FaintMotions.hpp>
#include <harmos/latin/detail/FieldDistances.hpp>
#include <harmos/latin/detail/SelfStresses.hpp>
#include <harmos/latin/detail/SoftMotions.hpp>
#include <harmos/latin/detail/StepSpace.hpp>
#include <harmos/latin/detail/UnfinishedSteps.hpp>

namespace harmos::latin {
namespace {

// Gauss-Newton steps of a load step after each linear stage.
constexpr int gaussNewtonSteps = 3;
constexpr int halvings = 2;
// A Gauss-Newton step that leaves more than this share of the residual is not worth its local stages.
constexpr double worthwhile = 0.999;
// Growth of a residual that is round-off.
constexpr double unnoticed = 1e-9;
// Times the residual that the tangent predicts, from which on it is found anew.
constexpr double misprediction = 2.0;
// Of the residual that is gone for: errors of single precision that hardly change anything.
constexpr double negligible = 0.1;
// Ways over the residuals, at least, that are reckoned with before directions are known.
constexpr double wayOfResidual = 100.0;
// Times what the images have promised that the true residual may be.
constexpr double promised = 1.25;
// Linear stages, each of some load steps, in which the largest residual must fall to this share; fewer where all have
// come to their targets, and only too much could be hidden, and of many load steps, which would wait some after others.
constexpr std::size_t patience = 40;
constexpr std::size_t lessPatience = 15;
constexpr double slow = 0.8;
// Least singular values below this one tell soft modes that are worth their room: what two corrections meet of them in
// new spaces differs, and with it what the residual can hide.
constexpr double steep = 0.1;

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
      softMotions_(std::make_unique<SoftMotions>(fixedPoint)),
      steps_(static_cast<std::size_t>(fixedPoint.assembly().steps()), StepSpace(fixedPoint, *softMotions_)),
      targets_(fixedPoint.assembly().steps()),
      unfinished_(std::make_unique<UnfinishedSteps>(targets_, steps_)) {}

CausalCorrection::~CausalCorrection() = default;

double CausalCorrection::solveLocal(int step) {
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

double CausalCorrection::evaluate(int step) {
  const double size = solveLocal(step);
  const auto add = [&](const std::vector<double>& s) {
    for (std::size_t row = 0; row < s.size(); ++row) {
      (*alpha_)[step][row] += s[row];
      beta_[step][row] += s[row];
    }
    return solveLocal(step);
  };
  return fixedPoint_.selfStresses().settle(fixedPoint_.metric(), residual_[step], size, noise_, add);
}

bool CausalCorrection::tryMove(int step, const std::function<void(double* alpha, double* beta)>& move,
                               const std::function<bool(double reached)>& accepts) {
  const int rows = alpha_->numRows();
  double* state = (*alpha_)[step];
  const std::vector<double> alpha(state, state + rows), beta(beta_[step], beta_[step] + rows);
  move(state, beta_[step]);
  const double reached = evaluate(step);
  if (accepts(reached)) {
    targets_[step].residual = reached;
    return true;
  }
  std::copy_n(alpha.begin(), rows, state);
  std::copy_n(beta.begin(), rows, beta_[step]);
  return false;
}

bool CausalCorrection::takeStep(int step, const CorrectionSpace::LeastSquares& direction) {
  StepSpace& here = steps_[step];
  const double& residual = targets_[step].residual;
  double length = 1.0;
  for (int halving = 0; halving <= halvings; ++halving, length *= 0.5) {
    const auto move = [&](double* alpha, double* beta) { here.space().move(direction.c, length, alpha, beta); };
    if (!tryMove(step, move, [&](double reached) { return reached < residual; })) continue;
    here.setStale(length < 1.0 || residual > misprediction * direction.left);
    return true;
  }
  evaluate(step);  // the local stage must have met the state that is kept
  here.setStale(true);
  return false;
}

void CausalCorrection::reduce(int step) {
  StepSpace& here = steps_[step];
  double& residual = targets_[step].residual;
  residual = evaluate(step);
  const double enough = unfinished_->isLeft(step) ? noise_ : targets_.of(step);
  for (int i = 0; i < gaussNewtonSteps && here.space().size() > 0 && residual > enough; ++i) {
    const bool isFresh = here.isStale();
    if (isFresh) here.differentiate(step);
    here.tangent().restore();
    const CorrectionSpace::LeastSquares direction = here.space().solve(residual_[step]);
    if (direction.left > worthwhile * residual) break;
    if (!takeStep(step, direction) && isFresh) break;
  }
  targets_[step].moved = scaledNorm(fixedPoint_.metric(), (*alpha_)[step], start_.read(step));
  fixedPoint_.pointwiseStage().accept();
}

void CausalCorrection::settleFaintMotions(int step) {
  double& residual = targets_[step].residual;
  residual = evaluate(step);
  if (steps_[step].hasFaintMotions()) {
    const auto move = [&](double* alpha, double* beta) {
      if (steps_[step].faintMotions().move(residual_[step], alpha, beta) > reach_) goesAstray_ = true;
    };
    const auto accepts = [&](double reached) { return !goesAstray_ && reached <= residual * (1.0 + unnoticed); };
    if (!tryMove(step, move, accepts)) evaluate(step);
  }
  fixedPoint_.pointwiseStage().accept();
}

void CausalCorrection::sweep(int first, void (CausalCorrection::*treat)(int step)) {
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
  for (int t = first; t < end_; ++t) (this->*treat)(t);
}

substructure::Precision CausalCorrection::precision() {
  if (allowed_ == substructure::Precision::exact) return allowed_;
  // The image of a direction has this relative error, and a step goes along it as far as its residual asks for.
  double way = targets_.longestWay(end_);
  for (int t = 0; t < alpha_->numCols(); ++t) way = std::max(way, wayOfResidual * targets_[t].residual);
  return fixedPoint_.prepareSingle() * way <= negligible * targets_.leastShare() * targets_.before()
             ? substructure::Precision::single
             : substructure::Precision::exact;
}

bool CausalCorrection::extend(const std::vector<int>& steps) {
  const int rows = alpha_->numRows();
  std::vector<int> selected;
  std::vector<std::vector<double>> directions;
  for (const int t : steps) {
    std::optional<std::vector<double>> v = unfinished_->goForSoftMotions() ? steps_[t].nextMotion() : std::nullopt;
    if (!v) v = steps_[t].nextDirection(residual_[t]);
    if (!v) continue;
    selected.push_back(t);
    directions.push_back(std::move(*v));
  }
  if (selected.empty()) return false;
  const int count = static_cast<int>(selected.size());
  base::Matrix shifted(rows, count), image(rows, count);
  std::vector<double> lengths;
  for (int i = 0; i < count; ++i) {
    const int t = selected[i];
    // As large as the state itself, so that the difference has its digits.
    const double* start = start_.read(t);
    const double size = std::max(scaledNorm(fixedPoint_.metric(), start, nullptr), targets_[t].residual);
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
    steps_[t].add(directions[i].data(), image[i]);
    ++targets_[t].directions;
  }
  return true;
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
  const double size = std::sqrt(*std::max_element(squares.begin(), squares.end()));
  noise_ = fixedPoint_.roundOff(size);
  if (reach_ == 0.0) reach_ = FaintMotions::farthest * size;
  goesAstray_ = false;
  unfinished_->start(noise_);
  fixedPoint_.pointwiseStage().begin();
  for (int t = 0; t < alpha.numCols(); ++t) {
    targets_.start(t, evaluate(t));
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
      if (!steps_[t].isOpen()) steps_[t].open(lines_);
    }
    approachTogether(stages - (fixedPoint_.linearStage().stages() - first));
    if (steps <= stepsAtOnce) continue;
    letGo();
  }
}

void CausalCorrection::letGo() {
  std::vector<std::pair<double, int>> held;  // with the singular values now
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    if (steps_[t].isOpen()) held.emplace_back(steps_[t].space().smallestSingularValue(), static_cast<int>(t));
  }
  std::sort(held.begin(), held.end());
  for (std::size_t i = 0; i < held.size(); ++i) {
    StepSpace& step = steps_[held[i].second];
    if (i < stepsAtOnce && held[i].first < steep) {
      step.tangent().release();
    } else {
      step.close();
    }
  }
}

void CausalCorrection::approachTogether(int stages) {
  sweep(begin_, &CausalCorrection::reduce);
  const int first = fixedPoint_.linearStage().stages();
  std::vector<double> residuals{targets_.largestResidual(begin_, end_)};  // after every linear stage
  const auto unfinished = [this] { return unfinished_->find(begin_, end_); };
  for (std::vector<int> left = unfinished(); !left.empty(); left = unfinished()) {
    const bool isOver = fixedPoint_.linearStage().stages() - first >= stages;
    if (isOver || !(extend(unfinished_->foremost(left)) || extend(left))) break;
    sweep(left.front(), &CausalCorrection::reduce);
    residuals.push_back(targets_.largestResidual(begin_, end_));
    const bool mayWait = alpha_->numCols() <= stepsAtOnce &&
                         std::any_of(left.begin(), left.end(), [this](int t) { return unfinished_->isAbove(t); });
    const std::size_t wait = mayWait ? patience : lessPatience;
    if (residuals.size() > wait && residuals.back() > slow * residuals[residuals.size() - 1 - wait]) break;
  }
  if (std::any_of(steps_.begin() + begin_, steps_.begin() + end_,
                  [](const StepSpace& step) { return step.hasFaintMotions(); })) {
    sweep(begin_, &CausalCorrection::settleFaintMotions);
  }
}

std::vector<double> CausalCorrection::ways() const {
  return fieldDistances(fixedPoint_.metric(), *alpha_, beta_, start_, startImage_);
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
      targets_[first + j].residual = scaledNorm(fixedPoint_.metric(), residual[j], nullptr);
    }
  }
  return iterate;
}

CausalCorrection::Result CausalCorrection::correct(const Iterate& iterate, base::Matrix& alpha, base::Matrix& image,
                                                   const Goal& goal, int stages) {
  start(iterate, alpha);
  Result result;
  if (targets_.largestResidual() <= noise_) {
    finish();
    result.shares.assign(steps_.size(), 0.0);
    result.reduction = 0.0;
    return result;
  }
  allowed_ = finest_;
  targets_.aimAt(goal);
  const int first = fixedPoint_.linearStage().stages();
  const auto goOn = [&] { approach(stages - (fixedPoint_.linearStage().stages() - first)); };
  goOn();
  if (targets_.sharpen(ways(), goal)) goOn();
  if (isRough_) {
    const double said = targets_.promisedResidual();
    result.iterate = &verify(image);
    if (!(targets_.largestResidual() <= promised * said)) {
      allowed_ = substructure::Precision::exact;
      beta_ = result.iterate->beta();
      residual_.shapeUninitialized(beta_.numRows(), beta_.numCols());
      goOn();
      result.iterate = nullptr;
    }
  }
  result.hidden = goesAstray_ ? std::numeric_limits<double>::infinity() : unfinished_->hidden(end_);
  result.shares = targets_.sharesLeft(noise_);
  result.reduction = targets_.reduction(noise_);
  if (!(result.reduction <= 1.0)) {
    for (int t = 0; t < alpha.numCols(); ++t) std::copy_n(start_.read(t), alpha.numRows(), alpha[t]);
  }
  finish();
  return result;
}

}  // namespace harmos::latin
