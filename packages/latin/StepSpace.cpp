#include <harmos/latin/detail/StepSpace.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <harmos/latin/detail/SelfStresses.hpp>

namespace harmos::latin {
namespace {

// Resistance of motions of the parts that a space is to hold. Others are found soon enough by residuals.
constexpr double soft = 0.02;
// Resistance that images in single precision do not tell from nothing.
constexpr double faintest = 1e-6;
// That which least squares leave out.
constexpr double lost = 2e-7;
// Of the square of a motion: what a space that holds it may lack.
constexpr double lacking = 0.1;

}  // namespace

void StepSpace::open(InterfaceLines& lines) {
  TangentSpace& tangent = tangent_.emplace(fixedPoint_, lines);
  const SelfStresses& stresses = fixedPoint_.selfStresses();
  for (const int position : stresses.stiff()) {
    std::vector<double> v = stresses.field(position);
    if (tangent.space().makeIndependent(v.data())) tangent.add(v.data(), v.data(), false);
  }
}

void StepSpace::close() {
  closed_ = softest();
  tangent_.reset();
  soft_.clear();
  faint_.clear();
  isStale_ = true;
}

bool StepSpace::holds(const SoftMotions::Motion& motion) const {
  const std::vector<double> shares = space().coefficients(softMotions_.state(motion).data());
  return std::inner_product(shares.begin(), shares.end(), shares.begin(), 0.0) > 1.0 - lacking;
}

void StepSpace::differentiate(int step) {
  tangent_->differentiate(step, fixedPoint_.pointwiseStage());
  isStale_ = false;
  soft_.clear();
  faint_.clear();
  for (SoftMotions::Motion& motion : softMotions_.find(tangent_->tangents(), soft)) {
    if (motion.resistance < (softMotions_.isLeftToLaws(motion) ? faintest : lost)) {
      faint_.push_back(faint(motion));
    } else if (!holds(motion)) {
      soft_.push_back(std::move(motion));
    }
  }
}

StepSpace::Faint StepSpace::faint(const SoftMotions::Motion& motion) const {
  const StateMetric& metric = fixedPoint_.metric();
  Faint result{softMotions_.state(motion), softMotions_.added(motion),
               softMotions_.change(tangent_->tangents(), motion)};
  std::vector<double> square{0.0};
  for (std::size_t row = 0; row < result.state.size(); ++row) {
    square[0] += metric.scale()[row] * metric.scale()[row] * result.change[row] * result.change[row];
    result.image[row] -= result.state[row];
  }
  metric.sum(square);
  for (double& x : result.change) x /= square[0];
  return result;
}

double StepSpace::moveAlongFaint(const double* residual, double* alpha, double* beta) const {
  const std::vector<double>& scale = fixedPoint_.metric().scale();
  std::vector<double> ways(faint_.size(), 0.0);
  for (std::size_t i = 0; i < faint_.size(); ++i) {
    for (std::size_t row = 0; row < scale.size(); ++row) {
      ways[i] += scale[row] * scale[row] * faint_[i].change[row] * residual[row];
    }
  }
  fixedPoint_.metric().sum(ways);
  for (std::size_t i = 0; i < faint_.size(); ++i) {
    for (std::size_t row = 0; row < scale.size(); ++row) {
      alpha[row] += ways[i] * faint_[i].state[row];
      beta[row] += ways[i] * faint_[i].image[row];
    }
  }
  // The v are orthonormal.
  return std::sqrt(std::inner_product(ways.begin(), ways.end(), ways.begin(), 0.0));
}

std::optional<std::vector<double>> StepSpace::nextMotion() {
  while (!soft_.empty()) {
    std::vector<double> v = softMotions_.state(soft_.front());
    soft_.erase(soft_.begin());
    if (space().makeIndependent(v.data())) return v;
  }
  return std::nullopt;
}

std::optional<std::vector<double>> StepSpace::nextDirection(const double* residual) {
  std::vector<double> v(residual, residual + space().rows());
  if (space().makeIndependent(v.data()) || (!isStale_ && tangent_->continueKrylov(v))) return v;
  isStale_ = true;
  return std::nullopt;
}

void StepSpace::add(const double* v, const double* y) {
  if (!isStale_) tangent_->restore();
  tangent_->add(v, y, !isStale_);
}

double StepSpace::smallestSingularValue() const {
  return tangent_ ? std::min(closed_, space().smallestSingularValue()) : closed_;
}

double StepSpace::softest() const {
  const double smallest = smallestSingularValue();
  return soft_.empty() ? smallest : std::min(smallest, soft_.front().resistance);
}

}  // namespace harmos::latin
