#include <filesystem>

#include <harmos/base/Error.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/files/OutputGuard.hpp>
#include <harmos/files/PythonPackage.hpp>

namespace harmos::cli {

namespace {

namespace fs = std::filesystem;

int trade(const Arguments& arguments, const CommandEnvironment& environment) {
  arguments.requireOperands({"SCENE.xml"});
  if (!environment.isRoot()) return 0;
  const std::string input = arguments.operands()[0];
  if (!fs::exists(input)) throw base::Error("Cannot read " + input + ": there is no such file.", base::ExitCode::input);
  files::demandFolder(arguments.value("--output", "results"));
  // Every run is one of this very program, in a process of its own.
  std::vector<std::string> words = {"trade", input, "--program=" + fs::read_symlink("/proc/self/exe").string()};
  for (const std::string option : {"--output", "--budget", "--memory", "--targets", "--responses"}) {
    if (arguments.has(option)) words.push_back(option + "=" + arguments.value(option, ""));
  }
  if (arguments.has("--quiet")) words.emplace_back("--quiet");
  return files::runPythonPackage(std::move(words), environment.interrupted, false).exitCode;
}

}  // namespace

Command tradeCommand() {
  return {"trade",
          "SCENE.xml",
          "Measure what accuracy costs for a scene or a study, and write the cheapest settings that keep it.",
          {{"--output", "DIR", "folder of the page, the tables and the settings (default: results)"},
           {"--budget", "TIME", "wall time that measuring may take, such as 90s, 10min or 2h (default: 10min)"},
           {"--memory", "SIZE", "that one run may take, such as 8GB (default: 80 % of what is free)"},
           {"--targets", "ERRORS", "that settings are wanted for (default: 1%,0.1%,0.01%)"},
           {"--responses", "NAMES", "that errors are counted of, with commas between (default: all)"},
           {"--quiet", "", "no line per run"}},
          {"harmos trade xml/bolted_joint.xml --budget 5min",
           "harmos trade xml/glued_assembly_chaos.xml --targets 5%,1% --output trade"},
          trade};
}

}  // namespace harmos::cli
