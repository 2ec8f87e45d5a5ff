#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/CorrectionSpace.hpp>
#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/KeptJump.hpp>
#include <harmos/latin/PairTangents.hpp>
#include <harmos/latin/Response.hpp>

namespace harmos::latin {

/// The adjoints of responses at one load step: how much a response J depends on what acts on the bodies there.
///
/// With the laws replaced by their tangents T = dt/d(jump) of the solution, its history taken as given, and D u the
/// jumps of the bodies' displacements u, the adjoint z of dJ = sum weight.du + sum h a.dt obeys
///   K z + D^T h T^T (D z - a) = weight,
/// an assembly like that of u, with the same bodies and search directions: it is solved by the same two stages, the
/// local one with the transposed tangents. All responses are columns of one linear stage, and share one space of
/// directions. z: [unit of J per force]. Displacement form; with a consistent interface mass T^T is that of
/// a lumped one. Where the graph of a law has a kink, T is the tangent of one side. Source: Becker, Rannacher (2001),
/// doi:10.1017/S0962492901000010.
class AdjointProblem {
 public:
  /// The adjoint of one response.
  struct Adjoint {
    /// z of the bodies owned here, dofs; of others empty.
    std::vector<std::vector<double>> displacement;
    /// What the remaining residual can hide at most, over z in the metric of states; see NewtonCorrection::Result.
    double hidden = 0.0;
    /// dJ/dq of what laws keep (keptJumps()) [unit of J per length], in that order; it is exact where q has been found
    /// in an earlier load step, all else being the same.
    std::vector<double> ofKept;
  };

  /// Collective. Finds the tangents at a load step, from 0, of a state of all of them; `state` stays valid.
  AdjointProblem(FixedPoint& fixedPoint, const Iterate& state, int step);

  /// Collective. One adjoint for each gradient; a response ends when no more than the share `hidden` of z can be
  /// hidden, all end after so many directions together. What can be hidden follows from the smallest singular value in
  /// the space, which a few directions do not show: there are a dozen of them before it counts. Directions are solved
  /// in single precision where its error is far below `hidden`. Ends the validity of all iterates.
  std::vector<Adjoint> solve(const std::vector<ResponseGradient>& gradients, double hidden, int maximumDirections);
  /// What laws keep from earlier load steps.
  const std::vector<KeptJump>& kept() const { return kept_; }

 private:
  struct Column;

  /// Whether the directions from `first` on hold nearly all that a residual would add to those before.
  bool isTaken(const CorrectionSpace& space, int first, const std::vector<double>& residual) const;
  /// Looks for the response of a column in the space; whether it is not good enough yet.
  bool isLeft(const CorrectionSpace& space, double hidden, Column& column) const;
  void setLoads(const std::vector<ResponseGradient>& gradients);
  /// 2 f - beta of columns whose beta is given, without the jumps a.
  base::Matrix meet(const base::Matrix& beta) const;
  /// Fields of the linear stage whose free jumps are a.
  base::Matrix jumpsOf(const std::vector<ResponseGradient>& gradients) const;
  /// Collective. dJ/dq: kept jumps x columns of the fields of the linear stage, the jumps a taken off.
  base::Matrix ofKept(const base::Matrix& beta) const;

  FixedPoint& fixedPoint_;
  InterfaceLines lines_;
  PairTangents tangents_;
  std::vector<KeptJump> kept_;
  double directionError_ = 0.0;  // relative, of the linear stage for directions
};

}  // namespace harmos::latin
