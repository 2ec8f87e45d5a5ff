#include <harmos/study/StudyReader.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/design/ListDesign.hpp>
#include <harmos/design/Plan.hpp>
#include <harmos/input/Check.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/input/Override.hpp>
#include <harmos/scene/Plugins.hpp>
#include <harmos/scene/SceneSpec.hpp>
#include <harmos/study/PointsFile.hpp>
#include <harmos/study/StochasticTails.hpp>
#include <harmos/study/StudyParameters.hpp>
#include <harmos/study/StudySpec.hpp>
#include <harmos/study/detail/DesignRegistry.hpp>

namespace harmos::study {

namespace {

namespace fs = std::filesystem;
using input::Parameters;
using Names = std::vector<std::string>;

const std::vector<double> usualLevels = {0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99};

constexpr const char* scenePrefix = "Scene/";

std::string besides(const std::string& file, const std::string& path) {
  return (fs::path(file).parent_path() / path).lexically_normal().string();
}

/// Applies "List/Name=value" to the scene on behalf of `where`.
void applyToScene(const std::string& assignment, const std::string& where, const input::ParameterSpec& spec,
                  input::InputTree& scene, input::ErrorList& errors) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos) {
    errors.add(where, "\"" + assignment + "\" has no value.", "Write List/Sublist/Name=value.");
    return;
  }
  input::applyChange(scene, spec, {assignment.substr(0, equals), assignment.substr(equals + 1), where}, where, errors);
}

bool has(const input::ParameterSpec& spec, const std::string& name) {
  const auto& entries = spec.entries();
  const auto& lists = spec.sublists();
  return std::any_of(entries.begin(), entries.end(), [&](const auto& entry) { return entry->name == name; }) ||
         std::any_of(lists.begin(), lists.end(), [&](const auto& list) { return list.name == name; });
}

/// Refuses changes of the scene that are written as if they were changes of the study.
void demandPrefix(const Names& changes, const laws::LawRegistry& laws) {
  input::ErrorList errors;
  for (const std::string& change : changes) {
    const std::string first = change.substr(0, change.find_first_of("/="));
    if (has(studySpec(), first) || !has(scene::sceneSpec(laws), first)) continue;
    errors.add("--set '" + change + "'", "the study has no \"" + first + "\", but its scene has.",
               "Write --set '" + (scenePrefix + change) + "'.");
  }
  errors.throwIfAny();
}

class StudyReader {
 public:
  StudyReader(Study& study, const std::string& pointsFile, const laws::LawRegistry& laws)
      : study_(study), input_(study.input), spec_(scene::sceneSpec(laws)), pointsFile_(pointsFile), laws_(laws) {
    study_.pointsFile = pointsFile;
    study_.title = input_.text("Title");
    study_.sideBySide = input_.integer("Side by Side");
    study_.design = study::readDesign(input_);
    if (!pointsFile.empty()) study_.design.options = TableOptions{pointsFile};
    study_.policy = readFailurePolicy(input_);
    const Parameters& statistics = input_.list("Statistics");
    study_.statistics = {statistics.has("Quantiles") ? statistics.numbers("Quantiles") : usualLevels,
                         statistics.integer("Samples"), statistics.integer("Seed")};
  }

  void read(const Names& sceneChanges, const input::InputTree* sceneInput) {
    const std::string path = besides(study_.path, input_.text("Scene"));
    const bool isRead = errors_.collect(input_.where("Scene"), [&] {
      study_.sceneTree = sceneInput != nullptr ? *sceneInput : input::InputTree::fromFile(path);
      if (study_.sceneTree.root.name() == studySpec().name()) {
        throw base::Error(path + " is a study itself, but a scene is wanted.", base::ExitCode::input);
      }
      learnLaws(path, sceneChanges);
      changeScene(sceneChanges);
    });
    if (isRead) readScene(path);
    const std::string directory = fs::path(study_.path).parent_path().string();
    StudyParameterReader reader(study_.sceneTree, isSceneRead_ ? &study_.scene : nullptr, spec_, directory, isListed(),
                                errors_);
    for (const Parameters& parameter : input_.lists("Parameters")) reader.read(parameter);
    study_.parameters = reader.parameters();
    planned_ = reader.planned();
    demandUse(readFormulas());
    if (isSceneRead_ && study_.scene.input.hasList("Path Following")) {
      errors_.add(input_.where("Scene"), "the loads of this scene are found (Path Following), which studies do not do.",
                  "Run its configurations one by one, or prescribe the loads.");
    }
    if (isSceneRead_) {
      for (const Parameters& response : input_.lists("Responses")) readResponse(response);
    }
    checkRecovery();
    if (!isListed()) readRandomness();
    if (study_.isAdaptive() && !study_.stochastic) checkAdaptive();
    if (isSceneRead_ && study_.isChaos()) checkChaos();
    makeConfigurations();
    if (errors_.count() == 0) demandAdmissible();
    if (study_.stochastic && errors_.count() == 0)
      checkTails(
          study_, laws_, [](const scene::Scene&) {}, errors_);
    finish();
  }

