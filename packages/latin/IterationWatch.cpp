#include <harmos/latin/detail/IterationWatch.hpp>

#include <algorithm>

#include <harmos/latin/Certificate.hpp>

namespace harmos::latin {
namespace {

// Promised quantities are compared with those of four iterations before; looking every second time is enough.
constexpr int iterationsPerSnapshot = 2;
constexpr std::size_t snapshotsBack = 2;
// Gap over the tolerance: after a good start little changes at first; the gap tells that this is not yet the end.
constexpr double settledGap = 0.02;
// A state this many times larger than the first one was extrapolated beyond all measure: the digits of the forces are
// lost in k w, and everything finite would look small beside it.
constexpr double divergedSize = 1e8;

}  // namespace

bool IterationWatch::isSettled(int iteration, const Iterate& iterate, double tolerance, double& change) {
  if (iteration % iterationsPerSnapshot != 0) return false;
  snapshots_.push_back(std::make_unique<Snapshot>(iterate, responses_));
  if (snapshots_.size() <= snapshotsBack) return false;
  const std::vector<double> changes = snapshots_.back()->distance(*snapshots_[snapshots_.size() - 1 - snapshotsBack]);
  change = *std::max_element(changes.begin(), changes.end());
  snapshots_.erase(snapshots_.begin());
  return change <= tolerance && fieldGap(iterate) <= settledGap * tolerance;
}

bool IterationWatch::hasDiverged(const base::Matrix& image) {
  const double size = fixedPoint_.metric().norm(image);
  if (startSize_ == 0.0) startSize_ = size;
  return !(size <= divergedSize * startSize_);
}

}  // namespace harmos::latin
