#pragma once

#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/base/Matrix.hpp>
#include <harmos/latin/TraceLayout.hpp>

namespace harmos::latin {

/// Rigid motions rho = t + theta x (x - centre) [length], one per body and load step, from which displacements of an
/// iteration are counted: u = rho + u'.
///
/// A stiffness K annihilates rho in exact arithmetic, but in double precision K u errs by about 1e-16 |K| |u|. In the
/// equations of u' only the jumps of rho between bodies are left, which are found in extended precision, so that forces
/// keep their digits however far a body moves. Without motions, or where none was added, rho is zero.
/// Limit: extended precision is `long double`, which is no better than double on some machines.
class ReferenceMotions {
 public:
  /// Not collective; no body has a motion yet. `assembly` must outlive it.
  explicit ReferenceMotions(const assembly::Assembly& assembly) : assembly_(&assembly) {}

  /// Whether all motions are zero.
  bool isEmpty() const { return motions_.empty(); }
  /// All motions become zero.
  void clear() { motions_.clear(); }
  /// Collective. Adds to the motion of every body the one that fits u' [length] best on its rows of the layout, in the
  /// sense of sum h |u' - rho|^2; columns: load steps. Bodies without rows keep theirs, and so do those whose stiffness
  /// resists a rigid motion, as in axisymmetry.
  void add(const base::Matrix& trace, const TraceLayout& layout);

  /// rho [length] at a node of a body.
  base::Vector3 at(int body, int node, int step) const;
  /// rho [length] at a point of a side of an interface: of the nodes that its trace operator weighs.
  base::Vector3 at(const assembly::Interface& interface, int side, int point, int step) const;
  /// Jump rho2 - rho1 [length] at a point, in global axes; the ground does not move.
  base::Vector3 jump(const assembly::Interface& interface, int point, int step) const;
  /// rho at a point less what another set of motions has there.
  base::Vector3 difference(const ReferenceMotions& other, const assembly::Interface& interface, int side, int point,
                           int step) const;
  /// A given place of a node less rho there.
  base::Vector3 below(const base::Vector3& place, int body, int node, int step) const;

 private:
  using Extended = long double;
  struct Motion {
    base::Vector3 translation{};
    base::Vector3 rotation{};
    base::Vector3 centre{};
  };
  struct Place {
    Extended x[3] = {0.0L, 0.0L, 0.0L};
  };
  Place exactly(int body, int node, int step) const;
  Place exactly(const assembly::Interface& interface, int side, int point, int step) const;

  const assembly::Assembly* assembly_;
  std::vector<Motion> motions_;  // body by body; empty: none
  std::vector<bool> resists_;    // per body: its stiffness resists a rigid motion; empty: not known yet
};

}  // namespace harmos::latin