 private:
  /// Changes may be of laws that plugins bring.
  void learnLaws(const std::string& path, const Names& sceneChanges) {
    Names changes = input_.has("Scene Overrides") ? input_.texts("Scene Overrides") : Names();
    changes.insert(changes.end(), sceneChanges.begin(), sceneChanges.end());
    try {
      spec_ = scene::sceneSpec(scene::lawsOf(study_.sceneTree, path, changes, laws_));
    } catch (const input::InputErrors&) {
      // Plugins that cannot be used: readScene() reports them.
    }
  }

  void changeScene(const Names& sceneChanges) {
    if (input_.has("Scene Overrides")) {
      for (const std::string& change : input_.texts("Scene Overrides")) {
        applyToScene(change, input_.where("Scene Overrides"), spec_, study_.sceneTree, errors_);
      }
    }
    for (const std::string& change : sceneChanges) {
      applyToScene(change, "--set '" + (scenePrefix + change) + "'", spec_, study_.sceneTree, errors_);
    }
    if (input_.has("Accuracy")) {
      applyToScene("Solver/Accuracy=" + base::toText(input_.number("Accuracy")), input_.where("Accuracy"), spec_,
                   study_.sceneTree, errors_);
    }
  }

  void readScene(const std::string& path) {
    try {
      study_.scene = scene::makeScene(study_.sceneTree, path, {}, laws_);
      isSceneRead_ = true;
    } catch (const base::Error& error) {
      if (error.code() != base::ExitCode::input) throw;
      sceneErrors_ = error.what();
    }
  }

  bool isListed() const { return study_.design.as<TableOptions>() != nullptr; }

  void readRandomness() {
    const bool isRandom = std::any_of(study_.parameters.begin(), study_.parameters.end(),
                                      [](const StudyParameter& parameter) { return parameter.isRandom; });
    if (isRandom) {
      study_.stochastic = readStochasticPlan(input_, study_.design, study_.parameters, errors_);
      return;
    }
    if (study_.design.wantsRandomness()) {
      errors_.add(study_.design.where, "no parameter is random.",
                  "Give at least one of the Parameters a Distribution.");
    }
    for (const char* kind : {"Correlations", "Sweep"}) {
      if (input_.lists(kind).empty()) continue;
      errors_.add(input_.lists(kind).front().where(), "no parameter is random.");
    }
  }

  /// Null when they cannot be read, which is then reported.
  std::shared_ptr<const design::Design> readPointsToBegin() {
    if (study_.stochastic) {
      std::vector<std::vector<double>> points;
      for (const auto& germs : study_.stochastic->germs) points.push_back(study_.stochastic->variables->values(germs));
      return std::make_shared<const design::ListDesign>(std::move(points));
    }
    const auto* table = study_.design.as<TableOptions>();
    if (!table) return study_.design.points;
    study_.pointsFile = pointsFile_.empty() ? besides(study_.path, table->file) : pointsFile_;
    Names names;
    for (const design::PlannedParameter& parameter : planned_) {
      if (parameter.formula.empty()) names.push_back(parameter.axis.name);
    }
    try {
      return std::make_shared<const design::ListDesign>(readPoints(study_.pointsFile, names));
    } catch (const base::Error& error) {
      pointsErrors_ = error.what();
      return nullptr;
    }
  }

