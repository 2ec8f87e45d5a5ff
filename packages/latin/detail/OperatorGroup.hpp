#pragma once

#include <memory>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/StepsAtOnce.hpp>
#include <harmos/latin/detail/ColumnLoads.hpp>
#include <harmos/latin/detail/ConstrainedOperator.hpp>
#include <harmos/latin/detail/HeldStencil.hpp>
#include <harmos/substructure/Substructure.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

namespace harmos::latin {

/// One factored operator S = P A P + d (1 - P), A = K + k h + s, and the fields of the bodies that share it, all in the
/// numbering and the axes of the first of them.
///
/// Vectors are columns: of loads and of held displacements one per body and load step, of the others one per body and
/// column selected; those of a body lie together. With P f = 0 in the held directions, in which u = g is given,
///   S u' = P (f + l - A g),  u = u' + g,  reaction = (1 - P) (A u - f - l).
class OperatorGroup {
 public:
  /// Factors the operator of `body`, or prepares its iterative solution where the body says so; the stiffness of
  /// `first`, which it equals, is shared. Throws as SubstructureSolver.
  OperatorGroup(const substructure::Substructure& body, const substructure::Substructure& first,
                substructure::BoundaryTerm term, const substructure::SolverOptions& options);
  OperatorGroup(const OperatorGroup&) = delete;
  OperatorGroup& operator=(const OperatorGroup&) = delete;
  /// Whether a body of the same stiffness has this operator, up to round-off, and its solution.
  bool has(const substructure::BoundaryTerm& term, bool iterates) const {
    return solver_.iterates() == iterates && operator_.has(term);
  }

  /// See ColumnLoads::set().
  void setLoads(base::Matrix& loads, const base::Matrix& held) { loads_.set(loads, held); }
  /// What was set.
  const ColumnLoads& loads() const { return loads_; }
  /// Makes room for so many columns in all, and says which column of the loads each takes, or ColumnLoads::none; so
  /// many bodies share them.
  void select(std::vector<int> loadColumns, int bodies);

  /// Rows of forces() and solution(): dofs that interfaces load.
  int rows() const { return static_cast<int>(operator_.trace().size()); }
  /// All rows of the operator.
  int dofs() const { return solver_.dofs(); }
  /// Entries of the factors that a column reads; 0 when the solver does not say.
  std::size_t entries() const { return solver_.entriesMet(); }
  /// See SubstructureSolver::solutionError().
  double solutionError() const { return solver_.solutionError(); }
  /// Where the first component of a node that an interface loads stands in forces() and solution().
  int rowOf(int dof) const { return operator_.traceRow(dof); }
  /// f [force], to be filled for the columns that are solved next.
  base::Matrix& forces() { return forces_; }
  /// To be called when forces() has changed in a way that moves no body, after the last solve.
  void keepSolution() { hasReactions_ = false; }
  /// Solves these columns, by single ones when they are not all; in single precision their traces: other dofs are found
  /// when they are asked for.
  void solve(const std::vector<int>& columns, substructure::Precision precision);
  /// See SubstructureSolver::singleFactors().
  std::vector<const substructure::SingleFactor*> singleFactors() const { return solver_.singleFactors(); }
  /// Of these columns, instead of solve() in single precision: the right-hand sides of the blocks of singleFactors(),
  std::vector<base::Matrix> split(const std::vector<int>& columns);
  /// and what is to be done when each has been solved for.
  void join(const std::vector<int>& columns, const std::vector<base::Matrix>& parts);
  /// Keeps the last solve, of one column for each body, as a response that addUnit() adds. setLoads() ends it.
  void keepUnit();
  /// Adds the response of a body, counted from 0 in the group, times `factor` to a column of the last solve.
  void addUnit(int column, int member, double factor);
  /// See SubstructureSolver::prepareSingle().
  double prepareSingle() { return solver_.prepareSingle(); }
  /// Rows of forces() of the last solve [length].
  const base::Matrix& solution() const { return solution_; }
  /// u [length] of a dof. Of many load steps, those of a dof that is neither loaded by interfaces nor held are best
  /// asked for one load step after the other: a window of them is kept.
  const double* displacement(int dof, int column) const;
  /// S^-1 P f for any f, dofs x columns: without loads and held displacements.
  void solveLinearly(base::Matrix& forces, base::Matrix& solution) const;
  /// Largest component of the solution, and `share` of what the loads do where only the trace is solved.
  double largestDisplacement(double share) const;

