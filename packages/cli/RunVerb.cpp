#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include <harmos/base/BlasBuffer.hpp>
#include <harmos/base/Error.hpp>
#include <harmos/cli/detail/Progress.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/cli/detail/Warnings.hpp>
#include <harmos/scene/SceneRun.hpp>
#include <harmos/study/StudyReader.hpp>

namespace harmos::cli {

namespace {

void printEstimate(std::ostream& out, double estimate) {
  if (std::isfinite(estimate)) {
    out << "error estimate " << estimate;
  } else {
    out << "error not estimated";
  }
}

std::string placeOf(const files::WorstPoint& point) {
  // What is 0 but for the round-off of a mesh generator.
  const double nothing = 1e-12 * base::norm(point.position);
  std::ostringstream text;
  text << std::setprecision(4);
  const char* before = "(";
  for (const double x : point.position) {
    text << before << (std::abs(x) <= nothing ? 0.0 : x);
    before = ", ";
  }
  return text.str() + ")";
}

void printSafety(std::ostream& out, const char* against, const std::optional<files::SafetyRecord>& safety) {
  if (!safety) return;
  out << "least safety against " << against << "  " << safety->whole << " of " << safety->worst.of << ", "
      << safety->worst.value << " at " << placeOf(safety->worst) << "\n";
}

/// The three numbers that decide.
void printDecision(std::ostream& out, const files::SolutionRecord& solution) {
  out << std::setprecision(4);
  if (const auto& peak = solution.largestVonMises) {
    out << "largest von Mises stress (" << peak->at << ")  " << peak->point.value << " in " << peak->point.of << " at "
        << placeOf(peak->point) << "\n";
  }
  printSafety(out, "slip", solution.slip);
  printSafety(out, "gaping", solution.gaping);
}

/// The range at the last load step, or where it is determined there, at the one at which it is widest.
void printRange(std::ostream& out, const latin::ResponseRange& range, int last) {
  constexpr double nothing = 1e-3;  // of the largest width: below the digits that are shown
  const int widest = range.widest();
  if (widest < 0) return;
  const double width = range.upper[last] - range.lower[last];
  const int step = width < nothing * range.width() ? widest : last;
  out << ", not unique";
  if (step != last) out << " at load step " << step + 1;
  out << std::setprecision(5) << ": from " << range.lower[step] << " to " << range.upper[step] << std::setprecision(2);
}

void printSummary(std::ostream& out, const scene::SceneRunResult& result) {
  const auto& record = result.record;
  printWarnings(out, record.warnings);
  if (!record.cuts.empty()) out << record.cuts << "\n";
  out << record.status << ": " << record.reason << "\n" << std::setprecision(3);
  for (const std::string& remark : record.remarks) out << "remark: " << remark << "\n";
  printEstimate(out, record.errorEstimate);
  out << " (asked for " << record.accuracy << "), " << record.iterations << " iterations, " << record.linearStages
      << " linear stages, " << record.wallSeconds << " s\n";
  for (const auto& response : result.solution.responses) {
    if (result.solution.solvedSteps == 0) break;
    out << "  " << std::left << std::setw(24) << response.name << std::right << std::setprecision(7) << std::setw(15)
        << response.values[result.solution.solvedSteps - 1] << std::setprecision(2) << "  ";
    if (std::isfinite(response.errorEstimate)) out << "+- " << response.errorEstimate * response.size << ", ";
    printEstimate(out, response.errorEstimate);
    printRange(out, response.range, result.solution.solvedSteps - 1);
    if (response.isSmall) out << ", counts as zero: not above " << response.size;
    for (const scene::ResponseMeshError& error : result.meshErrors.responses) {
      if (error.response != response.name) continue;
      out << "; " << scene::describe(error, response.values[result.solution.solvedSteps - 1]);
    }
    out << "\n";
  }
  printDecision(out, record.solution);
  if (result.hasFields) out << result.files.parts << "\n" << result.files.interfaces << "\n";
  out << result.files.history << "\n";
}

int run(const Arguments& arguments, const CommandEnvironment& environment) {
  base::reserveBlasBuffer();
  arguments.requireOperands({"SCENE.xml"});
  const std::string& path = arguments.operands()[0];
  if (study::isStudyFile(path)) {
    throw base::Error(path + " is a study.\n  Write: harmos study " + path, base::ExitCode::input);
  }
  const bool isQuiet = arguments.has("--quiet");
  auto detail = arguments.has("--verbose") ? Progress::Detail::everyIteration : Progress::Detail::sparse;
  if (isQuiet || !environment.isRoot()) detail = Progress::Detail::none;

  scene::SceneRunRequest request;
  request.scene = path;
  request.overrides = arguments.values("--set");
  request.directory = arguments.value("--output", "results");
  request.anySize = arguments.has("--any-size");
  request.interrupted = environment.interrupted;
  Progress progress(environment.err, detail, environment.terminal);
  request.observer = [&progress](const latin::IterationReport& report) { progress.report(report); };
  const scene::SceneRunResult result = scene::runScene(request, laws::builtInLaws(), environment.communicator);
  progress.finish();
  if (environment.isRoot() && !isQuiet) printSummary(environment.out, result);
  if (environment.isRoot() && isQuiet && result.record.exitCode != 0)
    environment.err << result.record.status << ": " << result.record.reason << "\n";
  return result.record.exitCode.value();
}

}  // namespace

Command runCommand() {
  return {"run",
          "SCENE.xml",
          "Solve a scene and write its results.",
          {{"--output", "DIR", "folder of the results (default: results)"},
           {"--set", "'LIST/NAME=VALUE'", "replace an entry of the scene; may be repeated", true},
           {"--any-size", "", "run also what is foreseen to need more memory than is free"},
           {"--verbose", "", "one line per iteration"},
           {"--quiet", "", "print only errors"}},
          {"harmos run xml/bolted_joint.xml",
           "harmos run xml/bolted_joint.xml --set 'Solver/Accuracy=1e-5' --set 'Values/mu=0.2' --output fine"},
          run};
}

}  // namespace harmos::cli
