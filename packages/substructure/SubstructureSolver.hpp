#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Tpetra.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/substructure/BoundaryTerm.hpp>
#include <harmos/substructure/CrsMatrix.hpp>
#include <harmos/substructure/DirectFactor.hpp>
#include <harmos/substructure/IterativeSolver.hpp>
#include <harmos/substructure/MirrorPlanes.hpp>
#include <harmos/substructure/Precision.hpp>
#include <harmos/substructure/SingleFactor.hpp>
#include <harmos/substructure/SolverOptions.hpp>

namespace harmos::substructure {

class DifferenceProduct;

/// The operator A = K + k h [force/length] of one substructure, factored, for any number of right-hand sides at once: x
/// [length] from b [force]. K is the stiffness, k the search direction [stress/length], h the interface mass [area].
/// Where a part is its own mirror image, with what is added and with its trace, what is even and what is odd about the
/// plane are factored by themselves: for every plane two factors of half the size, which in space take half of the
/// operations and four fifths of the entries. Where it is too large to be factored it is solved iteratively instead;
/// then there is nothing for its trace or in single precision.
///
/// Rounded entries of A and its factors move a slender part by far more than 1e-16 of what forces move it: one solution
/// tells by how much, see solutionError().
///
/// Not collective: the matrix lives on one process. Not for several threads at once: solves share workspaces.
class SubstructureSolver {
 public:
  /// Builds and factors the sum and checks it with one solve. Nothing of the arguments is kept; solvers other than
  /// cholmod and tacho keep A.
  ///
  /// stiffness: K [force/length], symmetric, both triangles stored. boundary: k h. partName: for messages. trace: dofs,
  /// ascending, that right-hand sides of solveTrace() load; empty: none. nodes: coordinates [length], by which mirror
  /// planes are found; empty: none are looked for, and errors of solutions are not known.
  /// isKnownRegular: the factor is taken whatever round-off leaves of the solution, where it need not be exact.
  /// Throws base::Error naming the part when the sum is singular (a part that nothing holds) or indefinite; then says
  /// which node has an unusable diagonal entry, if one has. Also when memory does not suffice, K is not as viewOf()
  /// wants it, or the boundary term has other rows; as requireSolver(). Limit: an LU solver such as klu2 factors
  /// indefinite matrices without complaint; only the diagonal and the energy of one solve are checked then.
  SubstructureSolver(const Teuchos::RCP<const base::CrsMatrix>& stiffness, const BoundaryTerm& boundary,
                     const SolverOptions& options, std::string partName, const std::vector<int>& trace = {},
                     const std::vector<base::Vector3>& nodes = {}, bool isKnownRegular = false);
  /// Iterates instead of factoring, see IterativeSolver, up to the tolerance of the options. `nodes`: coordinates
  /// [length]. Throws the same, and where conjugate gradients do not converge.
  static SubstructureSolver iterating(const Teuchos::RCP<const base::CrsMatrix>& stiffness,
                                      const BoundaryTerm& boundary, const SolverOptions& options, std::string partName,
                                      const std::vector<base::Vector3>& nodes);
  /// Frees the factors.
  ~SubstructureSolver();
  /// Takes over the factors; the other one may only be destroyed or assigned to then.
  SubstructureSolver(SubstructureSolver&&) noexcept;
  /// The same.
  SubstructureSolver& operator=(SubstructureSolver&&) noexcept;

  /// x = A^-1 b, column by column; b and x are dofs x any number, different objects. x is reshaped when it does not
  /// have the shape of b; iterations start from it when it has. Throws base::Error when b has other rows than the
  /// matrix, either has gaps between columns, or iterations do not converge.
  void solve(const base::Matrix& b, base::Matrix& x, Precision precision = Precision::exact) const;

  /// Relative error of a solution in double precision [-], of one for random forces in balance, which deform the part
  /// where it is softest: the norm of what another solution says of b - A x over that of x, with DifferenceProduct,
  /// both without rigid motions, since how far a soft support lets a part move costs no digits of how it deforms; 0:
  /// not known.
  double solutionError() const { return solutionError_; }

  /// Whether solves are iterations, which end before round-off.
  bool iterates() const { return iterative_ != nullptr; }
  /// What iterations have left of b [force], b - A x; only if iterates().
  base::Matrix residual(const base::Matrix& b, const base::Matrix& x) const { return iterative_->residual(b, x); }

  /// Prepares what Precision::single needs, half of memory() more, and measures its error; later calls do nothing.
  /// Where the options do not allow it, the solver has none, or its error is too large to be of use, all solves stay
  /// exact. Returns singleError().
  double prepareSingle();
  /// e = |x - A^-1 b| / |A^-1 b| of solves in single precision [-], the largest of some right-hand sides with random
  /// entries, to which the part answers as softly as it can; 0: they are exact. Errors of others with forces as large
  /// are as large, so that the relative one exceeds e where forces are balanced and the part answers stiffly.
  double singleError() const { return singleError_; }

