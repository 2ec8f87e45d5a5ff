#pragma once

namespace harmos::substructure {

/// How exactly a system is solved.
enum class Precision {
  exact,  ///< double
  single  ///< where SubstructureSolver::prepareSingle() has prepared it to about singleError(), faster; else exact
};

}  // namespace harmos::substructure