  /// Every formula by itself, so that all errors come at once. Returns the names of the parameters that they use.
  Names readFormulas() {
    Names names, used;
    for (const design::PlannedParameter& parameter : planned_) {
      if (input::isFormulaName(parameter.axis.name)) names.push_back(parameter.axis.name);
    }
    for (const char* kind : {"Parameters", "Conditions"}) {
      for (const Parameters& list : input_.lists(kind)) {
        if (!list.has("Formula")) continue;
        errors_.collect(list.where("Formula"), [&] {
          const auto variables = input::Formula(list.text("Formula"), names).variables();
          used.insert(used.end(), variables.begin(), variables.end());
        });
        if (std::string(kind) == "Conditions") {
          conditions_.push_back({list.name(), list.text("Formula"), list.where("Formula")});
        }
      }
    }
    return used;
  }

  void makeConfigurations() {
    if (errors_.count() > 0) return;
    const std::shared_ptr<const design::Design> design = readPointsToBegin();
    if (!design) return;
    errors_.collect(study_.design.where, [&] {
      study_.plan = std::make_shared<design::Plan>(planned_, conditions_);
      if (study_.stochastic && study_.stochastic->germs.empty()) return;
      study_.configurations = study_.plan->configurations(*design);
      study_.leftOut = study_.plan->leftOut();
    });
  }

  void demandUse(const Names& namesInFormulas) {
    for (const StudyParameter& parameter : study_.parameters) {
      const bool isInFormula =
          std::find(namesInFormulas.begin(), namesInFormulas.end(), parameter.name) != namesInFormulas.end();
      if (!parameter.entries.empty() || isInFormula || !parameter.formula.empty()) continue;
      errors_.add(parameter.where, "this parameter changes nothing.",
                  "Give the Entry of the scene that it sets, or use it in a formula.");
    }
  }

  void readResponse(const Parameters& list) {
    checkStudyName(list, errors_);
    Names known;
    for (const Parameters& response : study_.scene.input.lists("Responses")) known.push_back(response.name());
    const auto found = std::find(known.begin(), known.end(), list.text("Response"));
    if (found == known.end()) {
      errors_.add(list.where("Response"), "the scene has no response \"" + list.text("Response") + "\".",
                  base::suggestName(list.text("Response"), known, "It has"));
      return;
    }
    for (const StudyParameter& parameter : study_.parameters) {
      if (parameter.name == list.name()) errors_.add(list.where(), "a parameter has the same name.", "Rename one.");
    }
    using Kind = results::ScalarResponse::Kind;
    results::ScalarResponse response;
    response.name = list.name();
    response.curve = static_cast<std::size_t>(found - known.begin());
    const std::string& type = list.type();
    response.kind = type == "Maximum"             ? Kind::maximum
                    : type == "Minimum"           ? Kind::minimum
                    : type == "Final"             ? Kind::final
                    : type == "Largest Magnitude" ? Kind::largestMagnitude
                                                  : Kind::atTime;
    if (response.kind == Kind::atTime) {
      response.time = list.number("Time");
      if (response.time > study_.scene.times.back()) {
        errors_.add(list.where("Time"), "the scene ends at " + base::toText(study_.scene.times.back()) + ".");
      }
    }
    study_.responses.push_back(std::move(response));
  }

  void checkAdaptive() {
    const std::string& asked = study_.design.as<AdaptiveOptions>()->response;
    Names known;
    for (const Parameters& response : input_.lists("Responses")) known.push_back(response.name());
    if (std::find(known.begin(), known.end(), asked) == known.end()) {
      errors_.add(input_.list("Design").where("Response"), "the study has no response \"" + asked + "\".",
                  base::suggestName(asked, known, "It has"));
    }
    for (std::size_t p = 0; p < planned_.size(); ++p) {
      const design::Axis& axis = planned_[p].axis;
      if (study_.parameters[p].effect == Effect::Kind::operators) {
        errors_.add(study_.parameters[p].where,
                    "an adaptive design varies laws and loads only, but this changes bodies.", "Take another design.");
      }
      const bool isConstant = axis.levels.empty() ? axis.lower == axis.upper : axis.levels.size() == 1;
      if (planned_[p].formula.empty() && isConstant) {
        errors_.add(study_.parameters[p].where, "an adaptive design needs two different values at least.");
      }
    }
  }

