#include <ostream>

#include <harmos/base/BlasBuffer.hpp>
#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/cli/detail/StudyProgress.hpp>
#include <harmos/cli/detail/StudyText.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/study/StudyRun.hpp>

namespace harmos::cli {

namespace {

/// The number of ranks that the option gives.
int countOf(const std::string& text) {
  const auto count = base::parseInteger(text);
  if (count && *count > 0) return *count;
  throw base::Error("harmos study: --ranks-per-configuration " + text + ": write a whole number above 0.",
                    base::ExitCode::input);
}

int study(const Arguments& arguments, const CommandEnvironment& environment) {
  base::reserveBlasBuffer();
  arguments.requireOperands({"STUDY.xml"});
  const bool isQuiet = arguments.has("--quiet");
  const bool isShown = environment.isRoot() && !isQuiet;

  study::StudyRunRequest request;
  request.study = arguments.operands()[0];
  request.overrides = arguments.values("--set");
  request.pointsFile = arguments.value("--points", "");
  request.directory = arguments.value("--output", "results");
  request.restart = arguments.has("--restart");
  request.anySize = arguments.has("--any-size");
  if (arguments.has("--ranks-per-configuration")) {
    request.ranksPerConfiguration = countOf(arguments.value("--ranks-per-configuration", ""));
  }
  request.interrupted = environment.interrupted;
  StudyProgress progress(environment.err, environment.terminal);
  if (isShown) {
    request.started = [&](const study::Study& plan, const results::StudyResults& results, int damaged) {
      printPlan(environment.out, plan);
      if (results.count() > 0) environment.out << results.count() << " of them are known from an earlier run\n";
      if (damaged > 0) environment.out << damaged << " damaged lines of the journal were passed over\n";
      environment.out << std::flush;
      progress.begin(results);
    };
    request.message = [&](const std::string& sentence) { environment.out << sentence << "\n" << std::flush; };
    request.observer = [&](const results::StudyResults& results) { progress.report(results); };
  }
  const study::StudyRunResult result = study::runStudy(request, laws::builtInLaws(), environment.communicator);
  if (isShown) {
    progress.finish();
    environment.out << result.state << ", ";
    printOutcome(environment.out, *result.results);
    environment.out << result.files.file << "\n" << result.files.table << "\n" << result.files.dakota << "\n";
    if (result.results->statistics()) {
      for (const std::string& path : result.files.stochastic.written()) environment.out << path << "\n";
    }
  } else if (environment.isRoot() && result.exitCode != 0) {
    environment.err << result.state << ", ";
    printOutcome(environment.err, *result.results);
  }
  return result.exitCode;
}

}  // namespace

Command studyCommand() {
  return {
      "study",
      "STUDY.xml",
      "Solve a parametric or stochastic study; the same command resumes it.",
      {{"--points", "FILE.csv", "the rows of this table instead of the study's design"},
       {"--output", "DIR", "folder of the results (default: results)"},
       {"--set", "'LIST/NAME=VALUE'", "replace an entry of the study, or with Scene/ before it of its scene", true},
       {"--ranks-per-configuration", "N", "ranks that solve one configuration together (default: 1)"},
       {"--any-size", "", "study also a mesh that is foreseen to need more memory than is free"},
       {"--restart", "", "forget the results of an earlier run"},
       {"--quiet", "", "print only errors"}},
      {"harmos study xml/bolted_joint_study.xml",
       "harmos study xml/bolted_joint_study.xml --set Accuracy=1e-3 --set Parameters/mu/Count=3 --output coarse",
       "harmos study xml/glued_assembly_chaos.xml",
       "harmos study xml/bolted_joint_study.xml --points points.csv --set 'Scene/Solver/Interface Mass=Consistent'"},
      study};
}

}  // namespace harmos::cli
