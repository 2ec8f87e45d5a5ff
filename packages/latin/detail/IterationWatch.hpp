#pragma once

#include <memory>
#include <vector>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/Response.hpp>
#include <harmos/latin/Snapshot.hpp>

namespace harmos::latin {

/// Looks at an iteration over all load steps: whether what is promised still changes, and whether the state has gone
/// beyond all measure.
class IterationWatch {
 public:
  /// Both must outlive it.
  IterationWatch(const FixedPoint& fixedPoint, const std::vector<std::shared_ptr<const Response>>& responses)
      : fixedPoint_(fixedPoint), responses_(responses) {}

  /// Collective. Whether the responses and both fields, of which every second iteration is compared with that of four
  /// iterations before, have changed by no more than `tolerance` [-] and laws and bodies agree. `change`: the largest
  /// one, where it was looked at.
  bool isSettled(int iteration, const Iterate& iterate, double tolerance, double& change);
  /// Collective. The first image that it sees is the measure of all others.
  bool hasDiverged(const base::Matrix& image);
  /// The state was moved by other means: later ones are not compared with those before.
  void forget() { snapshots_.clear(); }

 private:
  const FixedPoint& fixedPoint_;
  const std::vector<std::shared_ptr<const Response>>& responses_;
  std::vector<std::unique_ptr<Snapshot>> snapshots_;  // of the last iterations that were looked at
  double startSize_ = 0.0;
};

}  // namespace harmos::latin
