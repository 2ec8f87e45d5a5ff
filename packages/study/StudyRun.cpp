#include <harmos/study/StudyRun.hpp>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/AllRanks.hpp>
#include <harmos/base/Error.hpp>
#include <harmos/base/SoleThread.hpp>
#include <harmos/files/OutputGuard.hpp>
#include <harmos/scene/MemoryPerRank.hpp>
#include <harmos/scene/ProblemCost.hpp>
#include <harmos/scene/SceneRun.hpp>
#include <harmos/study/StudyReader.hpp>
#include <harmos/study/detail/ChaosStudy.hpp>
#include <harmos/study/detail/StochasticFields.hpp>
#include <harmos/study/detail/StochasticStatistics.hpp>
#include <harmos/study/detail/StudyIdentity.hpp>
#include <harmos/study/detail/StudyRunner.hpp>

namespace harmos::study {

namespace {

int exitCodeOf(const results::StudyResults& results) {
  const int solved = results.solved();
  const int unbalanced = results.count(results::Status::noEquilibrium);
  if (solved == results.count()) {
    return static_cast<int>(results.fallsShort() ? base::ExitCode::notConverged : base::ExitCode::ok);
  }
  return static_cast<int>(solved + unbalanced == results.count() ? base::ExitCode::noEquilibrium
                                                                 : base::ExitCode::notConverged);
}

}  // namespace

StudyRunResult runStudy(const StudyRunRequest& request, const laws::LawRegistry& laws,
                        const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  const base::SoleThread inside(comm->getSize());  // libraries of files are made for one thread, too
  base::Timers timers;
  StudyRunResult run{std::make_unique<const Study>(
                         makeStudy(request.input ? *request.input : input::InputTree::fromFile(request.study),
                                   request.scene.get(), request.study, request.overrides, request.pointsFile, laws)),
                     {},
                     {},
                     files::StudyFiles(request.directory, request.study),
                     "",
                     0};
  const Study& study = *run.study;
  files::demandDistinct(inputFiles(study), run.files.all());
  base::onFirstRank(*comm, [&] { files::demandWritable(run.files.all()); });
  run.description = std::make_unique<const results::StudyDescription>(describe(study));
  run.results = std::make_unique<results::StudyResults>(*run.description);
  // The points of an adaptive design follow from all results so far.
  StudyTeams teams(comm, study.isAdaptive() ? comm->getSize() : request.ranksPerConfiguration);

  if (!request.anySize) scene::demandRoomForMesh(study.scene, scene::memoryOfAllRanks(*comm));
  // What is wrong with the mesh is known before anything is written.
  const auto groups = groupByOperators(study.parameters, study.configurations);
  std::unique_ptr<StudyGroup> onlyGroup;
  std::unique_ptr<ChaosStudy> chaos;
  if (study.isChaos()) chaos = std::make_unique<ChaosStudy>(study, laws, comm, timers);
  if (chaos && groups.size() == 1 && teams.count() == 1) {
    // What varies are laws: the configurations that are held out have the same operators.
    onlyGroup = std::make_unique<StudyGroup>(study, groups.front(), laws, teams.team(), timers, chaos->problem());
  } else if (groups.size() == 1) {
    onlyGroup = std::make_unique<StudyGroup>(study, groups.front(), laws, teams.team(), timers);
  } else if (!chaos) {
    scene::makeProblem(study.scene, *teams.team(), timers);
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
      if (teams.ownsFiles())
        recorder.note("expansions", {describe(*chaos, outcome), outcome != latin::Outcome::certified});
    }
    runner.run(std::move(onlyGroup));
    run.state = runner.isAborted() ? "aborted" : runner.isStopped() ? "interrupted" : "complete";
    if (study.stochastic && run.state == "complete" && (!chaos || chaos->isSolved())) {
      recorder.setStatistics(summarise(study, *run.results, chaos.get()));
      const std::string lack = teams.ownsFiles() ? lackOfStatistics(study, *run.results) : "";
      if (!lack.empty()) recorder.note("moments", {lack});
      if (chaos) writeStochasticFields(study, *chaos, run.files.stochastic, *comm);
    }
  } catch (...) {
    recorder.finish("interrupted");
    throw;
  }
  recorder.finish(run.state);
  run.exitCode = run.state == "aborted"                 ? static_cast<int>(base::ExitCode::failure)
                 : run.state == "interrupted"           ? 130
                 : outcome != latin::Outcome::certified ? scene::exitCodeOf(outcome)
                                                        : exitCodeOf(*run.results);
  // Rank 0 alone knows all results.
  Teuchos::broadcast(*comm, 0, Teuchos::outArg(run.exitCode));
  return run;
}

}  // namespace harmos::study
