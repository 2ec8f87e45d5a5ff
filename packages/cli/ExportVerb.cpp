#include <filesystem>

#include <harmos/base/Error.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/files/PythonPackage.hpp>

namespace harmos::cli {

namespace {

int exportResult(const Arguments& arguments, const CommandEnvironment& environment) {
  arguments.requireOperands({"RESULT.e"});
  const std::string result = arguments.operands()[0];
  if (!environment.isRoot()) return 0;
  if (!std::filesystem::exists(result))
    throw base::Error("Cannot read " + result + ": there is no such file.", base::ExitCode::input);
  std::vector<std::string> words = {
      "export", result, arguments.value("--output", std::filesystem::path(result).replace_extension("").string())};
  if (arguments.has("--step")) words.push_back("--step=" + arguments.value("--step", ""));
  return files::runPythonPackage(std::move(words), environment.interrupted, false).exitCode;
}

}  // namespace

Command exportCommand() {
  return {"export",
          "RESULT.e",
          "Write a result as .vtu files of VTK, one per load step, with .pvd "
          "files that list them.",
          {{"--output", "DIR", "folder of the files (default: beside the result, with its name)"},
           {"--step", "N",
            "this load step only, 0 is unloaded; negative ones count from the "
            "end (default: all)"}},
          {"harmos export results/bolted_joint.e --output vtu"},
          exportResult};
}

}  // namespace harmos::cli
