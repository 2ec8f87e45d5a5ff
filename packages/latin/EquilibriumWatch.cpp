#include <harmos/latin/EquilibriumWatch.hpp>

#include <algorithm>

#include <harmos/latin/FreeMotion.hpp>
#include <harmos/mesh/Vector.hpp>

namespace harmos::latin {
namespace {

// Odd, so that an iteration that jumps to and fro is not taken for one that stays.
constexpr int lookEvery = 9;
constexpr std::ptrdiff_t looks = 4;
constexpr double spread = 0.05;

bool agree(const mesh::Point& a, const mesh::Point& b) {
  return mesh::distance(a, b) <= spread * mesh::norm(b);
}

}  // namespace

bool EquilibriumWatch::persists() const {
  if (static_cast<std::ptrdiff_t>(history_.size()) < looks) return false;
  const Imbalance& last = history_.back();
  return std::all_of(history_.end() - looks, history_.end(), [&](const Imbalance& one) {
    return one.body == last.body && one.step == last.step && one.relative >= accuracy_ &&
           (agree(one.force, last.force) || agree(one.moment, last.moment));
  });
}

bool EquilibriumWatch::findsNoEquilibrium(FixedPoint& fixedPoint, const base::Matrix& alpha, base::Matrix& image) {
  if (++iterations_ % lookEvery != 0) return false;
  history_.push_back(largestImbalance(fixedPoint));
  return persists() && movesFreely(history_.back(), fixedPoint, alpha, image);
}

}  // namespace harmos::latin
