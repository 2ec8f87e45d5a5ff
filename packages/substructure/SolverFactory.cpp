#include <harmos/substructure/SolverFactory.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

#include <Amesos2.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#ifdef HARMOS_CHOLMOD
#include <harmos/substructure/detail/Cholmod.hpp>
#endif
#include <harmos/substructure/detail/TachoDirect.hpp>

namespace harmos::substructure {
namespace {

#ifdef HARMOS_CHOLMOD
constexpr const char* defaultSolver = "cholmod";
#else
constexpr const char* defaultSolver = "tacho";
#endif

// Entries of the square of the trace that are worth as much as one of the sparse factor. A triangular solve reads every
// entry of a factor twice, in double precision; the inverse half of its entries once in single precision.
constexpr double entriesOfTraceFactor = 2.0;
constexpr double entriesOfTraceInverse = 8.0;
// Of the cube of its rows: operations that factoring and inverting a dense trace take; and how many of them take as
// long as reading an entry of a factor.
constexpr double operationsOfInverse = 1.0;
constexpr double operationsOfRead = 5.0;
// What is saved over what it takes: not every load step is solved for, and solves of whole parts take longer then.
constexpr double leastGain = 3.0;

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

}  // namespace

SolverOptions::SolverOptions() : name(defaultSolver) {}

SolverOptions::SolverOptions(const input::Parameters& given)
    : name(given.text("Name")),
      sharedFrom(given.integer("Shared From")),
      allowsSingle(given.text("Precision") == "Automatic") {
  const std::string& inverse = given.text("Trace Inverse");
  inversion = inverse == "Yes" ? Inversion::always : inverse == "No" ? Inversion::never : Inversion::automatic;
}

bool SolverOptions::keepsDense(double rows, double entries) const {
  if (lowerCase(name) != "cholmod" || rows == 0.0) return false;
  return rows * rows < entriesOfTraceFactor * entries || inverts(rows, entries);
}

bool SolverOptions::inverts(double rows, double entries) const {
  const double square = rows * rows;
  if (!invertTrace || lowerCase(name) != "cholmod" || !(square < entriesOfTraceInverse * entries)) return false;
  if (std::isinf(traceSolves)) return true;
  // Otherwise, either is read twice by each column: the dense factor, or the sparse one. All of a body takes a read of
  // the sparse one in any case.
  const double saved = std::min(square, 2.0 * entries) - entriesOfTraceFactor / entriesOfTraceInverse * square;
  return traceSolves * saved > leastGain * operationsOfInverse / operationsOfRead * square * rows;
}

bool SolverOptions::hasSupernodes() const {
  const std::string solver = lowerCase(name);
  return solver == "cholmod" || solver == "tacho";
}

void SolverOptions::describe(input::ParameterSpec& spec) {
  spec.summary("Direct solver that factors every substructure once.");
  spec.text("Name")
      .defaultValue(defaultSolver)
      .doc(
          "cholmod (supernodal, fastest), tacho, or any solver of the installed Amesos2 such as klu2, in upper or "
          "lower "
          "case.");
  spec.text("Precision")
      .defaultValue("Automatic")
      .oneOf({"Automatic", "Double"})
      .doc(
          "Of what only leads to a solution. Automatic: in single precision as long as its error, measured for every "
          "part, is far below what is left to be found; that takes half as much memory again as the factors. What is "
          "delivered, and what is said of its error, is always computed in double precision.");
  spec.text("Trace Inverse")
      .defaultValue("Automatic")
      .oneOf({"Automatic", "Yes", "No"})
      .doc(
          "In studies, of every part: the dense inverse of its operator on what interfaces touch, its trace, which "
          "solves single load steps fastest, but takes time and memory to be made. Automatic: where the number of "
          "configurations and load steps, and the accuracy, make it worth that. Yes: wherever it is not much larger "
          "than the sparse factor. cholmod only.");
  spec.integer("Shared From")
      .defaultValue(SolverOptions().sharedFrom)
      .atLeast(1)
      .doc(
          "Unknowns of the macro problem, six for every interface between two pieces, from which on several ranks "
          "share its factor (MUMPS). With fewer, or where the program was built without MUMPS, every rank has all of "
          "it.");
}

std::vector<std::string> availableSolvers() {
  std::vector<std::string> names;
#ifdef HARMOS_CHOLMOD
  names.emplace_back("cholmod");
#endif
  names.emplace_back("tacho");
  for (const char* name : {"klu2", "basker", "shylubasker", "mumps", "superlu", "superlu_dist", "superlumt", "umfpack",
                           "lapack", "pardisomkl", "strumpack"}) {
    if (Amesos2::query(name)) names.emplace_back(name);
  }
  return names;
}

void requireSolver(const std::string& name) {
  const std::string asked = lowerCase(name);
  const std::vector<std::string> known = availableSolvers();
  // Amesos2 knows some of its solvers by several names.
  if (std::find(known.begin(), known.end(), asked) != known.end() || Amesos2::query(asked)) return;
  throw base::Error(
      "there is no direct solver \"" + name + "\" in this build.\n  " + base::suggestName(asked, known, "Available"),
      base::ExitCode::input);
}

Teuchos::RCP<DirectSolver> makeSolver(const SolverOptions& options, const Teuchos::RCP<const base::CrsMatrix>& matrix,
                                      [[maybe_unused]] const std::vector<int>& trace) {
  const Teuchos::RCP<base::MultiVector> none;
  const std::string name = lowerCase(options.name);
  Teuchos::RCP<DirectSolver> solver;
#ifdef HARMOS_CHOLMOD
  if (name == "cholmod") {
    solver = Teuchos::rcp(new Cholmod<base::CrsMatrix, base::MultiVector>(matrix, none, none, trace, options));
  }
#endif
  if (name == "tacho") {
    solver = Teuchos::rcp(new TachoDirect<base::CrsMatrix, base::MultiVector>(matrix, none, none));
  }
  if (solver.is_null()) {
    requireSolver(options.name);
    solver = Amesos2::create<base::CrsMatrix, base::MultiVector>(name, matrix, none, none);
  }
  if (!options.parameters.is_null()) solver->setParameters(options.parameters);
  return solver;
}

std::unique_ptr<TraceFactor> traceFactor([[maybe_unused]] const DirectSolver& solver) {
#ifdef HARMOS_CHOLMOD
  const auto* cholmod = dynamic_cast<const Cholmod<base::CrsMatrix, base::MultiVector>*>(&solver);
  if (cholmod != nullptr) return cholmod->traceFactor();
#endif
  return nullptr;
}

std::unique_ptr<SingleFactor> singleFactor([[maybe_unused]] const DirectSolver& solver) {
#ifdef HARMOS_CHOLMOD
  const auto* cholmod = dynamic_cast<const Cholmod<base::CrsMatrix, base::MultiVector>*>(&solver);
  if (cholmod != nullptr) return cholmod->singleFactor();
#endif
  return nullptr;
}

}  // namespace harmos::substructure
