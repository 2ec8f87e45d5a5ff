#include <harmos/parametric/ParametricStudy.hpp>

#include <harmos/results/StatusName.hpp>

namespace harmos::parametric {
namespace {

constexpr int fewConfigurations = 10;
// Inverting the traces costs about what so many configurations save.
constexpr std::size_t manyConfigurations = 50;
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
  const int all = static_cast<int>(open.size()) + solvedEarlier_ + solver_.states().count();
  const bool isCertified = all < fewConfigurations || options.stages.formulation == latin::Formulation::velocity ||
                           options.algorithm != latin::Algorithm::accelerated;
  certified_.run(isCertified ? open : calibrated_.run(open, sink), sink);
}

latin::LatinOptions optionsForStudy(latin::LatinOptions options, std::size_t configurations) {
  options.stages.solver.invertTrace = configurations >= manyConfigurations && options.accuracy >= roughAccuracy;
  return options;
}

}  // namespace harmos::parametric
