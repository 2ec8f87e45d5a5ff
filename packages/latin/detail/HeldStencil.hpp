#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/detail/ConstrainedOperator.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

namespace harmos::latin {

/// What forces on the trace do at held nodes, in the symbols of OperatorGroup: with N the restriction to them and B
/// that to the trace, N A S^-1 P B^T and N S^-1 P B^T.
///
/// These are small dense matrices: once they are known, held nodes need no solve of the whole body. They take a solve
/// for every direction that is held, for its reaction, and for every other one of these nodes, for its motion.
class HeldStencil {
 public:
  /// `constrained` must outlive it.
  explicit HeldStencil(const ConstrainedOperator& constrained);

  /// Solves that prepare() takes.
  int solves() const { return static_cast<int>(reacting_.size() + moving_.size()); }

  /// Computes the matrices, once.
  void prepare(const substructure::SubstructureSolver& solver);
  /// Adds what forces f [force], rows of the trace x any columns, make of A u [force] and u [length] at held dofs;
  /// rows heldDofs(). A u is left out in directions in which nothing is held. Only after prepare().
  void add(const base::Matrix& forces, base::Matrix& reactions, base::Matrix& motions) const;

 private:
  const ConstrainedOperator& operator_;
  std::vector<int> reacting_, moving_;  // places in heldDofs()
  base::Matrix reactions_, motions_;    // transposed, rows of the trace x those: [-] and [length/force]
};

}  // namespace harmos::latin
