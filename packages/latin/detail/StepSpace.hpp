#pragma once

#include <optional>
#include <vector>

#include <harmos/latin/TangentSpace.hpp>
#include <harmos/latin/detail/FaintMotions.hpp>
#include <harmos/latin/detail/SoftMotions.hpp>

namespace harmos::latin {

/// What a CausalCorrection has of a load step: directions, tangents, and which motions of the parts these hardly
/// resist.
class StepSpace {
 public:
  /// Both must outlive it. Not collective; not open.
  StepSpace(FixedPoint& fixedPoint, const SoftMotions& softMotions)
      : fixedPoint_(fixedPoint), softMotions_(softMotions), faint_(fixedPoint.metric()) {}

  /// Whether there are motions that are resisted by so little that images of directions cannot tell, as far as they
  /// have been looked for. Not collective, and the same on every rank.
  bool hasFaintMotions() const { return !faint_.isEmpty(); }
  /// Those.
  const FaintMotions& faintMotions() const { return faint_; }

  /// Whether there are directions and tangents.
  bool isOpen() const { return tangent_.has_value(); }
  /// Begins with the self-stresses that averages hardly move. `lines` as of a TangentSpace. Collective.
  void open(InterfaceLines& lines);
  /// Lets go of everything but smallestSingularValue(). Not collective.
  void close();

  /// The directions, once it is open.
  TangentSpace& tangent() { return *tangent_; }
  /// The same.
  const CorrectionSpace& space() const { return tangent_->space(); }
  /// The tangents are not those of a state like the present one.
  bool isStale() const { return isStale_; }
  /// Says whether they are.
  void setStale(bool isStale) { isStale_ = isStale; }
  /// Collective. Takes the tangents of a load step that the local stage has just met with solveColumn().
  void differentiate(int step);
  /// Collective. A motion that the tangents hardly resist and the space does not hold, rows of the layout, independent
  /// of the directions that there are; nothing when there is none.
  std::optional<std::vector<double>> nextMotion();
  /// Collective. The next direction, likewise independent: the residual [stress] or what J makes of the last direction.
  /// Nothing, and stale from now on, when there is none.
  std::optional<std::vector<double>> nextDirection(const double* residual);
  /// Collective. Adds such a direction v with its image y [stress].
  void add(const double* v, const double* y);
  /// The smallest singular value of I - J that was met at the load step,
  double smallestSingularValue() const;
  /// and the resistance of the softest motion that the space does not hold, if that is less.
  double softest() const;

 private:
  bool holds(const SoftMotions::Motion& motion) const;

  FixedPoint& fixedPoint_;
  const SoftMotions& softMotions_;
  std::optional<TangentSpace> tangent_;
  bool isStale_ = true;
  double closed_ = 1.0;                    // smallest singular value of the spaces that were let go of
  std::vector<SoftMotions::Motion> soft_;  // of the tangents, not held; the softest first
  FaintMotions faint_;
};

}  // namespace harmos::latin
