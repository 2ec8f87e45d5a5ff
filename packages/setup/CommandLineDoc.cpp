#include <ostream>

#include <harmos/base/Documentation.hpp>
#include <harmos/setup/CommandLineVerbs.hpp>
#include <harmos/setup/SceneSpec.hpp>
#include <harmos/setup/StudySpec.hpp>

namespace harmos::setup {

namespace {

int printReference(const CommandLineArguments& arguments, const CommandEnvironment& environment) {
  std::string topic;
  for (const auto& word : arguments.operands()) topic += (topic.empty() ? "" : " ") + word;
  const std::string text = base::documentation({sceneSpec(laws::builtInLaws()), studySpec()}, topic);
  if (environment.isRoot()) environment.out << text;
  return 0;
}

}  // namespace

Command docCommand() {
  return {"doc",
          "[TOPIC]",
          "Print the reference of every input, or of one list or type, in Markdown.",
          {},
          {"harmos doc Solver", "harmos doc Harmos Study", "harmos doc Coulomb Friction", "harmos doc > reference.md"},
          printReference};
}

}  // namespace harmos::setup