  /// Forces [force], rows and columns as those of loads(), like those that round-off leaves in A u of the last solve,
  /// see ConstrainedOperator::addRoundOff(). What iterations have left is added. All load steps must have been solved.
  base::Matrix roundOffForces(unsigned seed) const;
  /// Square of the norm of what iterations have left of the last solve [force]; 0 without iterations.
  double squaredResidual() const;
  /// See ConstrainedOperator::stiffnessNorm().
  double stiffnessNorm() const { return operator_.stiffnessNorm(); }

  /// Place of a node among those that are held, or -1.
  int heldPlace(int node) const { return operator_.heldPlace(node); }
  /// Reaction [force] of a held node, of the last solve.
  base::Vector3 reaction(int place, int column) const;

 private:
  /// Columns, by their first one of each body, of which all dofs are at hand together.
  struct Window {
    int first = 0, count = 0;
  };

  bool isTrace() const { return solver_.solvesTrace(); }
  /// Whether all dofs of all columns are at hand once they are solved for exactly; iterations start from them.
  bool keepsAll() const { return !isTrace() && (solver_.iterates() || columnsOfBody_ <= stepsAtOnce); }
  /// Whether they are.
  bool hasAll() const { return keepsAll() && !isTraceOnly_; }
  /// Whether what held nodes need is found without a solve of the whole: not once that was made, but then to the end.
  bool usesStencil() const { return stencil_ && (isByStencil_ || window_.count == 0); }
  /// Whether displacements of held nodes are kept with their reactions.
  bool keepsHeld() const { return usesStencil() || (!keepsAll() && columnsOfBody_ > stepsAtOnce); }
  std::vector<Window> windows() const;
  /// The columns of a window, those of a body together.
  std::vector<int> columnsOf(const Window& window) const;
  /// All dofs of a column of the last solve [length]; valid until that of another window is asked for.
  const double* whole(int column) const;
  void solveWhole(const Window& window) const;
  void solveTraces(const std::vector<int>& columns, substructure::Precision precision);
  void solveAll(const std::vector<int>& columns, substructure::Precision precision);
  /// P f of columns on the trace.
  base::Matrix traceForces(const std::vector<int>& columns) const;
  /// Adds what loads do to the trace of these columns, and keeps it.
  void keepTraces(const std::vector<int>& columns, const base::Matrix& traces);
  /// P (f + l - A g) of columns, all dofs.
  base::Matrix forcesOf(const std::vector<int>& columns) const;
  /// u' of columns, all dofs, where keepsAll().
  base::Matrix movedOf(const std::vector<int>& columns) const;
  /// What iterations have left of all columns.
  base::Matrix residual() const;
  const base::Matrix& reactions() const;
  /// The reactions of a column, and displacements where they are kept, from all of u.
  void react(int column, const double* u) const;
  /// Lets go of what of a solve is computed when asked for.
  void forgetDerived();
  /// Reactions and displacements of all columns without a solve of the whole.
  void reactByStencil() const;

  ConstrainedOperator operator_;
  substructure::SubstructureSolver solver_;
  ColumnLoads loads_;
  mutable std::unique_ptr<HeldStencil> stencil_;  // where traces are inverted: solves are many; null: not worthwhile
  int columnsOfBody_ = 0;
  base::Matrix unitForces_, unitSolution_, unitAll_;  // of the kept response, one column per body
  std::vector<double> unitLargest_;                   // largest component of it, where all dofs are at hand
  base::Matrix forces_;
  base::Matrix solution_;
  base::Matrix all_;                  // where keepsAll(), else 0 x 0: all dofs of the last solves, if hasAll()
  bool isTraceOnly_ = false;          // the last solve found traces only, though no trace is kept dense
  std::vector<double> largest_;       // elsewhere without a trace: no component of a column is larger
  mutable base::Matrix whole_;        // all dofs of a window, computed when asked for
  mutable Window window_;             // no columns: none
  mutable base::Matrix reactions_;    // computed when asked for
  mutable base::Matrix atHeldDofs_;   // u with them, if keepsHeld()
  mutable bool isByStencil_ = false;  // the last of these were
  mutable bool hasReactions_ = false;
};

}  // namespace harmos::latin
