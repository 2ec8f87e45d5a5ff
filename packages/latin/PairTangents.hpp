#pragma once

#include <vector>

#include <harmos/base/Tensor3.hpp>
#include <harmos/latin/FaceSums.hpp>
#include <harmos/latin/InterfaceLines.hpp>
#include <harmos/laws/InterfaceLaw.hpp>

namespace harmos::latin {

/// The tangent of a local stage at one load step, pair by pair: D = df^/dbeta, so that that of T is J v = 2 D y - y
/// with y the image of v under the linear stage.
///
/// A law is asked pair by pair, so that dt/d(free jump) [stress/length] is a matrix of 3 x 3 per pair, found with three
/// further calls whatever the number of directions that it is to serve. Where the graph has a kink it is the tangent of
/// one side. A law over a whole face answers to every direction itself. Displacement form.
class PairTangents {
 public:
  /// `assembly` and `lines`, whose buffers it uses, must outlive it.
  PairTangents(const assembly::Assembly& assembly, InterfaceLines& lines);

  /// Finds the tangents of an interface with a side on this rank by differences at one load step, counted from 0: with
  /// the lines and states of its pairs, and the history that they were found with. Not collective.
  void differentiate(int interfaceIndex, int step, const std::vector<laws::LocalLine>& lines,
                     const laws::LocalState* states, const std::vector<double>& oldHistory);
  /// D of a pair of an interface with a side on this rank, in (x, y, z): f1^ changes by D (beta1 - beta2) [-]. That of
  /// a perfect joint, of laws over whole faces. Not collective.
  base::Frame of(int interfaceIndex, int pair) const;
  /// The same in all digits where the law is affine: D = H k / (1 + H k) over the number of sides, k the stiffness of a
  /// component, H the compliance [length/stress] of the line of the pair. Not collective.
  base::Frame exactly(int interfaceIndex, int pair, double compliance) const;
  /// Replaces the tangents dt/d(free jump) of all pairs by their transposes; those of laws over whole faces are
  /// symmetric. Not collective.
  void transpose();
  /// Collective. traction = D y [stress], rows of the layout x the same columns.
  void apply(const base::Matrix& y, base::Matrix& traction) const;

 private:
  /// Collective. The rows of laws over whole faces, whose y was exchanged.
  void applyFaces(const base::Matrix& y, base::Matrix& traction) const;

  const assembly::Assembly& assembly_;
  InterfaceLines& lines_;
  std::vector<std::vector<base::Frame>> tangents_;  // per interface and pair: df^/dbeta in (x, y, z), row by row
  FaceSums faces_;
  int step_ = 0;  // of the tangents
};

}  // namespace harmos::latin
