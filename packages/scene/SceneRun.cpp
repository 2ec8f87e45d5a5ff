#include <harmos/scene/SceneRun.hpp>

#include <chrono>
#include <cmath>
#include <ctime>
#include <exception>
#include <filesystem>
#include <optional>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/AllRanks.hpp>
#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/base/SoleThread.hpp>
#include <harmos/files/AtomicFile.hpp>
#include <harmos/files/HistoryFile.hpp>
#include <harmos/files/OutputGuard.hpp>
#include <harmos/files/PendingResults.hpp>
#include <harmos/latin/Derivatives.hpp>
#include <harmos/scene/LawParameters.hpp>
#include <harmos/scene/MemoryPerRank.hpp>
#include <harmos/scene/Problem.hpp>
#include <harmos/scene/ProblemCost.hpp>
#include <harmos/scene/detail/EffectiveScene.hpp>
#include <harmos/scene/detail/FieldOutput.hpp>
#include <harmos/scene/detail/SolutionSummary.hpp>

namespace harmos::scene {

namespace {

const char* statusOf(const latin::LatinResult& solution) {
  switch (solution.outcome) {
    case latin::Outcome::certified:
      return solution.isUnique() ? "certified" : "certified, not unique";
    case latin::Outcome::iterationLimit:
    case latin::Outcome::roundOff:
      return "not converged";
    case latin::Outcome::noEquilibrium:
      return "no equilibrium";
    case latin::Outcome::interrupted:
      return "interrupted";
  }
  return "";
}

/// Keeps the record and its times up to date.
class Recorder {
 public:
  Recorder(files::RunRecord& record, const std::string& path, const base::Timers& timers,
           const Teuchos::Comm<int>& comm)
      : record_(record), path_(path), timers_(timers), comm_(comm) {
    record_.ranks = comm.getSize();
  }

  /// Collective, because the peak memory is that of all ranks.
  void write() {
    const double mine = static_cast<double>(base::peakMemory());
    double largest = mine;
    Teuchos::reduceAll(comm_, Teuchos::REDUCE_MAX, mine, Teuchos::outArg(largest));
    record_.peakMemory = static_cast<std::size_t>(largest);
    if (comm_.getRank() == 0) writeHere();
  }

  /// On whichever rank meets a failure: the others may not hear of it.
  void writeFailure(const std::exception& error) {
    record_.status = "failed";
    record_.reason = base::messageOf(error);
    record_.exitCode = static_cast<int>(base::exitCodeOf(error));
    try {
      writeHere();
    } catch (const base::Error&) {
      // The first failure is what is reported; it may well be the cause of this one.
    }
  }

 private:
  void writeHere() {
    record_.phases = timers_.phases();
    record_.wallSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    record_.cpuSeconds = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    files::writeRunRecord(path_, record_);
  }

