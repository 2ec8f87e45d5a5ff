#pragma once

#include <vector>

namespace harmos::substructure {

/// The search directions that the interfaces add to a stiffness matrix, k h [force/length], symmetric and >= 0: k the
/// search direction [stress/length], h the interface mass [area].
struct BoundaryTerm {
  /// Adds `value` to the entry (row, column) of the diagonal block of every component c, that is to row dimension * row
  /// + c and column dimension * column + c of the matrix.
  struct NodeEntry {
    int row;       ///< node of the body, from 0
    int column;    ///< node of the body, from 0
    double value;  ///< [force/length]
  };

  int dimension = 3;               ///< dofs per node, 2 or 3
  std::vector<double> diagonal;    ///< per dof [force/length]; empty: none
  std::vector<NodeEntry> entries;  ///< consistent interface mass times k: both triangles, repeated entries add up
};

}  // namespace harmos::substructure
