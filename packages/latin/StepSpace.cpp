#include <harmos/latin/detail/StepSpace.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <harmos/latin/detail/SelfStresses.hpp>

namespace harmos::latin {
namespace {

// Resistance that images in single precision do not tell from nothing.
constexpr double faintest = 1e-6;
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
  for (SoftMotions::Motion& motion : softMotions_.find(tangent_->tangents(), SoftMotions::hardest)) {
    if (motion.resistance < (softMotions_.isLeftToLaws(motion) ? faintest : SoftMotions::lost)) {
      faint_.add(softMotions_.state(motion), softMotions_.image(motion),
                 softMotions_.change(tangent_->tangents(), motion));
    } else if (!holds(motion)) {
      soft_.push_back(std::move(motion));
    }
  }
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
