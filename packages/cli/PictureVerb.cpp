#include <filesystem>

#include <harmos/base/Error.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/files/PythonPackage.hpp>

namespace harmos::cli {

namespace {

int picture(const Arguments& arguments, const CommandEnvironment& environment) {
  arguments.requireOperands({"RESULT.e"});
  const std::string result = arguments.operands()[0];
  if (!environment.isRoot()) return 0;
  if (!std::filesystem::exists(result))
    throw base::Error("Cannot read " + result + ": there is no such file.", base::ExitCode::input);
  std::vector<std::string> words = {
      "picture", result, arguments.value("--output", std::filesystem::path(result).replace_extension(".png").string())};
  for (const std::string option : {"--field", "--step", "--scale", "--width", "--interfaces"}) {
    if (arguments.has(option)) words.push_back(option + "=" + arguments.value(option, ""));
  }
  return files::runPythonPackage(std::move(words), environment.interrupted, false).exitCode;
}

}  // namespace

Command pictureCommand() {
  return {
      "picture",
      "RESULT.e",
      "Draw a field of a result on the deformed parts to a PNG file; needs no display.",
      {{"--output", "FILE.png", "the picture (default: beside the result, with its name)"},
       {"--field", "FIELD", "von_mises (default), displacement, pressure, slip, status, safety, gaping, or a variable"},
       {"--step", "N", "load step, 0 is unloaded; negative ones count from the end (default: the last)"},
       {"--scale", "S", "factor on the displacements (default: a visible one)"},
       {"--width", "PIXELS", "of the picture (default: 1600)"},
       {"--interfaces", "NAMES", "draw fields of interfaces on these, with commas between (default: all contacts)"}},
      {"harmos picture results/bolted_joint.e --field pressure --output pressure.png",
       "harmos picture results/bolted_joint.e --field safety --step 5"},
      picture};
}

}  // namespace harmos::cli