  /// True when solveTrace() exists because it is cheaper than solve().
  bool solvesTrace() const { return solvesTrace_; }
  /// True when solveTrace() exists in single precision only, as a part of solve().
  bool solvesTraceInSingle() const { return !solvesTrace_ && hasTrace_ && singleError_ > 0.0; }
  /// x = B A^-1 B^T b with B the restriction to the trace: rows as in `trace`, which is not checked, any number of
  /// columns, different objects. x is reshaped when it does not have the shape of b. Only if solvesTrace(), or in
  /// single precision if solvesTraceInSingle().
  void solveTrace(const base::Matrix& b, base::Matrix& x, Precision precision = Precision::exact) const;
  /// Only if solvesTraceInSingle(): the factors of the blocks that solveTrace() is split() into, each solved for by its
  /// SingleFactor::solveTrace(), and join()ed; else empty.
  std::vector<const SingleFactor*> singleFactors() const;
  /// The right-hand sides of the blocks: b, rows as in the trace, changed by the mirror planes.
  std::vector<base::Matrix> split(const base::Matrix& b) const { return split(tracePlanes_, &Block::traceRows, b); }
  /// x of its parts, in the order of split(); it is reshaped when it does not have their shape.
  void join(const std::vector<base::Matrix>& parts, base::Matrix& x) const {
    join(tracePlanes_, &Block::traceRows, parts, x);
  }

  /// Rows of A.
  int dofs() const { return dofs_; }
  /// Mirror planes by which the operator is cut into blocks.
  int mirrorPlanes() const { return planes_.count(); }
  /// Entries of the factors, zeros stored for speed included; 0 when the solver does not say, or there are none.
  std::size_t factorNonzeros() const;
  /// Entries that a column of solve(), or of solveTrace() if solvesTrace(), meets.
  std::size_t entriesMet() const;
  /// Memory of the factors [byte], estimated from factorNonzeros(), without that of the trace and of single precision.
  std::size_t memory() const { return factorNonzeros() * sizeof(double); }

 private:
  /// What is even and odd about the same planes.
  struct Block {
    std::vector<int> rows, traceRows;  // of A and of the trace, after the change
    std::vector<int> within;           // places of traceRows in rows
    DirectFactor factor;
  };

  SubstructureSolver(int dimension, std::string partName);
  /// A, whose diagonal is positive; sets what goes with its size.
  Teuchos::RCP<base::CrsMatrix> makeSum(const base::CrsMatrix& stiffness, const BoundaryTerm& boundary);
  void checkDiagonal(const CrsView& matrix) const;
  /// `mayBeDense`: whether solvesTrace() may come of it.
  void factor(const Teuchos::RCP<base::CrsMatrix>& sum, const SolverOptions& options, const std::vector<int>& trace,
              bool mayBeDense = true);
  DirectFactor factorOf(const Teuchos::RCP<base::CrsMatrix>& matrix, const SolverOptions& options,
                        const std::vector<int>& trace) const;
  std::vector<base::Matrix> split(const MirrorPlanes& planes, std::vector<int> Block::*rows,
                                  const base::Matrix& b) const;
  void join(const MirrorPlanes& planes, std::vector<int> Block::*rows, const std::vector<base::Matrix>& parts,
            base::Matrix& x) const;
  /// Applies the factor of every block to its rows of b, changed by the planes.
  template <class Apply>
  void solveBlocks(const MirrorPlanes& planes, std::vector<int> Block::*rows, const base::Matrix& b, base::Matrix& x,
                   const Apply& apply) const;
  void measureError(const DifferenceProduct& product, const std::vector<base::Vector3>& nodes, bool isKnownRegular);
  void checkSolution(const base::CrsMatrix& sum, bool isKnownRegular = false) const;
  [[noreturn]] void throwSingular() const;
  [[noreturn]] void throwIndefinite() const;

  std::string part_;
  int dimension_;
  int dofs_ = 0;
  MirrorPlanes planes_{0}, tracePlanes_{0};
  std::vector<Block> blocks_;                   // of factors; one without planes; none: iterates
  std::unique_ptr<IterativeSolver> iterative_;  // null: does not
  double solutionError_ = 0.0;
  bool isHeld_ = false;  // as far as is known: so that no rigid motion makes it singular
  bool solvesTrace_ = false, hasTrace_ = false;
  bool mayPrepareSingle_ = false;
  double singleError_ = 0.0;
};

}  // namespace harmos::substructure
