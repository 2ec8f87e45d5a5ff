#include <harmos/parametric/ParametricStudy.hpp>

#include <cmath>

#include <harmos/results/StatusName.hpp>

namespace harmos::parametric {
namespace {

constexpr std::size_t fewConfigurations = 10;
// Linear stages of a configuration among others at 1 %, and how they grow with a finer accuracy; and how often all
// displacements of its load steps are asked for.
constexpr double stagesAmongOthers = 4.0, usualAccuracy = 1e-2, powerOfAccuracy = 0.3, looks = 3.0;
// Not tried below; single precision errs as far as changes go, and the stage of all load steps is in double.
constexpr double roughAccuracy = 1e-5;

}  // namespace

ParametricStudy::ParametricStudy(assembly::Assembly& assembly, Install install,
                                 std::vector<std::shared_ptr<const latin::Response>> responses,
                                 const latin::LatinOptions& options, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                                 base::Timers& timers)
    : solver_(assembly, std::move(install), std::move(responses), options, comm, timers),
      calibrated_(solver_),
      certified_(solver_) {}

void ParametricStudy::resume(const std::vector<EarlierResult>& earlier) {
  for (const EarlierResult& one : earlier) {
    solver_.widen(one.configuration.values);
    solvedEarlier_ += results::isSolved(one.result.status) ? 1 : 0;
  }
  calibrated_.resume(earlier);
}

void ParametricStudy::run(const std::vector<design::Configuration>& open, results::ResultSink& sink) {
  for (const design::Configuration& configuration : open) solver_.widen(configuration.values);
  const latin::LatinOptions& options = solver_.options();
  const std::size_t all = open.size() + static_cast<std::size_t>(solvedEarlier_ + solver_.states().count());
  certified_.run(certifiesEach(options, all) ? open : calibrated_.run(open, sink), sink);
}

bool certifiesEach(const latin::LatinOptions& options, std::size_t configurations) {
  return configurations < fewConfigurations || options.stages.formulation == latin::Formulation::velocity ||
         options.algorithm != latin::Algorithm::accelerated;
}

latin::LatinOptions optionsForStudy(latin::LatinOptions options, std::size_t configurations, int steps) {
  using Inversion = substructure::SolverOptions::Inversion;
  substructure::SolverOptions& solver = options.stages.solver;
  const bool marches = configurations >= fewConfigurations && options.accuracy >= roughAccuracy;
  solver.invertTrace = solver.inversion == Inversion::always || (solver.inversion == Inversion::automatic && marches);
  const double columns = static_cast<double>(configurations) * steps;
  solver.wholeSolves = looks * columns;
  if (solver.inversion != Inversion::automatic) return options;
  solver.traceSolves = columns * stagesAmongOthers * std::pow(usualAccuracy / options.accuracy, powerOfAccuracy);
  return options;
}

}  // namespace harmos::parametric
