#pragma once

#include <limits>
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
  /// Whether traces of bodies are inverted where many solves are expected.
  enum class Inversion { automatic, always, never };

  /// The default solver.
  SolverOptions();
  /// The solver of this name.
  explicit SolverOptions(std::string solverName) : name(std::move(solverName)) {}
  /// From a list that was checked against describe().
  explicit SolverOptions(const input::Parameters& given);
  /// Whether a trace of so many rows is kept dense, beside a sparse factor of so many entries.
  bool keepsDense(double rows, double entries) const;
  /// Whether it is inverted then: what that takes is saved by the solves that are expected.
  bool inverts(double rows, double entries) const;
  /// Whether columns of a factor that have the same rows are worked on together: Harmos' own solvers.
  bool hasSupernodes() const;
  /// Declares the entries of the list Linear Solver.
  static void describe(input::ParameterSpec& spec);

  std::string name;                                   ///< default: cholmod, or tacho where CHOLMOD is not built in
  Teuchos::RCP<Teuchos::ParameterList> parameters{};  ///< handed to Amesos2 as they are; null: its defaults
  Inversion inversion = Inversion::automatic;         ///< as it was asked for
  /// Dense traces may be inverted too, also in single precision, which pays when single load steps are solved many
  /// times. CHOLMOD only: other solvers have no dense trace.
  bool invertTrace = false;
  /// Then: columns for which operators will be solved on the trace. What prepares for them must cost less than it
  /// saves; infinite: it always does.
  double traceSolves = std::numeric_limits<double>::infinity();
  /// The same for which all of a body will be asked for.
  double wholeSolves = std::numeric_limits<double>::infinity();
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
