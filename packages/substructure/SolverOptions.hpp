#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

namespace harmos::input {
class ParameterSpec;
class Parameters;
}  // namespace harmos::input

namespace harmos::substructure {

/// Which direct solver factors the substructures: a name of availableSolvers(), in upper or lower case.
/// The name is not checked before requireSolver() or makeSolver().
struct SolverOptions {
  /// The default solver.
  SolverOptions();
  /// The solver of this name.
  explicit SolverOptions(std::string solverName) : name(std::move(solverName)) {}
  /// From a list that was checked against describe().
  explicit SolverOptions(const input::Parameters& given);
  /// Entries of the square of a trace that are worth as much as one of the sparse factor: where it has no more of them,
  /// a part's trace is kept dense. 0: this solver keeps none dense.
  double denseTraceWorth() const;
  /// Whether columns of a factor that have the same rows are worked on together: Harmos' own solvers.
  bool hasSupernodes() const;
  /// Declares the entries of the list Linear Solver.
  static void describe(input::ParameterSpec& spec);

  std::string name;                                   ///< default: cholmod, or tacho where CHOLMOD is not built in
  Teuchos::RCP<Teuchos::ParameterList> parameters{};  ///< handed to Amesos2 as they are; null: its defaults
  /// A dense trace is inverted too, in single precision, which pays when single load steps are solved many times.
  /// CHOLMOD only: other solvers have no dense trace.
  bool invertTrace = false;
  /// Energy error [-] at which solutions of bodies that are too large to be factored end, see IterativeSolver.
  double iterationTolerance = 1e-9;
  /// Unknowns of the macro problem from which on ranks share its factor, see DistributedSolver, where that exists.
  int sharedFrom = 20000;
  bool allowsSingle = true;  ///< whether SubstructureSolver::prepareSingle() may prepare anything
};

/// Names that SolverOptions may have in this build: Harmos' own solvers, then those of the installed Amesos2.
std::vector<std::string> availableSolvers();

/// Throws base::Error (input), listing availableSolvers(), unless SolverOptions may have this name, to which all other
/// names by which Amesos2 knows its solvers belong.
void requireSolver(const std::string& name);

}  // namespace harmos::substructure