  files::RunRecord& record_;
  std::string path_;
  const base::Timers& timers_;
  const Teuchos::Comm<int>& comm_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void describe(const latin::LatinResult& solution, const std::vector<double>& times, files::RunRecord& record) {
  record.status = statusOf(solution);
  record.reason = solution.reason;
  record.remarks = solution.remarks;
  record.steps = static_cast<int>(times.size());
  record.solvedSteps = solution.solvedSteps;
  if (solution.solvedSteps < record.steps) {
    record.reason += solution.solvedSteps == 0
                         ? "; no load step was solved, and none is written"
                         : "; the last load step that was solved, and is written, is " +
                               std::to_string(solution.solvedSteps) + " of " + std::to_string(record.steps) +
                               ", time " + base::toText(times[solution.solvedSteps - 1]);
  }
  record.exitCode = exitCodeOf(solution.outcome);
  record.errorEstimate = solution.errorEstimate;
  record.roundOffEstimate = solution.roundOffEstimate;
  record.responseErrors.clear();
  record.responseSizes.clear();
  for (const auto& response : solution.responses) {
    record.responseErrors.emplace_back(response.name, response.errorEstimate);
    record.responseSizes.emplace_back(response.name, response.size);
  }
  record.responseRanges.clear();
  for (const auto& response : solution.responses) {
    if (response.range.widest() < 0) continue;
    record.responseRanges.push_back({response.name, response.range.lower, response.range.upper});
  }
  record.responseErrors.emplace_back("interface forces", solution.forceErrorEstimate);
  record.responseErrors.emplace_back("interface displacements", solution.displacementErrorEstimate);
  record.iterations = solution.iterations;
  record.linearStages = solution.linearStages;
}

void describe(const MeshErrors& errors, files::RunRecord& record) {
  for (const ResponseMeshError& error : errors.responses) record.meshErrors.push_back(recordOf(error));
  for (const PartMeshError& error : errors.parts) record.meshEnergyShares.emplace_back(error.part, error.energyShare);
}

std::string unitsOf(const Scene& scene) {
  return scene.input.has("Units") ? scene.input.text("Units") : "";
}

files::History historyOf(const latin::LatinResult& solution, const Scene& scene) {
  const std::vector<double>& times = scene.times;
  files::History history;
  history.units = unitsOf(scene);
  for (const auto& response : solution.responses) history.responses.push_back(response.name);
  history.times = {0.0};
  history.values = {std::vector<double>(solution.responses.size(), 0.0)};
  for (int t = 0; t < solution.solvedSteps; ++t) {
    history.times.push_back(times[t]);
    history.values.emplace_back();
    for (const auto& response : solution.responses) history.values.back().push_back(response.values[t]);
  }
  return history;
}

std::vector<GlobalVariable> globalsOf(const latin::LatinResult& solution, std::size_t steps) {
  std::vector<GlobalVariable> globals;
  for (const auto& response : solution.responses) globals.push_back({response.name, response.values});
  const auto add = [&](const std::string& name, double value) {
    const bool taken = std::any_of(globals.begin(), globals.end(), [&](const auto& g) { return g.name == name; });
    if (!taken) globals.push_back({name, std::vector<double>(steps, value)});
  };
  add("latin_iterations", solution.iterations);
  // Readers choke on what is not a number; missing data is 0, and the record tells the two apart.
  add("error_estimate", std::isfinite(solution.errorEstimate) ? solution.errorEstimate : 0.0);
  return globals;
}

/// What has none is a remark.
std::vector<files::ResponseDerivative> differentiate(
    const std::vector<std::string>& entries, LawParameters& parameters, const base::Matrix& state,
    latin::FixedPoint& fixedPoint, const std::vector<std::shared_ptr<const latin::Response>>& responses,
    std::vector<std::string>& remarks) {
  std::vector<latin::ModelParameter> all;
  for (const std::string& entry : entries) all.push_back(parameters.parameter(entry));
  const auto found = latin::Derivatives(fixedPoint, responses).compute(state, all);
  for (const auto& one : found) remarks.insert(remarks.end(), one.missing.begin(), one.missing.end());
  std::vector<files::ResponseDerivative> derivatives;
  for (std::size_t j = 0; j < responses.size(); ++j) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      derivatives.push_back({responses[j]->name(), entries[i], found[i].responses[j], found[i].residuals});
    }
  }
  return derivatives;
}

}  // namespace

int exitCodeOf(latin::Outcome outcome) {
  switch (outcome) {
    case latin::Outcome::certified:
      return static_cast<int>(base::ExitCode::ok);
    case latin::Outcome::iterationLimit:
    case latin::Outcome::roundOff:
      return static_cast<int>(base::ExitCode::notConverged);
    case latin::Outcome::noEquilibrium:
      return static_cast<int>(base::ExitCode::noEquilibrium);
    case latin::Outcome::interrupted:
      return 130;
  }
  return static_cast<int>(base::ExitCode::failure);
}

