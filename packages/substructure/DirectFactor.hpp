#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Tpetra.hpp>
#include <harmos/substructure/SolverFactory.hpp>
#include <harmos/substructure/SolverOptions.hpp>

namespace harmos::substructure {

class TraceInverse;

/// A symmetric positive definite matrix A [force/length] as a direct solver of Amesos2 has factored it, with its trace
/// where that is cheaper, and in single precision where that is wanted.
///
/// Not collective: the matrix lives on one process. Not for several threads at once: solves share workspaces.
class DirectFactor {
 public:
  /// Orders and factors; solvers other than cholmod and tacho keep the matrix. `trace`: rows, ascending, that
  /// right-hand sides of solveTrace() load; empty: none. Throws std::bad_alloc or TooLarge when it does not fit,
  /// another std::runtime_error when the solver finds that it is not positive definite; as requireSolver().
  DirectFactor(const Teuchos::RCP<const base::CrsMatrix>& matrix, const SolverOptions& options,
               const std::vector<int>& trace);
  /// Frees the factors.
  ~DirectFactor();
  /// Takes over the factors; the other one may only be destroyed or assigned to then.
  DirectFactor(DirectFactor&&) noexcept;
  /// The same.
  DirectFactor& operator=(DirectFactor&&) noexcept;

  /// x = A^-1 b; both have the rows of A and no gaps between columns, different objects. `roughly`: in single
  /// precision, where hasSingle().
  void solve(const base::Matrix& b, base::Matrix& x, bool roughly) const;
  /// True when solveTrace() exists because it is cheaper than solve().
  bool solvesTrace() const { return trace_ || inverse_; }
  /// x = B A^-1 B^T b with B the restriction to the trace. Only if solvesTrace().
  void solveTrace(const base::Matrix& b, base::Matrix& x, bool roughly) const;

  /// Prepares what solves in single precision need, of the trace if solvesTrace(), where the solver has it. `trace`: of
  /// single(), see SingleFactor::setTrace().
  void prepareSingle(const std::vector<int>& trace);
  /// Frees what prepareSingle() has prepared for solve().
  void dropSingle() { single_.reset(); }
  /// Whether solves in single precision differ from the others.
  bool hasSingle() const { return single_ || inverse_; }
  /// The one of solve() in single precision; null: none.
  const SingleFactor* single() const { return single_.get(); }
  /// Entries of the factor, zeros stored for speed included; 0 when the solver does not say.
  std::size_t nonzeros() const;

 private:
  Teuchos::RCP<const base::CrsMatrix> matrix_;  // without entries where the solver needs its factors only
  Teuchos::RCP<DirectSolver> solver_;
  std::unique_ptr<TraceFactor> trace_;
  std::unique_ptr<TraceInverse> inverse_;  // instead of trace_
  std::unique_ptr<SingleFactor> single_;   // of the whole, where nothing is known of a trace
};

}  // namespace harmos::substructure
