#include <harmos/latin/CorrectionTargets.hpp>

#include <algorithm>

namespace harmos::latin {
namespace {

// Of what is gone for: the least residual that a load step which has begun with less than that is brought to.
constexpr double leastTarget = 0.1;
// New directions after which that is given up: what is left may be round-off.
constexpr int mostDirections = 20;
// The least way over the residual: T brings no two points farther apart.
constexpr double leastWay = 0.5;
// Times the error that is gone for, that the way of a load step may tell before the correction goes on; share of that
// error that each load step then goes for, and least share of the reduction that it goes to.
constexpr double nearEnough = 1.5;
constexpr double shareOfError = 0.5;
constexpr double furthest = 0.1;

}  // namespace

void CorrectionTargets::start(int step, double residual) {
  LoadStep& here = steps_[step];
  here.residual = here.before = residual;
  here.moved = 0.0;
  here.directions = 0;
}

void CorrectionTargets::aimAt(const Goal& goal) {
  before_ = largestResidual();
  reduction_ = goal.reduction;
  isLater_ = goal.isLater;
  weights_.clear();
  for (const LoadStep& step : steps_) weights_.push_back(step.weight);
}

double CorrectionTargets::of(int step) const {
  const LoadStep& here = steps_[step];
  const double most = here.weight * reduction_ * before_;
  if (!isLater_ || here.directions >= mostDirections) return most;
  return std::clamp(reduction_ * here.before, leastTarget * most, most);
}

double CorrectionTargets::leastShare() const {
  double least = 1.0;
  for (const LoadStep& step : steps_) least = std::min(least, step.weight);
  return reduction_ * least;
}

double CorrectionTargets::largestResidual(int begin, int end) const {
  double largest = 0.0;
  for (int t = begin; t < end; ++t) largest = std::max(largest, steps_[t].residual / steps_[t].weight);
  return largest;
}

double CorrectionTargets::longestWay(int end) const {
  double longest = 0.0;
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    const bool isAhead = static_cast<int>(t) >= end;
    longest = std::max(longest, isAhead ? leastWay * steps_[t].residual : steps_[t].moved);
  }
  return longest;
}

double CorrectionTargets::promisedResidual() const {
  return std::max(largestResidual(), reduction_ * before_);
}

bool CorrectionTargets::sharpen(const std::vector<double>& ways, const Goal& goal) {
  // What is left of the ways when the residuals have fallen as much as they did.
  const auto left = [&](std::size_t t) { return goal.reduction * ways[t]; };
  bool areAny = false;
  for (std::size_t t = 0; t < ways.size(); ++t) areAny = areAny || left(t) > nearEnough * goal.error;
  if (!areAny) return false;
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    if (left(t) > 0.0) steps_[t].weight *= std::clamp(shareOfError * goal.error / left(t), furthest, 1.0);
  }
  return true;
}

double CorrectionTargets::leftOfLargest(std::size_t step, double noise) const {
  return steps_[step].residual > noise ? steps_[step].residual / (weights_[step] * before_) : 0.0;
}

std::vector<double> CorrectionTargets::sharesLeft(double noise) const {
  std::vector<double> shares;
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    const LoadStep& here = steps_[t];
    const double kept = here.residual > noise ? here.residual / here.before : 0.0;
    const bool isNextToNothing = here.residual <= leastTarget * weights_[t] * reduction_ * before_;
    shares.push_back(std::max(leftOfLargest(t, noise), isNextToNothing ? std::min(reduction_, kept) : kept));
  }
  return shares;
}

double CorrectionTargets::reduction(double noise) const {
  double largest = 0.0;
  for (std::size_t t = 0; t < steps_.size(); ++t) largest = std::max(largest, leftOfLargest(t, noise));
  return largest;
}

}  // namespace harmos::latin
