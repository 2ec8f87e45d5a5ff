#pragma once

#include <functional>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/detail/ConstrainedOperator.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

namespace harmos::latin {

/// The loads l [force] and given displacements g [length] of the bodies and load steps of an OperatorGroup, in its
/// symbols, and which of them each of its columns has: those of its load step, and some times those of a body whose
/// response was added to it.
///
/// Vectors have the numbering and the axes of the operator, one column per body and load step; those of a body lie
/// together.
class ColumnLoads {
 public:
  /// In the place of a column of loads: none.
  static constexpr int none = -1;

  /// Both must outlive it.
  ColumnLoads(const ConstrainedOperator& constrained, const substructure::SubstructureSolver& solver)
      : operator_(constrained), solver_(solver) {}

  /// Sets l, which it takes for its own, and g (0 x 0: none), dofs x (bodies * steps). Costs nothing when they are
  /// those set last.
  void set(base::Matrix& loads, const base::Matrix& held);
  /// How often set() has met others than before.
  long changes() const { return changes_; }
  /// Columns of l.
  int count() const { return count_; }
  /// P (l - A g); 0 x 0: none.
  const base::Matrix& projected() const { return projected_; }

  /// Says which column of l each column has, or none.
  void select(std::vector<int> loadOf);
  /// Column of l that a column has, or none.
  int of(int column) const { return loadOf_[column]; }
  /// Keeps the columns of l selected, one for each body, as those of the response that addUnit() adds.
  void keepUnit() { unitLoadOf_ = loadOf_; }
  /// A column has those of a body, counted from 0, times `factor` as well.
  void addUnit(int column, int member, double factor);
  /// A column has only its own.
  void forgetUnit(int column) { factor_[column] = 0.0; }

  /// Adds P (l - A g) of a column, all rows.
  void addForces(int column, double* to) const { add(projected_, column, to); }
  /// Adds `times` g of a column, all rows.
  void addHeld(int column, double* to, double times = 1.0) const { add(held_, column, to, times); }
  /// Takes l of a column from `to`, rows ConstrainedOperator::heldDofs().
  void subtractAtHeldDofs(int column, double* to) const { add(atHeldDofs_, column, to, -1.0); }
  /// Adds S^-1 P (l - A g) + g of a column, all rows, where the solver has a trace.
  void addMotion(int column, double* to) const { add(motions_, column, to); }
  /// Finds what addTraceMotion() needs for these columns, if any has loads.
  void prepareTraceMotions(const std::vector<int>& columns);
  /// Adds the trace of S^-1 P (l - A g) + g of a column without added responses.
  void addTraceMotion(int column, double* to) const;
  /// Largest component of the motions that are at hand [length].
  double largestMotion() const;

 private:
  /// Whether P (l - A g) is not l.
  bool isHeld() const { return !operator_.heldDofs().empty() || held_.numCols() > 0; }
  /// l of the last set(); 0 x 0: none.
  const base::Matrix& given() const { return isHeld() ? given_ : projected_; }
  /// Solves S x = P (l - A g), as many columns at once as their copies are small for: `keep` takes the first one's
  /// number and x.
  void solveInWindows(const std::function<void(int first, const base::Matrix& solution)>& keep) const;
  /// Takes A g from projected_.
  void subtractHeldForces();
  /// Adds to all rows of `to` what a field with the columns of l holds for a column.
  void add(const base::Matrix& field, int column, double* to, double times = 1.0) const;

  const ConstrainedOperator& operator_;
  const substructure::SubstructureSolver& solver_;
  base::Matrix given_;     // l as it was given, where isHeld(); 0 x 0: none
  bool areKnown_ = false;  // the following belong to it and to g
  long changes_ = 0;
  int count_ = 0;
  base::Matrix projected_;
  base::Matrix held_;          // g; 0 x 0: none
  base::Matrix motions_;       // where the solver has a trace, all dofs; 0 x 0: none
  base::Matrix traceMotions_;  // elsewhere their trace; 0 x 0: not asked for
  base::Matrix atHeldDofs_;    // l there
  std::vector<int> loadOf_;
  std::vector<int> unitLoadOf_;  // one per body: those of the kept response
  std::vector<int> unitOf_;      // body whose response was added to a column
  std::vector<double> factor_;   // how much of it
};

}  // namespace harmos::latin
