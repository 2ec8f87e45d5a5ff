#include <filesystem>

#include <harmos/base/Error.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/files/OutputGuard.hpp>
#include <harmos/files/PythonPackage.hpp>

namespace harmos::cli {

namespace {

const std::vector<CommandOption>& options() {
  static const std::vector<CommandOption> all = {
      {"--output", "DIR", "folder that gets the mesh and the scene"},
      {"--units", "'LENGTH FORCE TIME'", "units of the file, such as 'mm N s', which the scene then declares"},
      {"--hold", "SET", "side set or node set that is held; may be repeated", true},
      {"--load", "SET", "side set that gets a traction; may be repeated", true},
      {"--perfect", "INTERFACE", "interface that joins perfectly; may be repeated", true},
      {"--preload", "PART=FORCE", "force to which a bolt of a drawing is tightened; may be repeated", true},
      {"--size", "SIZE", "of the elements of a drawing (default: a twentieth of its diagonal)"},
      {"--part-size", "PART=SIZE", "of those of one part of a drawing; may be repeated", true},
      {"--order", "1|2", "of the elements of a drawing (default: 1)"},
      {"--conformal", "", "parts of a drawing that touch share nodes (default: meshed one by one)"}};
  return all;
}

int import(const Arguments& arguments, const CommandEnvironment& environment) {
  arguments.requireOperands({"FILE"});
  if (!arguments.has("--output"))
    throw base::Error("harmos import: name a folder for the mesh and the scene: --output DIR.", base::ExitCode::input);
  if (!environment.isRoot()) return 0;
  files::demandFolder(arguments.value("--output", ""));
  std::vector<std::string> words = {"import"};
  for (const CommandOption& option : options()) {
    for (const std::string& value : arguments.values(option.name))
      words.push_back(option.value.empty() ? option.name : option.name + "=" + value);
  }
  words.insert(words.end(), {"--", arguments.operands()[0]});
  return files::runPythonPackage(std::move(words), environment.interrupted, false).exitCode;
}

}  // namespace

Command importCommand() {
  return {"import",
          "FILE --output DIR",
          "Make a mesh and a starting scene of a mesh, a deck or a drawing of another program.",
          options(),
          {"harmos import bracket.msh --output bracket", "harmos import joint.inp --output joint --units 'mm N s'",
           "harmos import pump.step --output pump --size 4 --part-size bolt_1=2 --hold base_face_3"},
          import};
}

}  // namespace harmos::cli
