#pragma once

#include <optional>
#include <vector>

#include <harmos/laws/InterfaceLaw.hpp>

namespace harmos::laws {

/// A law over all points of a face together, whatever pieces and ranks it lies on.
///
/// The points depend on each other through a few sums over all of them only: s = sum over points of c_p + D_p
/// delta_free_p, where c and D follow from the lines' compliances, areas and places. On the lines, at one load step and
/// with one history, the tractions are affine in all free jumps together, t = A delta_free + b, with A symmetric in the
/// sum of h a.(A b) over the points. The sums need areas: NodeArrays must have them.
class CoupledLaw : public InterfaceLaw {
 public:
  /// How many sums there are, at least 1.
  virtual int sums() const = 0;
  /// Adds the share of some points to the sums of a load step, counted from 0. Reads no history.
  virtual void addToSums(int step, const NodeArrays& nodes, double* sums) const = 0;
  /// Solves some points of the face, given the sums over all of it; otherwise as solve(int, const NodeArrays&).
  virtual void solvePoints(int step, const NodeArrays& nodes, const double* sums) const = 0;
  /// Tractions A delta_free on lines whose free jumps are those of a direction, as are the sums. Reads and writes no
  /// history, and of the states sets the tractions only.
  virtual void solveTangent(int step, const NodeArrays& nodes, const double* sums) const = 0;

  /// The load step, from 0, since whose end the law keeps a mean jump of its face, along the normal if keptShare() does
  /// not say otherwise, as a bolt does that was tightened by force and then locked: at `step` the tractions follow from
  /// the jumps less that one. -1: none.
  virtual int keepsJumpSince(int /*step*/) const { return -1; }
  /// What that jump is made of at a point, and what depends on it.
  struct KeptShare {
    base::Vector3 ofJump{};  ///< v [1/area]: the jump is the sum of h v.delta, delta = -w at an outer boundary
    base::Vector3
        ofForce{};  ///< e [-]: a response J depends on it by dJ/dq = sum of h e.t, t the tractions of its adjoint
  };
  /// Of a point with its place and normal; `area`: of all points together.
  virtual KeptShare keptShare(const base::Vector3& /*place*/, const base::Vector3& normal, double area) const {
    return {(1.0 / area) * normal, normal};
  }
  /// The force F [force], positive in tension, that the law brings about at a load step, counted from 0, whatever the
  /// jumps, as a bolt that is being tightened does: of keptShare(), F v is the traction that it gives (on side 1) and e
  /// is along it. Nothing: the jumps decide.
  virtual std::optional<double> tighteningForce(int /*step*/) const { return std::nullopt; }

  /// Of a face that these points are all of.
  void solve(int step, const NodeArrays& nodes) const final {
    std::vector<double> all(static_cast<std::size_t>(sums()), 0.0);
    addToSums(step, nodes, all.data());
    solvePoints(step, nodes, all.data());
  }
  /// No traction is given, and no component stands for itself.
  bool prescribesTraction() const final { return false; }
  /// See prescribesTraction().
  bool isAffine() const final { return false; }
  /// As it is affine in all free jumps together.
  bool isSmooth() const final { return true; }
};

/// Whether a law is one.
inline bool isCoupled(const InterfaceLaw& law) {
  return dynamic_cast<const CoupledLaw*>(&law) != nullptr;
}

}  // namespace harmos::laws
