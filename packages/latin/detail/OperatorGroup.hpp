#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/detail/HeldStencil.hpp>
#include <harmos/substructure/BoundaryTerm.hpp>
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
  /// Whether a body of the same stiffness has this operator, up to round-off, and its solution.
  bool has(const substructure::BoundaryTerm& term, bool iterates) const;

  /// Sets l [force] and g [length] (0 x 0: none), dofs x (bodies * steps). Costs nothing when they are those set last.
  void setLoads(const base::Matrix& loads, const base::Matrix& held);
  /// How often setLoads() has met others than before.
  long loadChanges() const { return loadChanges_; }
  /// P (l - A g); 0 x 0: none.
  const base::Matrix& loads() const { return loads_; }
  /// Makes room for so many columns in all, and says which column of loads() each takes.
  void select(std::vector<int> loadColumns);

  /// Rows of forces(): dofs, or those of the trace.
  int rows() const { return isTrace() ? static_cast<int>(trace_.size()) : dofs(); }
  /// All rows of the operator.
  int dofs() const { return solver_.dofs(); }
  /// Entries of the factors that a column reads; 0 when the solver does not say.
  std::size_t entries() const { return isTrace() ? trace_.size() * trace_.size() : solver_.factorNonzeros(); }
  /// Where the first component of a node stands in forces() and solution().
  int rowOf(int dof) const;
  /// f [force], to be filled for the columns that are solved next.
  base::Matrix& forces() { return forces_; }
  /// To be called when forces() has changed in a way that moves no body, after the last solve.
  void keepSolution() { hasReactions_ = false; }
  /// Solves these columns, by single ones when they are not all.
  void solve(const std::vector<int>& columns, substructure::Precision precision);
  /// Keeps the last solve, of one column for each body, as a response that addUnit() adds. setLoads() ends it.
  void keepUnit();
  /// Adds the response of a body, counted from 0 in the group, times `factor` to a column of the last solve.
  void addUnit(int column, int member, double factor);
  /// See SubstructureSolver::prepareSingle().
  double prepareSingle() { return solver_.prepareSingle(); }
  /// Rows of forces() of the last solve [length].
  const base::Matrix& solution() const { return solution_; }
  /// All dofs of it.
  const base::Matrix& wholeSolution() const;
  /// u [length] of a dof.
  const double* displacement(int dof, int column) const;
  /// S^-1 P f for any f, dofs x columns: without loads and held displacements.
  void solveLinearly(base::Matrix& forces, base::Matrix& solution) const;
  /// Largest component of the solution, and `share` of what the loads do where only the trace is solved.
  double largestDisplacement(double share) const;

  /// Forces [force], rows and columns as loads(), like those that round-off leaves in A u of the last solve: sum over j
  /// of +-e (a_ii a_jj)^1/2 u_j over the entries of K, e the spacing of numbers at 1, a the diagonal of K + k h. The
  /// signs are symmetric and depend on `seed`, i and j only. What iterations have left is added. All load steps must
  /// have been solved.
  base::Matrix roundOffForces(unsigned seed) const;
  /// Square of the norm of what iterations have left of the last solve [force]; 0 without iterations.
  double squaredResidual() const;
  /// Euclidean norm of the diagonal of K + k h [force/length].
  double stiffnessNorm() const;

  /// Place of a node among those that are held, or -1.
  int heldPlace(int node) const;
  /// Reaction [force] of a held node, of the last solve.
  base::Vector3 reaction(int place, int column) const;

 private:
  bool isTrace() const { return !trace_.empty(); }
  void solveTogether(const std::vector<int>& columns, substructure::Precision precision);
  /// Where iterations start: the last solution of the same columns, without held displacements.
  void guess(const std::vector<int>& columns, base::Matrix& solution) const;
  /// Adds to all rows of `to` what a field with the columns of loads() holds for a column, the kept response included.
  void addLoad(const base::Matrix& field, int column, double* to) const;
  /// Right-hand sides of the last solve, all dofs.
  base::Matrix wholeForces() const;
  base::Matrix residual() const;
  void project(base::Matrix& vectors, bool onTrace) const;
  void multiply(const double* u, const std::vector<int>& rows, double* result) const;
  const base::Matrix& reactions() const;
  /// Where the stencil of held nodes has the displacement of a dof, or -1 when only the whole solution has it.
  int stencilRow(int dof) const;
  /// Displacements [length] of the stencil, one column for each of forces().
  const base::Matrix& stencilSolution() const;
  std::vector<double> diagonal() const;

  Teuchos::RCP<const base::CrsMatrix> stiffness_;
  substructure::BoundaryTerm term_;
  std::vector<int> trace_;  // dofs that interfaces load, ascending, when only these are solved; empty: all are
  substructure::SubstructureSolver solver_;
  std::vector<int> heldDofs_;
  mutable std::unique_ptr<HeldStencil> stencil_;  // where traces are inverted: solves are many; null: not worthwhile
  base::Matrix givenLoads_;                       // l as it was given; 0 x 0: none
  bool areLoaded_ = false;                        // the following belong to it and to g
  long loadChanges_ = 0;
  int cases_ = 0;           // columns of l and g
  base::Matrix loads_;      // P (l - A g); 0 x 0: none
  base::Matrix held_;       // g; 0 x 0: none
  base::Matrix loaded_;     // with a trace: S^-1 loads + g; 0 x 0: none
  base::Matrix heldLoads_;  // l on held nodes
  std::vector<int> loadColumns_;
  std::vector<int> unitColumns_;     // of loads(), one per body: those of the kept response
  base::Matrix unitForces_, unit_;   // of it: f and the solution, one column per body
  std::vector<int> unitOf_;          // body whose response was added to a column
  std::vector<double> unitFactors_;  // how much of it
  base::Matrix forces_;
  base::Matrix solution_;
  mutable base::Matrix whole_;  // with a trace: all dofs, computed when asked for
  mutable bool hasWhole_ = false;
  mutable base::Matrix onStencil_;  // computed when asked for
  mutable bool hasStencil_ = false;
  mutable base::Matrix reactions_;  // computed when asked for
  mutable bool hasReactions_ = false;
};

}  // namespace harmos::latin
