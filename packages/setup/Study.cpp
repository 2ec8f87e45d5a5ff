#include <harmos/setup/Study.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>

#include <harmos/base/Check.hpp>
#include <harmos/base/Error.hpp>
#include <harmos/base/ErrorList.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/base/Override.hpp>
#include <harmos/setup/PointsFile.hpp>
#include <harmos/setup/SceneSpec.hpp>
#include <harmos/setup/StudyDesign.hpp>
#include <harmos/setup/StudySpec.hpp>
#include <harmos/study/ListDesign.hpp>
#include <harmos/study/Plan.hpp>

namespace harmos::setup {

namespace {

namespace fs = std::filesystem;
using base::Parameters;
using Names = std::vector<std::string>;

constexpr const char* scenePrefix = "Scene/";

std::string besides(const std::string& file, const std::string& path) {
  return (fs::path(file).parent_path() / path).lexically_normal().string();
}

/// Applies "List/Name=value" to the scene on behalf of `where`.
void applyToScene(const std::string& assignment, const std::string& where, const base::ParameterSpec& spec,
                  base::InputTree& scene, base::ErrorList& errors) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos) {
    errors.add(where, "\"" + assignment + "\" has no value.", "Write List/Sublist/Name=value.");
    return;
  }
  base::applyChange(scene, spec, {assignment.substr(0, equals), assignment.substr(equals + 1), where}, where, errors);
}

bool has(const base::ParameterSpec& spec, const std::string& name) {
  const auto& entries = spec.entries();
  const auto& lists = spec.sublists();
  return std::any_of(entries.begin(), entries.end(), [&](const auto& entry) { return entry->name == name; }) ||
         std::any_of(lists.begin(), lists.end(), [&](const auto& list) { return list.name == name; });
}

/// Refuses changes of the scene that are written as if they were changes of the study.
void demandPrefix(const Names& changes, const laws::LawRegistry& laws) {
  base::ErrorList errors;
  for (const std::string& change : changes) {
    const std::string first = change.substr(0, change.find_first_of("/="));
    if (has(studySpec(), first) || !has(sceneSpec(laws), first)) continue;
    errors.add("--set '" + change + "'", "the study has no \"" + first + "\", but its scene has.",
               "Write --set '" + (scenePrefix + change) + "'.");
  }
  errors.throwIfAny();
}

class StudyReader {
 public:
  StudyReader(Study& study, const std::string& pointsFile, const laws::LawRegistry& laws)
      : study_(study), input_(study.input), spec_(sceneSpec(laws)), pointsFile_(pointsFile), laws_(laws) {
    study_.pointsFile = pointsFile;
  }

  void read(const Names& sceneChanges) {
    const std::string path = besides(study_.path, input_.text("Scene"));
    const bool isRead = errors_.collect(input_.where("Scene"), [&] {
      study_.sceneTree = base::InputTree::fromFile(path);
      changeScene(sceneChanges);
    });
    if (isRead) readScene(path);
    for (const Parameters& parameter : input_.lists("Parameters")) readParameter(parameter);
    demandUse(readFormulas());
    if (isSceneRead_) {
      for (const Parameters& response : input_.lists("Responses")) readResponse(response);
    }
    checkRecovery();
    if (study_.isAdaptive()) checkAdaptive();
    makeConfigurations();
    finish();
  }

