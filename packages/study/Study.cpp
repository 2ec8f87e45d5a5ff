#include <harmos/study/Study.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/input/Override.hpp>
#include <harmos/scene/Plugins.hpp>
#include <harmos/scene/SceneSpec.hpp>

namespace harmos::study {

bool Study::isAdaptive() const {
  if (stochastic) return stochastic->method == StochasticPlan::Method::adaptive;
  return design.as<AdaptiveOptions>() != nullptr;
}

scene::Scene Study::sceneFor(const std::vector<double>& values, const laws::LawRegistry& laws) const {
  const input::ParameterSpec spec = scene::sceneSpec(scene::lawsOf(sceneTree, scene.path, {}, laws));
  input::InputTree tree = sceneTree;
  input::ErrorList errors;
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    for (const std::string& entry : parameters[p].entries) {
      const std::string location = parameters[p].name;
      input::applyChange(tree, spec, {entry, base::toText(values[p]), location}, location, errors);
    }
  }
  try {
    errors.throwIfAny();
    return scene::makeScene(tree, scene.path, {}, laws);
  } catch (const input::InputErrors& error) {
    // Elsewhere things are run: the closing line about the number of errors is not for a table.
    throw base::Error(error.list(), error.code());
  }
}

std::vector<std::string> inputFiles(const Study& study) {
  std::vector<std::string> files = scene::inputFiles(study.scene);
  files.push_back(study.path);
  if (!study.pointsFile.empty()) files.push_back(study.pointsFile);
  for (const StudyParameter& parameter : study.parameters) {
    if (!parameter.sampleFile.empty()) files.push_back(parameter.sampleFile);
  }
  return files;
}

}  // namespace harmos::study
