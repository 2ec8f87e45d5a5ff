#include <harmos/parametric/StartRecord.hpp>

#include <algorithm>

namespace harmos::parametric {
namespace {

// Stages differ tenfold between configurations: fewer tries tell little.
constexpr int fewTries = 4;
constexpr int lastTries = 12;
constexpr int longestPatience = 16;
// Distances on a grid differ by round-off.
constexpr double sameDistance = 1.0 + 1e-6;

}  // namespace

void StartRecord::addCold(int stages) {
  coldSum_ += stages;
  ++coldRuns_;
}

bool StartRecord::favoursWarm(double distance) {
  int tries = 0, sum = 0;
  for (auto one = warm_.rbegin(); one != warm_.rend() && tries < lastTries; ++one) {
    if (one->distance > sameDistance * distance) continue;
    sum += one->stages;
    ++tries;
  }
  if (tries < fewTries || sum < coldStages() * tries) return true;
  if (++refused_ < patience_) return false;
  refused_ = 0;
  patience_ = std::min(2 * patience_, longestPatience);
  return true;
}

}  // namespace harmos::parametric