SceneRunResult runScene(const SceneRunRequest& request, const laws::LawRegistry& laws,
                        const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  const base::SoleThread inside(comm->getSize());  // libraries of files are made for one thread, too
  base::Timers timers;
  const input::InputTree tree = request.input ? *request.input : input::InputTree::fromFile(request.scene);
  Scene scene = makeScene(tree, request.scene, request.overrides, laws);
  SceneRunResult result{{}, {}, {}, {}, files::ResultFiles(request.directory, request.scene)};
  Recorder recorder(result.record, result.files.record, timers, *comm);
  latin::LatinOptions options = scene.solver;
  files::demandDistinct(inputFiles(scene), result.files.all());
  base::onFirstRank(*comm, [&] { files::demandWritable(result.files.all()); });
  if (!request.anySize) demandRoomForMesh(scene, memoryOfAllRanks(*comm));
  Problem problem = makeProblem(scene, *comm, timers, Cutting::automatic);
  if (!request.anySize) demandCapacity(problem, options, static_cast<int>(scene.output.derivatives.size()), *comm);
  for (const auto& [part, pieces] : problem.pieces) scene.input.setInNamed("Parts", part, "Pieces", pieces);
  for (const std::string& part : problem.iterated)
    scene.input.setInNamed("Parts", part, "Linear Solver", std::string("Iterative"));

  result.record.scene = request.scene;
  result.record.units = unitsOf(scene);
  result.record.warnings = problem.warnings;
  result.record.cuts = problem.cuts;
  result.record.accuracy = options.accuracy;
  result.record.status = "running";
  result.record.reason = "The run has not ended, or was killed.";
  std::optional<files::PendingResults> pending;  // on rank 0
  std::optional<files::LastWords> lastWords;     // there as well
  if (comm->getRank() == 0) {
    pending.emplace(result.files);
    result.record.earlier = files::earlierRecord(result.files);
    files::RunRecord interrupted = result.record;
    interrupted.status = "interrupted";
    interrupted.reason = "It was ended before its results were complete.";
    interrupted.exitCode = exitCodeOf(latin::Outcome::interrupted);
    lastWords.emplace(result.files.record, files::toJson(interrupted));
  }
  recorder.write();
  // On other machines it may not be there.
  if (std::filesystem::is_directory(request.directory)) options.stages.scratch = request.directory;
  try {
    latin::LatinSolver solver(problem.assembly, options, comm, timers);
    for (const auto& response : problem.responses) solver.addResponse(response);
    if (request.observer) solver.addObserver(request.observer);
    if (request.interrupted) solver.setInterrupt(request.interrupted);
    result.solution = solver.solve();
    const auto writing = timers.start("write");
    const files::ResultFiles& files = pending ? pending->files() : result.files;
    {
      const int steps = result.solution.solvedSteps;
      const InterfaceFields fields(solver.state());  // of many load steps too large to be kept beside the estimates
      if (steps > 0) result.record.solution = summarise(problem, solver.state(), fields, steps - 1);
      result.hasFields = scene.output.fields;
      if (result.hasFields) {
        result.record.solution.largestVonMises =
            writeFields(scene, problem, solver.state(), fields, globalsOf(result.solution, scene.times.size()), steps,
                        files, *comm);
      }
    }
    if (pending) {
      files::replaceFile(files.effectiveInput, effectiveScene(scene, result.files.effectiveInput));
      files::writeHistory(files.history, historyOf(result.solution, scene));
      pending->commit(result.hasFields);
      lastWords.reset();
      result.record.earlier.clear();
    }
    const bool canEstimate = result.solution.outcome == latin::Outcome::certified &&
                             solver.fixedPoint().formulation() == latin::Formulation::displacement;
    const bool canDifferentiate = canEstimate && !scene.output.derivatives.empty();
    base::Matrix state;  // estimates end the fields
    if (canDifferentiate) state = latin::Derivatives::stateOf(solver.state());
    if (problem.assembly.path && scene.input.list("Solver").flag("Mesh Error")) {
      result.solution.remarks.emplace_back(
          "the error of the mesh is not estimated where loads are found (Path Following)");
    }
    if (scene.wantsMeshErrors && canEstimate) {
      const auto estimating = timers.start("mesh error");
      result.meshErrors = estimateMeshErrors(problem, solver.fixedPoint(), solver.state(), problem.responses, *comm);
      if (comm->getRank() == 0) {
        files::History history = historyOf(result.solution, scene);
        for (const auto& error : result.meshErrors.responses) history.meshErrors.push_back(recordOf(error));
        files::writeHistory(result.files.history, history);
      }
    }
    if (canDifferentiate) {
      const auto differentiating = timers.start("derivatives");
      LawParameters parameters(tree, request.scene, request.overrides, laws, problem.assembly);
      result.derivatives = differentiate(scene.output.derivatives, parameters, state, solver.fixedPoint(),
                                         problem.responses, result.solution.remarks);
    }
    if (comm->getRank() == 0) files::writeDerivatives(result.files.derivatives, scene.times, result.derivatives);
  } catch (const std::exception& error) {
    recorder.writeFailure(error);
    throw;
  }
  describe(result.solution, scene.times, result.record);
  describe(result.meshErrors, result.record);
  recorder.write();
  return result;
}

}  // namespace harmos::scene
