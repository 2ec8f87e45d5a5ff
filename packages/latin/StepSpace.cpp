#include <harmos/latin/detail/StepSpace.hpp>

#include <algorithm>
#include <numeric>

#include <harmos/latin/detail/SelfStresses.hpp>

namespace harmos::latin {
namespace {

// Resistance of motions of the parts that a space is to hold. Others are found soon enough by residuals.
constexpr double soft = 0.02;
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
  isStale_ = true;
}

bool StepSpace::holds(const SoftMotions::Motion& motion) const {
  const std::vector<double> shares = space().coefficients(softMotions_.state(motion).data());
  return std::inner_product(shares.begin(), shares.end(), shares.begin(), 0.0) > 1.0 - lacking;
}

void StepSpace::differentiate(int step) {
  tangent_->differentiate(step, fixedPoint_.pointwiseStage());
  isStale_ = false;
  soft_ = softMotions_.find(tangent_->tangents(), soft);
  soft_.erase(std::remove_if(soft_.begin(), soft_.end(), [this](const auto& motion) { return holds(motion); }),
              soft_.end());
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
