#include <harmos/cli/detail/ResultVerb.hpp>
#include <harmos/cli/detail/Verbs.hpp>

namespace harmos::cli {

namespace {

const std::vector<CommandOption>& options() {
  static const std::vector<CommandOption> all = {
      {"--output", "FILE.png", "the picture (default: beside the result, with its name)"},
      {"--field", "FIELD", "von_mises (default), displacement, pressure, slip, status, safety, gaping, or a variable"},
      {"--step", "N", "load step, 0 is unloaded; negative ones count from the end (default: the last)"},
      {"--scale", "S", "factor on the displacements (default: a visible one)"},
      {"--width", "PIXELS", "of the picture (default: 1600)"},
      {"--interfaces", "NAMES", "draw fields of interfaces on these, with commas between (default: all contacts)"}};
  return all;
}

int picture(const Arguments& arguments, const CommandEnvironment& environment) {
  return runOnResult("picture", ".png", options(), arguments, environment);
}

}  // namespace

Command pictureCommand() {
  return {"picture",
          "RESULT.e",
          "Draw a field of a result on the deformed parts to a PNG file; needs no display.",
          options(),
          {"harmos picture results/bolted_joint.e --field pressure --output pressure.png",
           "harmos picture results/bolted_joint.e --field safety --step 5"},
          picture};
}

}  // namespace harmos::cli
