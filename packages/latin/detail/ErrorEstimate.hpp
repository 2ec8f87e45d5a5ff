#pragma once

#include <vector>

#include <harmos/latin/Snapshot.hpp>

namespace harmos::latin {

/// What the corrections of a state, one after the other, tell of its error.
///
/// Of the last two, e1 and e2 are the distances that they went, of every promised quantity (Snapshot), and kappa = max
/// e2 / max e1. With a1 the state that the last one began with and a2 that which it has come to, the error of a1 is E,
/// the largest e2 / (1 - kappa) of all load steps. In it kappa counts as 0.8 at most, for slower contraction is that of
/// round-off, and then at least as 0.6 where the last correction has left r <= 0.3 of the residual of the load step, as
/// 1 - 4/7 (1 - r) where it has left more. No response counts as having come nearer than the fields have. See
/// Certificate for what a claim needs besides.
class ErrorEstimate {
 public:
  /// Of the residual of a load step: what a correction leaves of which kappa counts as 0.6 at least.
  static constexpr double usualShare = 0.3;
  /// Which state is delivered. If it is a2, e2 is added to E where kappa is above 0.8, so that E is for a2, too. If it
  /// is a1, which goes with corrections that start anew each time, kappa counts as r at least instead of 0.6 and so on.
  enum class Delivered { a1, a2 };

  /// `accuracy`: relative [-].
  ErrorEstimate(double accuracy, Delivered delivered) : accuracy_(accuracy), delivered_(delivered) {}

  /// Collective. A correction went from one state to another. `reduction`: what it has left of the largest residual;
  /// `shares`: of that of each load step, of which there is one at least; `hidden`: what the residual that is left can
  /// hide, over the way (CausalCorrection::Result).
  void add(const Snapshot& from, const Snapshot& to, double reduction, const std::vector<double>& shares,
           double hidden);
  /// Counts an error [-] of all quantities in that the corrections cannot see.
  void addUnseen(double error);

  /// Whether there were two corrections, which the following need.
  bool isKnown() const { return !errors_.empty(); }
  /// Per quantity as Snapshot::distance().
  const std::vector<double>& errors() const { return errors_; }
  /// kappa [-] as it was found; 1 before there are two.
  double contraction() const { return contraction_; }
  /// Whether the last correction went farther than the one before, and not as little as round-off makes it go.
  bool grows() const { return contraction_ > 1.0 && !isSettled(); }
  /// Whether all that corrections tell lets the accuracy be claimed: E is within it, e1 <= 0.3, the last one did not go
  /// farther, no load step keeps more than 0.95 of its residual in it, and what either hides is less than its way, or a
  /// tenth of the accuracy over E.
  bool isSmall() const;
  /// Whether there was a correction, and the last one went less than a tenth of the accuracy: it may be round-off,
  /// which does not contract.
  bool isSettled() const;

 private:
  double leastFactor(double share) const;

  double accuracy_;
  Delivered delivered_;
  double before_ = 0.0, last_ = 0.0;          // largest distances
  double hiddenBefore_ = 0.0, hidden_ = 0.0;  // of both
  double mostLeft_ = 0.0;                     // share of a load step, of the last one
  double contraction_ = 1.0;
  std::vector<double> distances_, errors_;  // of the last one
};

}  // namespace harmos::latin
