#include <ostream>

#include <harmos/base/Error.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/files/ExodusComparison.hpp>

namespace harmos::cli {

namespace {

int compare(const Arguments& arguments, const CommandEnvironment& environment) {
  arguments.requireOperands({"FIRST.e", "SECOND.e"});
  const std::string file = arguments.value("--tolerances", "");
  const auto tolerances = file.empty() ? files::Tolerances() : files::Tolerances::read(file);
  const auto result = files::compareExodus(arguments.operands()[0], arguments.operands()[1], tolerances);
  if (environment.isRoot()) files::print(environment.out, result, arguments.has("--quiet"));
  return static_cast<int>(result.equal() ? base::ExitCode::ok : base::ExitCode::failure);
}

}  // namespace

Command compareCommand() {
  return {"compare",
          "FIRST.e SECOND.e",
          "Compare two Exodus files node by node, whatever their numbering.",
          {{"--tolerances", "FILE", "what to compare and how strictly, in the syntax of exodiff (default: all, 1e-6)"},
           {"--quiet", "", "print only what differs"}},
          {"harmos compare gold/bolted_joint.e results/bolted_joint.e",
           "harmos compare gold/bolted_joint.e results/bolted_joint.e --tolerances gold/bolted_joint.cmp"},
          compare};
}

}  // namespace harmos::cli
