#pragma once

#include <vector>

namespace harmos::substructure {

/// A value [any unit] at a place of a matrix, row and column from 0.
struct MatrixEntry {
  int row;
  int column;
  double value;
};

/// Sorts entries by row and column and adds up those of one place, in the order in which they were given.
void addUp(std::vector<MatrixEntry>& entries);

}  // namespace harmos::substructure
