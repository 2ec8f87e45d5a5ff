#include <filesystem>

#include <harmos/base/Error.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/files/PythonPackage.hpp>

namespace harmos::cli {

namespace {

const std::vector<CommandOption>& options() {
  static const std::vector<CommandOption> all = {
      {"--output", "DIR", "folder that gets the mesh and the scene"},
      {"--units", "'LENGTH FORCE TIME'", "units of the file, such as 'mm N s', which the scene then declares"}};
  return all;
}

int import(const Arguments& arguments, const CommandEnvironment& environment) {
  arguments.requireOperands({"FILE"});
  if (!arguments.has("--output"))
    throw base::Error("harmos import: name a folder for the mesh and the scene: --output DIR.", base::ExitCode::input);
  if (!environment.isRoot()) return 0;
  std::vector<std::string> words = {"import"};
  for (const CommandOption& option : options()) {
    if (arguments.has(option.name)) words.push_back(option.name + "=" + arguments.value(option.name, ""));
  }
  words.insert(words.end(), {"--", arguments.operands()[0]});
  return files::runPythonPackage(std::move(words), environment.interrupted, false).exitCode;
}

}  // namespace

Command importCommand() {
  return {"import",
          "FILE --output DIR",
          "Make a mesh and a starting scene of a mesh of another program.",
          options(),
          {"harmos import bracket.msh --output bracket", "harmos import joint.med --output joint --units 'mm N s'"},
          import};
}

}  // namespace harmos::cli
