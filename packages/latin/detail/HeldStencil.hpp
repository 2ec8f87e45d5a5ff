#pragma once

#include <functional>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/substructure/BoundaryTerm.hpp>
#include <harmos/substructure/CrsMatrix.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

namespace harmos::latin {

/// The degrees of freedom that reactions of held nodes need, those of the nodes and of all that A couples with them,
/// and how forces on the trace move them.
///
/// With N the restriction to them and B that to the trace, N S^-1 P B^T is a small dense matrix: once it is known, held
/// nodes need no solve of the whole body. It takes as many solves as N has rows.
class HeldStencil {
 public:
  /// Finds the degrees of freedom. `stiffness`: K, whose graph counts; `trace`: ascending.
  HeldStencil(const substructure::CrsView& stiffness, const substructure::BoundaryTerm& term,
              const std::vector<int>& trace);

  /// Ascending; empty when no node is held.
  const std::vector<int>& dofs() const { return dofs_; }
  /// Where a degree of freedom stands in them, or -1.
  int rowOf(int dof) const;
  /// Whether the matrix takes no more entries than two inverses of the trace.
  bool isWorthwhile() const { return dofs_.size() <= 2 * trace_.size(); }

  /// Computes the matrix, once. `project`: applies P to all rows of columns.
  void prepare(const substructure::SubstructureSolver& solver, const std::function<void(base::Matrix&)>& project);
  /// u = N S^-1 P B^T f [length] for forces f [force], rows of the trace x any columns. Only after prepare().
  void move(const base::Matrix& forces, base::Matrix& u) const;

 private:
  std::vector<int> trace_;
  std::vector<int> dofs_;
  base::Matrix motions_;  // its transpose [length/force], rows of the trace x dofs
};

}  // namespace harmos::latin
