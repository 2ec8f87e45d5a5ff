#include <harmos/latin/StepNewton.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/latin/detail/FaintMotions.hpp>
#include <harmos/latin/detail/SoftMotions.hpp>

namespace harmos::latin {
namespace {

// Of the residual, that least squares may leave: of the first step, and when the last one has gained more.
constexpr double firstForcing = 0.5;
constexpr double leastForcing = 0.1;
constexpr int mostHalvings = 5;
// Directions where laws soften, at most, and numbers that their v have together.
constexpr double mostWhereLawsSoften = 800.0;
constexpr double numbersWhereLawsSoften = 4e6;
// Of the residual: when all directions that there are leave as much, the state is one that Newton's method cannot
// leave.
constexpr double stuck = 0.999;
// More than this share left, and not to be reduced: nothing resists the motion that it stands for.
constexpr double unanswered = 0.75;
// It has been answered when no more than this share of it is left along itself.
constexpr double answered = 0.5;
// Share of it that round-off must not reach on the way.
constexpr double visible = 1e-3;
// A step has gone too far when R points back along it by more than this share of what it did forth at its beginning,
// and ends where it points by less than the next share, either way.
constexpr double tooFar = 0.5;
constexpr double closeEnough = 0.1;
constexpr int maximumLooks = 40;
constexpr int maximumSteps = 60;
// Steps in which the best residual must fall to a share.
constexpr int longPatience = 20;
constexpr int shortPatience = 5;
constexpr double progress = 0.9;
// Of a way in pseudo-time: steps, errors of the implicit Euler method over |R| and what they make of the next step.
constexpr int mostTimeSteps = 300;
// Where no law softens, Newton's method mostly is enough: so many, none that is shorter, and none after a longer one,
// in which a body slides without end.
constexpr int fewTimeSteps = 60;
constexpr double leastTime = 1e-4;
constexpr double longestTime = 1e6;
// Nothing moves any more in steps so short, and their tangent would overflow.
constexpr double noTime = 1e-12;
constexpr double largestTimeError = 0.5;
constexpr double smallTimeError = 0.1;
constexpr double shorterTime = 0.25;
constexpr double longerTime = 2.0;
constexpr double muchLongerTime = 8.0;

}  // namespace

StepNewton::StepNewton(FixedPoint& fixedPoint)
    : fixedPoint_(fixedPoint),
      isDamped_(fixedPoint.assembly().softens()),
      lines_(fixedPoint.assembly(), fixedPoint.searchDirection(), fixedPoint.layout()) {
  if (!isDamped_) return;
  std::vector<double> rows{static_cast<double>(fixedPoint.layout().rows())};
  fixedPoint.metric().sum(rows);
  most_ =
      static_cast<int>(std::clamp<double>(numbersWhereLawsSoften / rows[0], maximumDirections, mostWhereLawsSoften));
}

StepNewton::~StepNewton() = default;

double StepNewton::evaluate() {
  fixedPoint_.pointwiseStage().begin();
  for (std::size_t row = 0; row < offset_.size(); ++row) shifted_[0][row] = beta_[0][row] + offset_[row];
  const base::Matrix& beta = offset_.empty() ? beta_ : shifted_;
  fixedPoint_.pointwiseStage().solveColumn(0, beta, traction_);
  for (int row = 0; row < alpha_.numRows(); ++row) {
    residual_[0][row] = 2.0 * traction_[0][row] - beta[0][row] - alpha_[0][row];
  }
  fixedPoint_.linearStage().unfelt().remove(residual_);
  return fixedPoint_.metric().norm(residual_);
}

bool StepNewton::extend(std::vector<double> v) {
  if (space().size() >= most_) return false;
  if (!space().makeIndependent(v.data()) && !tangent_->continueKrylov(v)) return false;
  tangent_->add(v.data(), imageOf(v.data()).data(), true);
  return true;
}

std::vector<double> StepNewton::imageOf(const double* v) {
  const int rows = alpha_.numRows();
  base::Matrix shifted(rows, 1), image(rows, 1);
  // As large as the state itself, so that the difference has its digits.
  const double size = std::max(fixedPoint_.metric().norm(start_), fixedPoint_.metric().norm(residual_));
  for (int row = 0; row < rows; ++row) shifted[0][row] = start_[0][row] + size * v[row];
  fixedPoint_.solveLinear(shifted, image);
  for (int row = 0; row < rows; ++row) image[0][row] = (image[0][row] - startImage_[0][row]) / size;
  return {image[0], image[0] + rows};
}

bool StepNewton::settleSoftMotions(base::Matrix& state, double target) {
  if (!isDamped_ || fixedPoint_.assembly().path) return true;
  if (!softMotions_) softMotions_ = std::make_unique<SoftMotions>(fixedPoint_);
  if (softMotions_->isEmpty()) return true;
  const double size = evaluate();
  if (size == 0.0) return true;
  PairTangents tangents(fixedPoint_.assembly(), lines_);  // those of the space would ask for all its g anew
  fixedPoint_.pointwiseStage().differentiateColumn(0, tangents);
  const FaintMotions motions =
      motionsBesideSpace(*softMotions_, tangents, fixedPoint_.metric(), [&](const double* v) { return imageOf(v); });
  if (motions.isEmpty()) return true;
  fromAlpha_.assign(alpha_);
  fromBeta_.assign(beta_);
  const double way = motions.move(residual_[0], alpha_[0], beta_[0]);
  const bool isAstray = way > FaintMotions::farthest * fixedPoint_.metric().norm(fromAlpha_);
  if (!isAstray && evaluate() <= std::max(size, enough(target))) {
    state.assign(alpha_);
    return true;
  }
  alpha_.assign(fromAlpha_);
  beta_.assign(fromBeta_);
  evaluate();  // the local stage must have met the state that is kept
  return !isAstray;
}

CorrectionSpace::LeastSquares StepNewton::leastSquares(double enough) {
  const auto fit = [&] {
    return space().size() > maximumDirections ? space().solveDamped(residual_[0]) : space().solve(residual_[0]);
  };
  CorrectionSpace::LeastSquares result = fit();
  while (result.left > enough) {
    std::vector<double> left(residual_[0], residual_[0] + residual_.numRows());
    tangent_->subtract(result.c, left);
    if (!extend(std::move(left))) break;
    result = fit();
  }
  return result;
}

void StepNewton::moveFrom(const std::vector<double>& c, double length) {
  alpha_.assign(fromAlpha_);
  beta_.assign(fromBeta_);
  space().move(c, length, alpha_[0], beta_[0]);
}

double StepNewton::step(const std::vector<double>& c, double size) {
  const StateMetric& metric = fixedPoint_.metric();
  base::Matrix way(alpha_.numRows(), 1), unused(alpha_.numRows(), 1);
  space().move(c, 1.0, way[0], unused[0]);
  const double begin = metric.dot(residual_, way);
  moveFrom(c, 1.0);
  double reached = evaluate();
  double end = metric.dot(residual_, way);
  if (reached < size || !(begin > 0.0) || !(end < -tooFar * begin)) return reached;
  double low = 0.0, high = 1.0, forth = begin;
  for (int look = 0; look < maximumLooks; ++look) {
    // Halves in turns with secants, which stay at one end where R has a kink.
    const double length = look % 2 == 0 ? 0.5 * (low + high) : low + (high - low) * forth / (forth - end);
    moveFrom(c, length);
    reached = evaluate();
    const double along = metric.dot(residual_, way);
    if (std::abs(along) <= closeEnough * begin) break;
    (along > 0.0 ? low : high) = length;
    (along > 0.0 ? forth : end) = along;
  }
  return reached;
}

double StepNewton::wholeStep(const std::vector<double>& c) {
  moveFrom(c, 1.0);
  return evaluate();
}

double StepNewton::dampedStep(const std::vector<double>& c, double size) {
  double best = 0.0, least = 0.0, length = 1.0;
  for (int halving = 0; halving <= mostHalvings; ++halving, length *= 0.5) {
    moveFrom(c, length);
    const double reached = evaluate();
    if (reached < size) return reached;
    if (halving > 0 && !(reached < least)) continue;
    best = length;
    least = reached;
  }
  moveFrom(c, best);
  return evaluate();
}

std::optional<double> StepNewton::follow(std::vector<double> c) {
  const StateMetric& metric = fixedPoint_.metric();
  const int rows = alpha_.numRows();
  std::vector<double> left(residual_[0], residual_[0] + rows);
  tangent_->subtract(c, left);
  extend(left);  // unless the space holds it
  c.resize(space().size(), 0.0);
  moveFrom(c, 1.0);
  fromAlpha_.assign(alpha_);
  fromBeta_.assign(beta_);
  base::Matrix motion(rows, 1);
  std::copy(left.begin(), left.end(), motion[0]);
  const double squared = metric.dot(motion, motion);
  const std::vector<double> along = space().coefficients(left.data());
  for (double length = 1.0;; length *= 2.0) {
    moveFrom(along, length);
    const double reached = evaluate();
    if (metric.dot(residual_, motion) < answered * squared) return reached;
    if (fixedPoint_.roundOff(metric.norm(alpha_)) > visible * std::sqrt(squared)) return std::nullopt;
  }
}

StepNewton::Result StepNewton::solve(base::Matrix& state, const base::Matrix& beta, double target,
                                     const std::function<bool()>& mustStop) {
  if (!tangent_ || scale_ != fixedPoint_.searchDirectionScale()) forget();
  const bool isFull = space().size() >= most_;
  offset_.clear();
  const Effort effort{maximumSteps, longPatience};
  Result result = attempt(state, beta, target, effort, StepLength::damped, mustStop);
  if (result.isReached || !isFull || (mustStop && mustStop())) return result;
  // What it holds are the directions of other states.
  forget();
  return attempt(state, beta, target, effort, StepLength::damped, mustStop);
}

StepNewton::Result StepNewton::solveWith(const base::Matrix& offset, base::Matrix& state, base::Matrix& beta,
                                         double target, int steps, StepLength length,
                                         const std::function<bool()>& mustStop) {
  if (!tangent_ || scale_ != fixedPoint_.searchDirectionScale() || space().size() >= most_) forget();
  offset_.assign(offset[0], offset[0] + offset.numRows());
  shifted_.shape(offset.numRows(), 1);
  // On its way a whole step may make |R| greater before it makes it small.
  const Effort effort{steps, length == StepLength::damped ? shortPatience : steps};
  Result result = attempt(state, beta, target, effort, length, mustStop);
  if (!result.isReached && space().size() >= most_ && !(mustStop && mustStop())) {
    forget();  // many of them are those of other states
    result = attempt(state, beta, target, effort, length, mustStop);
  }
  if (result.isReached) beta.assign(beta_);
  return result;
}

void StepNewton::forget() {
  tangent_.emplace(fixedPoint_, lines_, substructure::Precision::exact);
  if (scale_ != fixedPoint_.searchDirectionScale()) softMotions_.reset();
  scale_ = fixedPoint_.searchDirectionScale();
}

void StepNewton::begin(const base::Matrix& state, const base::Matrix& beta) {
  for (base::Matrix* field :
       {&start_, &startImage_, &alpha_, &beta_, &traction_, &residual_, &fromAlpha_, &fromBeta_}) {
    field->shape(state.numRows(), 1);
  }
  for (base::Matrix* field : {&start_, &alpha_}) field->assign(state);
  for (base::Matrix* field : {&startImage_, &beta_}) field->assign(beta);
}

double StepNewton::enough(double target) const {
  return std::max(target, fixedPoint_.roundOff(fixedPoint_.metric().norm(alpha_)));
}

StepNewton::Result StepNewton::settle(base::Matrix& state, const base::Matrix& beta, double target,
                                      const std::function<bool()>& mustStop) {
  if (!tangent_ || scale_ != fixedPoint_.searchDirectionScale()) forget();
  offset_.clear();
  begin(state, beta);
  const StateMetric& metric = fixedPoint_.metric();
  base::Matrix left(state.numRows(), 1);
  Result result;
  result.residual = evaluate();
  double time = 1.0, lastError = 0.0;
  const int most = isDamped_ ? mostTimeSteps : fewTimeSteps;
  for (int number = 0; number < most && !(result.residual <= enough(target)); ++number) {
    if (time < (isDamped_ ? noTime : leastTime) || (!isDamped_ && time > longestTime)) break;
    if (mustStop && mustStop()) break;
    tangent_->differentiate(0, fixedPoint_.pointwiseStage(), 1.0 / time);
    const CorrectionSpace::LeastSquares direction = leastSquares(leastForcing * result.residual);
    fromAlpha_.assign(alpha_);
    fromBeta_.assign(beta_);
    const double reached = wholeStep(direction.c);
    for (int row = 0; row < left.numRows(); ++row) {
      left(row, 0) = residual_(row, 0) - (alpha_(row, 0) - fromAlpha_(row, 0)) / time;
    }
    const double error = metric.norm(left) / result.residual;
    if (error > largestTimeError) {
      moveFrom(direction.c, 0.0);
      evaluate();
      time *= shorterTime;
      continue;
    }
    result.residual = reached;
    lastError = error;
    time *= error > smallTimeError ? longerTime : muchLongerTime;
  }
  result.isReached = result.residual <= enough(target);
  if (result.isReached) state.assign(alpha_);
  if (!result.isReached && !isDamped_ && time > longestTime && lastError <= smallTimeError) result.slide = alpha_;
  return result;
}

StepNewton::Result StepNewton::attempt(base::Matrix& state, const base::Matrix& beta, double target,
                                       const Effort& effort, StepLength length, const std::function<bool()>& mustStop) {
  begin(state, beta);
  Result result;
  result.residual = evaluate();
  double best = result.residual, last = result.residual, forcing = isDamped_ ? leastForcing : firstForcing;
  int number = 0;
  for (int sinceBest = 0; number < effort.steps && sinceBest < effort.patience; ++number) {
    const double goal = enough(target);
    if (result.residual <= goal) break;
    if (mustStop && mustStop()) break;
    tangent_->differentiate(0, fixedPoint_.pointwiseStage());
    const double size = result.residual;
    const CorrectionSpace::LeastSquares direction =
        leastSquares(size * std::max(forcing, std::min(firstForcing, 0.5 * goal / size)));
    if (isDamped_ && direction.left > stuck * size) break;
    fromAlpha_.assign(alpha_);
    fromBeta_.assign(beta_);
    std::optional<double> reached;
    if (isDamped_) {
      reached = length == StepLength::damped ? dampedStep(direction.c, size) : wholeStep(direction.c);
    } else {
      reached = direction.left > unanswered * size ? follow(direction.c) : step(direction.c, size);
    }
    if (!reached) break;
    result.residual = *reached;
    const double gain = result.residual / last;
    if (!isDamped_) forcing = std::clamp(gain * gain, leastForcing, firstForcing);
    last = result.residual;
    sinceBest = result.residual < progress * best ? 0 : sinceBest + 1;
    best = std::min(best, result.residual);
  }
  if (number > 0) result.smallestSingularValue = space().smallestSingularValue();
  result.isReached = result.residual <= enough(target);
  if (result.isReached) state.assign(alpha_);
  return result;
}

}  // namespace harmos::latin
