#pragma once

#include <vector>

#include <harmos/base/Tensor3.hpp>
#include <harmos/substructure/MatrixEntry.hpp>

namespace harmos::substructure {

/// What boundaries and interfaces make of a stiffness matrix K: A = P (K + k h + s) P + d (1 - P), symmetric.
///
/// k h [force/length]: search directions k [stress/length] times interface mass h [area], >= 0. s: springs to the
/// ground [force/length], symmetric and >= 0. P: block-diagonal projector onto the directions that no boundary holds; A
/// acts on the others by themselves, with d [force/length] > 0 of the size of K.
struct BoundaryTerm {
  /// A matrix that belongs to one node, in global axes; of a body in the plane the first two rows and columns count.
  struct NodeTensor {
    int node;             ///< of the body, from 0
    base::Tensor3 value;  ///< springs: [force/length]; projectors: [-]
  };

  int dimension = 3;             ///< dofs per node, 2 or 3
  std::vector<double> diagonal;  ///< k h per dof [force/length]; empty: none
  /// Consistent interface mass times k [force/length] between nodes of the body, from 0: both triangles, repeated
  /// entries add up. A value is added for every component c, to row dimension * row + c and column dimension * column +
  /// c of the matrix.
  std::vector<MatrixEntry> entries;
  std::vector<NodeTensor> springs;  ///< s, repeated nodes add up
  std::vector<NodeTensor> free;     ///< P of the nodes at which it is not 1, each once
};

/// Sorts a term, so that it does not show in which order it was put together, and adds up entries of one place.
void arrange(BoundaryTerm& term);

/// Whether two terms that are arranged, of bodies with as many nodes, are the same but for round-off.
bool areEqual(const BoundaryTerm& first, const BoundaryTerm& second);

}  // namespace harmos::substructure
