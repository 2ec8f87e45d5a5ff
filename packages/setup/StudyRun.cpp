#include <harmos/setup/StudyRun.hpp>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/setup/ChaosStudy.hpp>
#include <harmos/setup/SceneRun.hpp>
#include <harmos/setup/StochasticFields.hpp>
#include <harmos/setup/StochasticStatistics.hpp>
#include <harmos/setup/StudyIdentity.hpp>
#include <harmos/setup/StudyRunner.hpp>

namespace harmos::setup {

namespace {

int exitCodeOf(const output::StudyResults& results) {
  const auto count = [&](study::Status status) { return results.count(status); };
  const int solved = count(study::Status::certified) + count(study::Status::calibrated);
  const int unbalanced = count(study::Status::noEquilibrium);
  if (solved == results.count()) return static_cast<int>(base::ExitCode::ok);
  return static_cast<int>(solved + unbalanced == results.count() ? base::ExitCode::noEquilibrium
                                                                 : base::ExitCode::notConverged);
}

}  // namespace

StudyRunResult runStudy(const StudyRunRequest& request, const laws::LawRegistry& laws,
                        const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  base::Timers timers;
  StudyRunResult run{
      std::make_unique<const Study>(readStudy(request.study, request.overrides, request.pointsFile, laws)),
      {},
      {},
      output::StudyFiles(request.directory, request.study),
      "",
      0};
  const Study& study = *run.study;
  run.description = std::make_unique<const output::StudyDescription>(describe(study));
  run.results = std::make_unique<output::StudyResults>(*run.description);
  // The points of an adaptive design follow from all results so far.
  StudyTeams teams(comm, study.isAdaptive() ? comm->getSize() : request.ranksPerConfiguration);

  // What is wrong with the mesh is known before anything is written.
  const auto groups = groupByOperators(study.parameters, study.configurations);
  std::unique_ptr<StudyGroup> onlyGroup;
  std::unique_ptr<ChaosStudy> chaos;
  if (study.isChaos()) chaos = std::make_unique<ChaosStudy>(study, laws, comm, timers);
  if (groups.size() == 1) {
    onlyGroup = std::make_unique<StudyGroup>(study, groups.front(), laws, teams.team(), timers);
  } else {
    makeProblem(study.scene, *teams.team(), timers);
  }
  StudyRecorder recorder(run.files, request.restart, *run.results, teams);
  if (request.observer) recorder.setObserver(request.observer);
  if (request.started) request.started(study, *run.results, recorder.damaged());

  StudyRunner runner(study, laws, teams, recorder, request.interrupted, timers);
  latin::Outcome outcome = latin::Outcome::certified;
  try {
    if (chaos) {
      chaos->setInterrupt(request.interrupted);
      if (teams.ownsFiles() && request.message) chaos->setObserver(request.message);
      outcome = chaos->solve();
      if (teams.ownsFiles()) recorder.note("expansions", describe(*chaos, outcome));
    }
    runner.run(std::move(onlyGroup));
    run.state = runner.isAborted() ? "aborted" : runner.isStopped() ? "interrupted" : "complete";
    if (study.stochastic && run.state == "complete" && (!chaos || chaos->isSolved())) {
      recorder.setStatistics(summarise(study, *run.results, chaos.get()));
      if (chaos) writeStochasticFields(study, *chaos, run.files.stochastic, *comm);
    }
  } catch (...) {
    recorder.finish("interrupted");
    throw;
  }
  recorder.finish(run.state);
  run.exitCode = run.state == "aborted"                 ? static_cast<int>(base::ExitCode::failure)
                 : run.state == "interrupted"           ? 130
                 : outcome != latin::Outcome::certified ? exitCodeOf(outcome)
                                                        : exitCodeOf(*run.results);
  // Rank 0 alone knows all results.
  Teuchos::broadcast(*comm, 0, Teuchos::outArg(run.exitCode));
  return run;
}

}  // namespace harmos::setup
