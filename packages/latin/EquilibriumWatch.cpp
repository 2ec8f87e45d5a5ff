#include <harmos/latin/EquilibriumWatch.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/base/Vector3.hpp>

namespace harmos::latin {
namespace {

// Odd, so that an iteration that jumps to and fro is not taken for one that stays.
constexpr int iterationsPerFinding = 9;
constexpr std::ptrdiff_t findingsThatAgree = 4;
constexpr double spread = 0.05;
constexpr double smallestScale = 1e-2;
// Of the accuracy: a smaller lack of the forces is left to the residual. One that stays is seen in displacements, which
// grow with every iteration, long before it is as large as the accuracy.
constexpr double leastLack = 0.1;

bool agree(const base::Vector3& a, const base::Vector3& b) {
  return base::distance(a, b) <= spread * base::norm(b);
}

}  // namespace

bool EquilibriumWatch::persists() const {
  if (static_cast<std::ptrdiff_t>(history_.size()) < findingsThatAgree) return false;
  const Imbalance& last = history_.back();
  return std::all_of(history_.end() - findingsThatAgree, history_.end(), [&](const Imbalance& one) {
    return one.body == last.body && one.step == last.step && one.relative >= leastLack * accuracy_ &&
           std::abs(one.load - last.load) <= spread * last.load &&
           (agree(one.force, last.force) || agree(one.moment, last.moment));
  });
}

EquilibriumWatch::Finding EquilibriumWatch::look(FixedPoint& fixedPoint, const Iterate*& iterate, base::Matrix& alpha,
                                                 base::Matrix& image) {
  // With a k far too small the interfaces have not felt their forces yet.
  if (++iterations_ % iterationsPerFinding != 0 || fixedPoint.searchDirectionScale() < smallestScale)
    return Finding::nothing;
  history_.push_back(largestImbalance(*iterate, rigidBodies_));
  if (!persists()) return Finding::nothing;
  const FreeMotion motion = followImbalance(history_.back(), rigidBodies_, fixedPoint, *iterate, alpha, image);
  iterate = motion.iterate;
  if (motion.isFree && isSure_ && isSure_(history_.back().step)) {
    // Something resists, but so softly that it is not seen from here.
    history_.clear();
    return Finding::nothing;
  }
  if (motion.isFree) return Finding::noEquilibrium;
  if (!motion.landing) return Finding::nothing;
  history_.clear();
  alpha.assign(*motion.landing);
  return Finding::landing;
}

std::optional<Imbalance> EquilibriumWatch::lackAt(FixedPoint& fixedPoint, const base::Matrix& alpha) const {
  base::Matrix image(alpha.numRows(), alpha.numCols());
  const Iterate& iterate = fixedPoint.apply(alpha, image);
  const Imbalance imbalance = largestImbalance(iterate, rigidBodies_);
  if (imbalance.relative < leastLack * accuracy_ || (isSure_ && isSure_(imbalance.step))) return std::nullopt;
  if (!followImbalance(imbalance, rigidBodies_, fixedPoint, iterate, alpha, image).isFree) return std::nullopt;
  return imbalance;
}

}  // namespace harmos::latin
