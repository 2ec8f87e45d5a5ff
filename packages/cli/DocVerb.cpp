#include <ostream>

#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/input/Documentation.hpp>
#include <harmos/scene/SceneSpec.hpp>
#include <harmos/study/StudySpec.hpp>

namespace harmos::cli {

namespace {

int printReference(const Arguments& arguments, const CommandEnvironment& environment) {
  std::string topic;
  for (const auto& word : arguments.operands()) topic += (topic.empty() ? "" : " ") + word;
  const std::string text = input::documentation({scene::sceneSpec(laws::builtInLaws()), study::studySpec()}, topic);
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

}  // namespace harmos::cli