  /// What the solver of expansions wants of the scene.
  void checkChaos() {
    const Parameters& solver = study_.scene.input.list("Solver");
    if (solver.text("Formulation") != "Displacement") {
      errors_.add(solver.where("Formulation"), "Chaos wants displacements as the unknowns of the interfaces.",
                  "Take Displacement, or a design of the type Collocation.");
    }
    if (!study_.design.as<ChaosOptions>()->wantsGalerkin()) return;
    for (const char* kind : {"Interfaces", "Boundaries"}) {
      for (const Parameters& interface : study_.scene.input.lists(kind)) {
        if (study_.scene.laws.at(interface.name())->isAffine()) continue;
        errors_.add(input_.list("Design").where("Local Stage"),
                    "Galerkin wants affine laws, but that of \"" + interface.name() + "\" is " +
                        interface.list("Law").type() + ".",
                    "Take Pseudo-Spectral, or Automatic.");
      }
    }
  }

  /// One configuration at least must give a scene: of the others the results tell, and without any there are none.
  void demandAdmissible() {
    std::string first;
    for (const design::Configuration& configuration : study_.configurations) {
      try {
        study_.sceneFor(configuration.values, laws_);
        return;
      } catch (const base::Error& error) {
        if (error.code() != base::ExitCode::input) throw;
        if (first.empty()) first = "configuration " + std::to_string(configuration.id) + ": " + error.what();
      }
    }
    if (first.empty()) return;
    errors_.add(study_.design.where, "no configuration is admissible; the first is " + first);
  }

  void checkRecovery() {
    if (study_.policy.kind != FailurePolicy::Kind::recover) return;
    const std::size_t given = study_.policy.values.size();
    const std::size_t wanted = input_.lists("Responses").size();
    if (given == wanted) return;
    errors_.add(
        input_.list("Failure Policy").where("Values"),
        std::to_string(given) + " values are given, but the study has " + std::to_string(wanted) + " responses.");
  }

  void finish() const {
    std::string text = errors_.message();
    for (const std::string& more : {sceneErrors_, pointsErrors_}) {
      if (!more.empty()) text += (text.empty() ? "" : "\n") + more;
    }
    if (!text.empty()) throw base::Error(text, base::ExitCode::input);
  }

  Study& study_;
  const Parameters& input_;
  input::ParameterSpec spec_;
  std::string pointsFile_;
  const laws::LawRegistry& laws_;
  input::ErrorList errors_;
  bool isSceneRead_ = false;
  std::string sceneErrors_, pointsErrors_;  // lists of their own, about other files
  std::vector<design::PlannedParameter> planned_;
  std::vector<design::Condition> conditions_;
};

}  // namespace

bool isStudyFile(const std::string& path) {
  return input::InputTree::fromFile(path).root.name() == studySpec().name();
}

Study readStudy(const std::string& path, const std::vector<std::string>& overrides, const std::string& pointsFile,
                const laws::LawRegistry& laws) {
  return makeStudy(input::InputTree::fromFile(path), nullptr, path, overrides, pointsFile, laws);
}

Study makeStudy(input::InputTree input, const input::InputTree* scene, const std::string& path,
                const std::vector<std::string>& overrides, const std::string& pointsFile,
                const laws::LawRegistry& laws) {
  Names ofStudy, ofScene;
  for (const std::string& change : overrides) {
    const std::string prefix = scenePrefix;
    if (change.compare(0, prefix.size(), prefix) == 0) {
      ofScene.push_back(change.substr(prefix.size()));
    } else {
      ofStudy.push_back(change);
    }
  }
  demandPrefix(ofStudy, laws);
  Study study;
  study.path = path;
  if (input.root.name() == scene::sceneSpec(laws).name()) {
    throw base::Error(path + " is a scene.\n  Write: harmos run " + path, base::ExitCode::input);
  }
  study.input = input::check(std::move(input), studySpec(), ofStudy);
  StudyReader(study, pointsFile, laws).read(ofScene, scene);
  return study;
}

}  // namespace harmos::study