 private:
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
      study_.scene = makeScene(study_.sceneTree, path, {}, laws_);
      isSceneRead_ = true;
    } catch (const base::Error& error) {
      if (error.code() != base::ExitCode::input) throw;
      sceneErrors_ = error.what();
    }
  }

  void readParameter(const Parameters& list) {
    StudyParameter parameter;
    parameter.name = list.name();
    parameter.unit = list.text("Unit");
    parameter.where = list.where();
    checkName(list);
    if (list.has("Entry") && list.has("Entries")) {
      errors_.add(list.where("Entries"), "\"Entry\" is given too.", "Give one of them.");
    }
    if (list.has("Entry")) parameter.entries = {list.text("Entry")};
    if (list.has("Entries")) parameter.entries = list.texts("Entries");
    if (isSceneRead_) readEntries(list, parameter);

    study::PlannedParameter planned;
    planned.axis.name = list.name();
    if (list.has("Formula")) parameter.formula = planned.formula = list.text("Formula");
    readLevels(list, planned.axis);
    planned_.push_back(std::move(planned));
    study_.parameters.push_back(std::move(parameter));
  }

  /// Names head the columns of tables, and those of parameters stand in formulas.
  void checkName(const Parameters& list) {
    const Names taken = {"id", "status", "iterations", "error_estimate", "start"};
    if (std::find(taken.begin(), taken.end(), list.name()) != taken.end()) {
      errors_.add(list.where(), "this name heads another column of the results.", "Take another one.");
    } else if (!study::isFormulaName(list.name())) {
      errors_.add(list.where(), "this name can stand neither in formulas nor in tables.",
                  "Take letters, digits and underscores, no digit first, and no name of a function.");
    }
  }

  void readEntries(const Parameters& list, StudyParameter& parameter) {
    const std::string where = list.where(list.has("Entry") ? "Entry" : "Entries");
    for (const std::string& entry : parameter.entries) {
      for (const StudyParameter& other : study_.parameters) {
        if (std::find(other.entries.begin(), other.entries.end(), entry) == other.entries.end()) continue;
        errors_.add(where, "\"" + entry + "\" is set by \"" + other.name + "\" already.");
      }
      base::InputTree trial = study_.sceneTree;
      const int before = errors_.count();
      const auto type = base::applyChange(trial, spec_, {entry, "0", where}, where, errors_);
      if (errors_.count() > before) continue;
      if (type != base::ParameterType::number && type != base::ParameterType::integer) {
        errors_.add(where, "\"" + entry + "\" is not a number.", "A study varies numbers.");
        continue;
      }
      if (entry.compare(0, 6, "Steps/") == 0) {
        errors_.add(where, "the load steps are the same for the whole study.",
                    "Vary a history, or make two studies of them.");
        continue;
      }
      const auto effects = effectsOf(entry, study_.sceneTree);
      if (effects.empty()) {
        errors_.add(where, "nothing in the scene uses \"" + entry + "\".",
                    "Write \"$" + entry.substr(entry.find('/') + 1) + "\" as the value of a number of the scene.");
      }
      for (const std::string& effect : effects) {
        parameter.effects.push_back(effect);
        parameter.phase = std::max(parameter.phase, phaseOf(effect, study_.scene));
      }
    }
  }

  void readLevels(const Parameters& list, study::Axis& axis) {
    Names given;
    const auto allOf = [&](const Names& entries) {
      const auto count = std::count_if(entries.begin(), entries.end(), [&](const auto& e) { return list.has(e); });
      if (count == 0) return false;
      given.push_back(base::joinNames(entries));
      if (count == static_cast<std::ptrdiff_t>(entries.size())) return true;
      errors_.add(list.where(), base::joinNames(entries) + " belong together, but not all of them are given.");
      return false;
    };
    if (allOf({"Values"})) axis.levels = list.numbers("Values");
    if (allOf({"From", "To", "Count"})) {
      axis.levels = study::evenLevels(list.number("From"), list.number("To"), list.integer("Count"));
    }
    if (allOf({"Lower", "Upper"})) {
      axis.lower = list.number("Lower");
      axis.upper = list.number("Upper");
      if (axis.upper < axis.lower) errors_.add(list.where("Upper"), "Upper is less than Lower.");
    }
    if (allOf({"Formula"}) && given.size() > 1) {
      errors_.add(list.where("Formula"), "a derived parameter takes no values of its own.",
                  "Remove " + given.front() + ", or the formula.");
    } else if (given.size() > 1) {
      errors_.add(list.where(), "its values are given twice: " + given[0] + " and " + given[1] + ".",
                  "Give one of them.");
    }
    if (given.empty() && !isListed()) {
      errors_.add(list.where(), "it has no values.", "Give Values; or From, To, Count; or Lower, Upper; or a Formula.");
    }
    if (list.has("Values") && axis.levels.empty()) errors_.add(list.where("Values"), "there is no value.");
  }

  bool isListed() const {
    return !pointsFile_.empty() || (input_.hasList("Design") && input_.list("Design").type() == "List");
  }

  /// Null when it cannot be made, which is then reported.
  std::unique_ptr<study::Design> readDesign() {
    if (!isListed()) return makeDesign(input_);
    study_.pointsFile = pointsFile_.empty() ? besides(study_.path, input_.list("Design").text("File")) : pointsFile_;
    Names names;
    for (const study::PlannedParameter& parameter : planned_) {
      if (parameter.formula.empty()) names.push_back(parameter.axis.name);
    }
    try {
      return std::make_unique<study::ListDesign>(readPoints(study_.pointsFile, names));
    } catch (const base::Error& error) {
      pointsErrors_ = error.what();
      return nullptr;
    }
  }

  /// Every formula by itself, so that all errors come at once. Returns the names of the parameters that they use.
  Names readFormulas() {
    Names names, used;
    for (const study::PlannedParameter& parameter : planned_) {
      if (study::isFormulaName(parameter.axis.name)) names.push_back(parameter.axis.name);
    }
    for (const char* kind : {"Parameters", "Conditions"}) {
      for (const Parameters& list : input_.lists(kind)) {
        if (!list.has("Formula")) continue;
        errors_.collect(list.where("Formula"), [&] {
          const auto variables = study::Formula(list.text("Formula"), names).variables();
          used.insert(used.end(), variables.begin(), variables.end());
        });
        if (std::string(kind) == "Conditions") conditions_.push_back({list.name(), list.text("Formula")});
      }
    }
    return used;
  }

  void makeConfigurations() {
    const std::unique_ptr<study::Design> design = readDesign();
    if (!design || errors_.count() > 0) return;
    errors_.collect(input_.hasList("Design") ? input_.list("Design").where() : input_.where(), [&] {
      study_.plan = std::make_shared<study::Plan>(planned_, conditions_);
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
    checkName(list);
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
    using Kind = study::ScalarResponse::Kind;
    study::ScalarResponse response;
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
    const Parameters& design = input_.list("Design");
    Names known;
    for (const Parameters& response : input_.lists("Responses")) known.push_back(response.name());
    if (std::find(known.begin(), known.end(), design.text("Response")) == known.end()) {
      errors_.add(design.where("Response"), "the study has no response \"" + design.text("Response") + "\".",
                  base::suggestName(design.text("Response"), known, "It has"));
    }
    for (std::size_t p = 0; p < planned_.size(); ++p) {
      const study::Axis& axis = planned_[p].axis;
      if (study_.parameters[p].phase == StudyPhase::operators) {
        errors_.add(study_.parameters[p].where,
                    "an adaptive design varies laws and loads only, but this changes bodies.", "Take another design.");
      }
      const bool isConstant = axis.levels.empty() ? axis.lower == axis.upper : axis.levels.size() == 1;
      if (planned_[p].formula.empty() && isConstant) {
        errors_.add(study_.parameters[p].where, "an adaptive design needs two different values at least.");
      }
    }
  }

  void checkRecovery() {
    if (!input_.hasList("Failure Policy") || input_.list("Failure Policy").type() != "Recover") return;
    const Parameters& policy = input_.list("Failure Policy");
    const std::size_t given = policy.numbers("Values").size();
    const std::size_t wanted = input_.lists("Responses").size();
    if (given == wanted) return;
    errors_.add(policy.where("Values"), std::to_string(given) + " values are given, but the study has " +
                                            std::to_string(wanted) + " responses.");
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
  base::ParameterSpec spec_;
  std::string pointsFile_;
  const laws::LawRegistry& laws_;
  base::ErrorList errors_;
  bool isSceneRead_ = false;
  std::string sceneErrors_, pointsErrors_;  // lists of their own, about other files
  std::vector<study::PlannedParameter> planned_;
  std::vector<study::Condition> conditions_;
};

}  // namespace

bool Study::isAdaptive() const {
  return pointsFile.empty() && input.hasList("Design") && input.list("Design").type() == "Adaptive";
}

bool isStudyFile(const std::string& path) {
  return base::InputTree::fromFile(path).root.name() == studySpec().name();
}

Scene Study::sceneFor(const std::vector<double>& values, const laws::LawRegistry& laws) const {
  const base::ParameterSpec spec = sceneSpec(laws);
  base::InputTree tree = sceneTree;
  base::ErrorList errors;
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    for (const std::string& entry : parameters[p].entries) {
      const std::string location = parameters[p].name;
      base::applyChange(tree, spec, {entry, base::toText(values[p]), location}, location, errors);
    }
  }
  try {
    errors.throwIfAny();
    return makeScene(std::move(tree), scene.path, {}, laws);
  } catch (const base::Error& error) {
    // Elsewhere things are run: the closing line about the number of errors is not for a table.
    const std::string text = error.what();
    throw base::Error(text.substr(0, text.rfind('\n')), error.code());
  }
}

Study readStudy(const std::string& path, const std::vector<std::string>& overrides, const std::string& pointsFile,
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
  study.input = base::check(base::InputTree::fromFile(path), studySpec(), ofStudy);
  StudyReader(study, pointsFile, laws).read(ofScene);
  return study;
}

}  // namespace harmos::setup
