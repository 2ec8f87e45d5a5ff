#pragma once

#include <vector>

namespace harmos::substructure {

/// The search directions that the interfaces add to a stiffness matrix, k h [force/length], symmetric and >= 0.
struct BoundaryTerm {
  /// Adds `value` to the entry (row, column) of the diagonal block of every component.
  struct NodeEntry {
    int row;
    int column;
    double value;
  };

  int dimension = 3;
  std::vector<double> diagonal;    ///< per dof; empty: none
  std::vector<NodeEntry> entries;  ///< consistent interface mass times k: both triangles, repeated entries add up
};

}  // namespace harmos::substructure
