#include <harmos/cli/detail/ResultVerb.hpp>
#include <harmos/cli/detail/Verbs.hpp>

namespace harmos::cli {

namespace {

const std::vector<CommandOption>& options() {
  static const std::vector<CommandOption> all = {
      {"--output", "DIR", "folder of the files (default: beside the result, with its name)"},
      {"--step", "N",
       "this load step only, 0 is unloaded; negative ones count from the "
       "end (default: all)"}};
  return all;
}

int exportResult(const Arguments& arguments, const CommandEnvironment& environment) {
  return runOnResult("export", "", options(), arguments, environment);
}

}  // namespace

Command exportCommand() {
  return {"export",
          "RESULT.e",
          "Write a result as .vtu files of VTK, one per load step, with .pvd "
          "files that list them.",
          options(),
          {"harmos export results/bolted_joint.e --output vtu"},
          exportResult};
}

}  // namespace harmos::cli
