#pragma once

#include <vector>

#include <harmos/latin/CorrectionSpace.hpp>
#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/PairTangents.hpp>
#include <harmos/latin/PointwiseLocalStage.hpp>

namespace harmos::latin {

/// A CorrectionSpace with the tangent J of T at one state, which gives the g = (I - J) v = v + y - 2 D y of its
/// directions: products, for which no linear stage is needed, and without what T does not feel (UnfeltStates). With a
/// shift they are those of (1 + shift) I - J.
class TangentSpace {
 public:
  /// The first two, of which the buffers of `lines` are used, must outlive it. `images` as of a CorrectionSpace.
  TangentSpace(const FixedPoint& fixedPoint, InterfaceLines& lines,
               substructure::Precision images = substructure::Precision::single)
      : fixedPoint_(fixedPoint), space_(fixedPoint.metric(), images), tangents_(fixedPoint.assembly(), lines) {}

  /// The directions and what is known of them.
  const CorrectionSpace& space() const { return space_; }

  /// The tangents of pairs, of the state where they were taken.
  const PairTangents& tangents() const { return tangents_; }

  /// Collective. Takes the tangents of a column that `local` has just met with solveColumn(), and a shift [-].
  void differentiate(int column, PointwiseLocalStage& local, double shift = 0.0);
  /// Collective. Adds a direction v that CorrectionSpace::makeIndependent() has made, with its y [stress]. `isCurrent`:
  /// the tangents are those of the state at hand, so that its g is found as well; otherwise differentiate() must
  /// follow.
  void add(const double* v, const double* y, bool isCurrent);
  /// Lets go of what can be found again from v, y and the tangents: a third of what the space takes. Not collective.
  void release() { space_.releaseBasis(); }
  /// Collective. Finds that again, if need be; the tangents must be those of all directions. To be called before
  /// space() is asked for least squares, and before add() with `isCurrent`.
  void restore();
  /// Collective. Makes v what J makes of the last direction, independent of all of them; false when it is not.
  bool continueKrylov(std::vector<double>& v) const;
  /// Collective. Takes G c from `residual` [stress], rows of the layout.
  void subtract(const std::vector<double>& c, std::vector<double>& residual) const;

 private:
  void append(int first);

  const FixedPoint& fixedPoint_;
  CorrectionSpace space_;
  PairTangents tangents_;
  double shift_ = 0.0;
};

}  // namespace harmos::latin
