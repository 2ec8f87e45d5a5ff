#include <harmos/cli/detail/ResultVerb.hpp>
#include <harmos/cli/detail/Verbs.hpp>

namespace harmos::cli {

namespace {

const std::vector<CommandOption>& options() {
  static const std::vector<CommandOption> all = {
      {"--output", "FILE.html", "the page (default: beside the result, with its name)"},
      {"--steps", "N", "load steps in the page, the unloaded start among them (default: 12)"},
      {"--scale", "S", "factor on the displacements at first (default: a visible one)"}};
  return all;
}

int show(const Arguments& arguments, const CommandEnvironment& environment) {
  return runOnResult("show", ".html", options(), arguments, environment);
}

}  // namespace

Command showCommand() {
  return {"show",
          "RESULT.e",
          "Write one HTML page in which the assembly can be turned in a browser, with all its fields.",
          options(),
          {"harmos show results/bolted_joint.e --output joint.html"},
          show};
}

}  // namespace harmos::cli
