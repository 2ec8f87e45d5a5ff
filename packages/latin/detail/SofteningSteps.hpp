#pragma once

#include <functional>
#include <string>
#include <vector>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/StepNewton.hpp>

namespace harmos::latin {

/// Solves load steps where laws soften by Newton's method: as a whole, then in parts from the load step before
/// (StepContinuation), and where the joint snaps on that way, by going to where it comes to rest
/// (StepNewton::settle()). Remembers of each load step what it took, all marches of a run together.
class SofteningSteps {
 public:
  /// What a load step goes for [force length, square root].
  struct Goal {
    double residual = 0.0;
    double forces = 0.0;   ///< size of the present ones, which `residual` is a share of
    double largest = 0.0;  ///< size of the largest ones of all load steps, of which that share is enough on a path
  };

  /// `fixedPoint` must outlive it.
  explicit SofteningSteps(FixedPoint& fixedPoint);

  /// Nothing is known yet of how far the present load step can be followed.
  void begin() { share_ = 1.0; }
  /// Collective, one load step selected. From `state`, one column, whose iterate is given and takes its end with it;
  /// `alpha` has the load steps before. False where nothing leads anywhere, which leaves in `state` the best place to
  /// go on from.
  bool solve(int step, const Iterate& iterate, const base::Matrix& alpha, base::Matrix& state, const Goal& goal,
             StepNewton& newton, const std::function<bool()>& mustStop);
  /// That the present load step has no solution near the one before, and what helps, for the user.
  std::string describeUnsolved(int step) const;
  /// In how many parts each load step was solved at most; 1: as a whole.
  const std::vector<int>& parts() const { return parts_; }
  /// Of each load step, whether its joint has snapped within it to where it comes to rest.
  const std::vector<bool>& snaps() const { return snaps_; }

 private:
  FixedPoint& fixedPoint_;
  bool isPath_;  // loads are to be found
  std::vector<int> parts_;
  std::vector<bool> snaps_;
  double share_ = 1.0;  // of the present load step, that could be solved in parts
};

}  // namespace harmos::latin
