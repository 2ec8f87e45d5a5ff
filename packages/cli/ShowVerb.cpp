#include <filesystem>

#include <harmos/base/Error.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/files/PythonPackage.hpp>

namespace harmos::cli {

namespace {

int show(const Arguments& arguments, const CommandEnvironment& environment) {
  arguments.requireOperands({"RESULT.e"});
  const std::string result = arguments.operands()[0];
  if (!environment.isRoot()) return 0;
  if (!std::filesystem::exists(result))
    throw base::Error("Cannot read " + result + ": there is no such file.", base::ExitCode::input);
  std::vector<std::string> words = {
      "show", result, arguments.value("--output", std::filesystem::path(result).replace_extension(".html").string())};
  for (const std::string option : {"--steps", "--scale"}) {
    if (arguments.has(option)) words.push_back(option + "=" + arguments.value(option, ""));
  }
  return files::runPythonPackage(std::move(words), environment.interrupted, false).exitCode;
}

}  // namespace

Command showCommand() {
  return {"show",
          "RESULT.e",
          "Write one HTML page in which the assembly can be turned in a browser, with all its fields.",
          {{"--output", "FILE.html", "the page (default: beside the result, with its name)"},
           {"--steps", "N", "load steps in the page, the unloaded start among them (default: 12)"},
           {"--scale", "S", "factor on the displacements at first (default: a visible one)"}},
          {"harmos show results/bolted_joint.e --output joint.html"},
          show};
}

}  // namespace harmos::cli
