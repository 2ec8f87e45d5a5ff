#include <ostream>

#include <harmos/cli/detail/ReferencePages.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/input/Documentation.hpp>
#include <harmos/plugins/LoadPlugin.hpp>
#include <harmos/scene/SceneSpec.hpp>
#include <harmos/study/StudySpec.hpp>

namespace harmos::cli {

namespace {

int printReference(const Arguments& arguments, const CommandEnvironment& environment) {
  std::string topic;
  for (const auto& word : arguments.operands()) topic += (topic.empty() ? "" : " ") + word;
  laws::LawRegistry laws = laws::builtInLaws();
  for (const std::string& plugin : arguments.values("--plugin")) plugins::loadPlugin(plugin, laws);
  const std::string text =
      input::documentation({scene::sceneSpec(laws), study::studySpec()}, topic, referencePages(laws));
  if (environment.isRoot()) environment.out << text;
  return 0;
}

}  // namespace

Command docCommand() {
  return {"doc",
          "[TOPIC]",
          "Print the reference of every input, or of one list, type or page, in Markdown.",
          {{"--plugin", "FILE", "a plugin whose laws are described, too; may be repeated", true}},
          {"harmos doc Solver", "harmos doc Harmos Study", "harmos doc Coulomb Friction", "harmos doc Laws",
           "harmos doc Outputs", "harmos doc Exit Codes", "harmos doc --plugin build/my_laws.so My Law",
           "harmos doc > reference.md"},
          printReference};
}

}  // namespace harmos::cli
