#include <harmos/scene/Scene.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <unordered_map>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/elasticity/Materials.hpp>
#include <harmos/files/HistoryFile.hpp>
#include <harmos/input/Check.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/input/Field.hpp>
#include <harmos/laws/FaceLaw.hpp>
#include <harmos/laws/FieldFollower.hpp>
#include <harmos/scene/FaceNames.hpp>
#include <harmos/scene/MeshSource.hpp>
#include <harmos/scene/Plugins.hpp>
#include <harmos/scene/SceneSpec.hpp>
#include <harmos/scene/detail/Dimensions.hpp>
#include <harmos/scene/detail/History.hpp>
#include <harmos/scene/detail/KnownNames.hpp>
#include <harmos/scene/detail/LawEntry.hpp>
#include <harmos/scene/detail/LawOutputs.hpp>
#include <harmos/scene/detail/Names.hpp>
#include <harmos/scene/detail/PartPairs.hpp>
#include <harmos/scene/detail/PathFollowing.hpp>
#include <harmos/scene/detail/Place.hpp>
#include <harmos/scene/detail/ResponseRegistry.hpp>
#include <harmos/scene/detail/Units.hpp>
#include <harmos/scene/detail/UnusedEntries.hpp>
#include <harmos/scene/detail/VolumeLoad.hpp>
#include <harmos/substructure/MultigridLibrary.hpp>
#include <harmos/substructure/SolverOptions.hpp>

namespace harmos::scene {

namespace {

using input::Parameters;
using Names = std::vector<std::string>;

std::vector<double> stepTimes(const std::vector<Parameters>& steps, input::ErrorList& errors) {
  std::vector<double> times;
  double begin = 0.0;
  for (const Parameters& step : steps) {
    const int increments = step.integer("Increments");
    const double duration = step.number("Duration");
    double last = begin;
    bool isIncreasing = true;
    for (int i = 1; i <= increments; ++i) {
      times.push_back(begin + duration * (static_cast<double>(i) / increments));
      isIncreasing = isIncreasing && times.back() > last && std::isfinite(times.back());
      last = times.back();
    }
    if (!isIncreasing) {
      errors.add(step.where("Duration"),
                 "the time steps (" + std::to_string(increments) + " in " + base::toText(duration) +
                     " after the time " + base::toText(begin) + ") cannot be told apart.",
                 "Give durations of a like size; only rates depend on them.");
    }
    begin += duration;
  }
  return times;
}

class SceneChecker {
 public:
  SceneChecker(const laws::LawRegistry& laws, Scene& scene, input::ErrorList& errors)
      : laws_(laws),
        scene_(scene),
        input_(scene.input),
        errors_(errors),
        parts_(input_.lists("Parts")),
        materials_(input_.lists("Materials")),
        fields_(input_.lists("Fields")),
        joints_(input_.lists("Interfaces")),
        interfaces_(joints_),
        responses_(input_.lists("Responses")) {
    interfaces_.add(input_.lists("Boundaries"));
  }

  void check() {
    scene_.cutLaw = laws_.create(Parameters("cut").set("Type", std::string("Perfect")));
    attachHistories();
    const elasticity::MaterialRegistry materials = elasticity::builtInMaterials();
    for (const Parameters& list : input_.lists("Materials")) {
      errors_.collect(list.where(), [&] { scene_.materials[list.name()] = materials.create(list); });
    }
    for (const Parameters& part : input_.lists("Parts")) {
      knownName(part, "Material", materials_, "Materials");
      checkBodyForce(part);
      if (part.has("Linear Solver") && part.text("Linear Solver") == "Iterative")
        errors_.collect(part.where("Linear Solver"), [] { substructure::multigridLibrary(); });
    }
    checkPartsOf("Loads", "Density", [](const elasticity::Material& m) { return m.density().has_value(); });
    checkPartsOf("Temperatures", "Thermal Expansion",
                 [](const elasticity::Material& m) { return m.thermalExpansion().has_value(); });
    checkOneTemperature();
    for (const Parameters& field : input_.lists("Fields")) {
      if (field.type() == "Mesh Variable") knownName(field, "Part", parts_, "Parts");
    }
    for (const Parameters& interface : input_.lists("Interfaces")) checkInterface(interface);
    for (const Parameters& boundary : input_.lists("Boundaries")) checkBoundary(boundary);
    for (const Parameters& response : input_.lists("Responses")) checkResponse(response);
    checkPathFollowing(input_, latin::LatinOptions(input_.list("Solver")), errors_);
    const Parameters& solver = input_.list("Solver").list("Linear Solver");
    errors_.collect(solver.where("Name"), [&] { substructure::requireSolver(solver.text("Name")); });
    checkDimensions(input_, dimension(), errors_);
  }

 private:
  /// As far as it is known without reading a mesh.
  std::optional<int> dimension() {
    const Parameters& model = input_.list("Model");
    const std::optional<int> ofMesh = meshDimension(input_.list("Mesh"), errors_);
    if (ofMesh || !model.has("Kinematics")) return ofMesh;
    return elasticity::dimensionOf(elasticity::kinematicsNamed(model.text("Kinematics")));
  }

  void attachHistories() {
    auto histories = std::make_shared<input::Histories>(scene_.times);
    for (const Parameters& history : input_.lists("Histories")) {
      histories->add(history.name(), historyFactors(history, scene_.times, errors_));
    }
    scene_.input.attach(histories);
  }

  /// The text `entry`, if given, is one of `known`, the names of the scene's list `list`.
  bool knownName(const Parameters& parameters, const std::string& entry, const KnownNames& known,
                 const std::string& list) {
    if (!parameters.has(entry)) return true;
    return knownName(parameters.where(entry), parameters.text(entry), known, list);
  }

  bool knownName(const std::string& where, const std::string& name, const KnownNames& known, const std::string& list) {
    if (known.has(name)) return true;
    errors_.add(where, "\"" + name + "\" is not in the list " + list + ".",
                base::suggestName(name, known.inOrder(), list + " has"));
    return false;
  }

  /// The parts that a list of Loads or Temperatures concerns, those that are there.
  Names partsOf(const Parameters& list) const {
    if (!list.has("Parts")) return parts_.inOrder();
    Names names = list.texts("Parts");
    names.erase(std::remove_if(names.begin(), names.end(), [&](const auto& name) { return !parts_.has(name); }),
                names.end());
    return names;
  }

  /// The parts that lists of this kind name are there, and their materials have the constant that they need.
  void checkPartsOf(const std::string& kind, const std::string& constant,
                    const std::function<bool(const elasticity::Material&)>& has) {
    for (const Parameters& list : input_.lists(kind)) {
      if (list.has("Parts")) {
        for (const std::string& name : list.texts("Parts")) knownName(list.where("Parts"), name, parts_, "Parts");
      }
      std::set<std::string> lacking;
      for (const std::string& part : partsOf(list)) {
        const auto material = scene_.materials.find(parts_.find(part)->text("Material"));
        if (material != scene_.materials.end() && !has(*material->second)) lacking.insert(material->first);
      }
      if (lacking.empty()) continue;
      errors_.add(list.where(),
                  "the materials of its parts have no " + constant + ": " +
                      base::joinNames({lacking.begin(), lacking.end()}) + ".",
                  "Add \"" + constant + "\" to them, or name the parts that have it in \"Parts\".");
    }
  }

  void checkBodyForce(const Parameters& part) {
    if (!part.hasList("Body Force")) return;
    const Parameters& force = part.list("Body Force");
    for (const char* component : {"X", "Y", "Z"}) {
      errors_.collect(force.where(component), [&] { const input::Field readable(force, component); });
      checkFieldInside(force, std::string(component) + " Field");
    }
  }

  void checkFieldInside(const Parameters& force, const std::string& entry) {
    if (!knownName(force, entry, fields_, "Fields") || !force.has(entry)) return;
    const Parameters& field = *fields_.find(force.text(entry));
    if (field.type() != "Random") return;
    errors_.add(force.where(entry), base::quoted(field.name()) + " is random, and known on interfaces only.",
                "Take a field of Type = Mesh Variable.");
  }

  void checkOneTemperature() {
    std::unordered_map<std::string, const Parameters*> firsts;
    for (const Parameters& list : input_.lists("Temperatures")) {
      for (const std::string& part : partsOf(list)) {
        const Parameters* first = firsts.emplace(part, &list).first->second;
        if (first == &list) continue;
        errors_.add(list.where(), "the part \"" + part + "\" has a temperature already, at " + first->location() + ".",
                    "Name the parts of each in \"Parts\".");
      }
    }
  }

  void checkInterface(const Parameters& interface) {
    const bool hasSides = interface.has("Side 1") && interface.has("Side 2");
    const bool hasParts = interface.has("Part 1") && interface.has("Part 2");
    const bool hasAnySide = interface.has("Side 1") || interface.has("Side 2");
    const bool hasAnyPart = interface.has("Part 1") || interface.has("Part 2");
    if (interface.has("Part") && !hasAnySide && !hasAnyPart) {
      checkSection(interface);
    } else if (interface.has("Part") || (hasAnySide && hasAnyPart) || !(hasSides || hasParts)) {
      errors_.add(interface.where(), "it is not clear what is joined.",
                  "Give either \"Side 1\" and \"Side 2\" (names of side sets), or \"Part 1\" and \"Part 2\", or "
                  "\"Part\" with \"Point\" and \"Normal\".");
    }
    for (const char* entry : {"Point", "Normal"}) {
      if (interface.has(entry) && !interface.has("Part")) {
        errors_.add(interface.where(entry), "it belongs to a plane through one part.", "Remove it, or give \"Part\".");
      }
    }
    for (const char* entry : {"Part 1", "Part 2"}) {
      const bool isFitting = interface.has(entry) && isPattern(interface.text(entry)) &&
                             !fittingNames(interface.text(entry), parts_.inOrder()).empty();
      if (!isFitting) knownName(interface, entry, parts_, "Parts");
    }
    for (const std::string kind : {"Side", "Part"}) {
      const std::string first = kind + " 1", second = kind + " 2";
      if (interface.has(first) && interface.has(second) && interface.text(first) == interface.text(second) &&
          !(kind == "Part" && isPattern(interface.text(first)))) {
        errors_.add(interface.where(second), "both sides are \"" + interface.text(second) + "\".",
                    "An interface joins two different parts; a condition on one part belongs in Boundaries.");
      }
    }
    if (interface.has("Projection Direction") && hasParts) {
      errors_.add(interface.where("Projection Direction"), "a projection needs side sets.",
                  "Give \"Side 1\" and \"Side 2\" instead of parts, or remove the direction.");
    }
    checkJoining(interface);
    makeLaw(interface, 2);
  }

  /// An interface on a plane through one part.
  void checkSection(const Parameters& interface) {
    knownName(interface, "Part", parts_, "Parts");
    for (const char* entry : {"Point", "Normal"}) {
      if (interface.has(entry)) continue;
      errors_.add(interface.where(), std::string("the plane through the part has no \"") + entry + "\".", "Give it.");
    }
    for (const char* entry : {"Projection Direction", "Closed Within", "Search Distance"}) {
      if (!interface.has(entry)) continue;
      errors_.add(interface.where(entry), "the sides of a plane through one part share their nodes.", "Remove it.");
    }
    const auto [first, isNew] = divided_.emplace(interface.text("Part"), interface.location());
    if (isNew) return;
    errors_.add(interface.where("Part"), "the part is divided already, at " + first->second + ".",
                "Let one plane cut it, or divide the part into several.");
  }

  void checkJoining(const Parameters& interface) {
    const auto isGiven = [&](const std::string& entry) {
      if (entry == "Points On") return interface.text(entry) != "Automatic";
      return entry == "Gap" ? interface.text(entry) != "Geometric" : interface.has(entry);
    };
    for (const std::string entry : {"Points On", "Gap", "Closed Within", "Search Distance"}) {
      if (!interface.has("Projection Direction") || !isGiven(entry)) continue;
      errors_.add(interface.where(entry), "it is for meshes that need not match, a projection for those that do.",
                  "Remove one of them.");
    }
    if (interface.has("Closed Within") && interface.text("Gap") != "Closed") {
      errors_.add(interface.where("Closed Within"), "gaps are not closed.", "Give Gap = Closed, or remove it.");
    }
  }

  void checkBoundary(const Parameters& boundary) {
    checkPlace(boundary, "boundary", "Side Set", errors_);
    knownName(boundary, "Part", parts_, "Parts");
    if (const Parameters* same = joints_.find(boundary.name())) {
      errors_.add(boundary.where(), "an interface has the same name, at " + same->location() + ".",
                  "Rename one of them: results are addressed by these names.");
    }
    makeLaw(boundary, 1);
  }

  void makeLaw(const Parameters& interface, int sides) {
    const Parameters& parameters = interface.list("Law");
    std::shared_ptr<const laws::InterfaceLaw> law;
    const int before = errors_.count();
    laws_.check(parameters, errors_);
    if (errors_.count() > before) return;
    for (const laws::FieldName& field : laws::fieldNames(parameters)) {
      knownName(parameters.where(field.entry), field.name, fields_, "Fields");
    }
    errors_.collect(parameters.where(), [&] {
      auto made = laws_.create(parameters);
      if (auto* field = dynamic_cast<laws::FieldFollower*>(made.get())) field->tell(input_.lists("Fields"));
      law = std::move(made);
    });
    if (!law) return;
    errors_.collect(parameters.where("Type"), [&] { outputs_.add(*law); });
    if (sides == 1 && law->sides() == laws::Sides::two) {
      errors_.add(parameters.where("Type"), "\"" + parameters.type() + "\" joins two parts, but a boundary has one.",
                  "Choose another law, or describe an interface in the list Interfaces.");
    } else if (sides == 2 && law->sides() == laws::Sides::one) {
      errors_.add(parameters.where("Type"),
                  "\"" + parameters.type() + "\" acts on one part, but an interface joins two.",
                  "Choose another law, or describe a boundary in the list Boundaries.");
    }
    scene_.laws[interface.name()] = law;
    const auto* ofFace = dynamic_cast<const laws::FaceLaw*>(law.get());
    const auto other = ofFace == nullptr ? nullptr : ofFace->onOtherFace();
    if (!other) return;
    scene_.laws[nameOfOtherFace(interface.name())] = other;
    if (interface.has("Side 1")) return;
    errors_.add(interface.where(), base::quoted(parameters.type()) + " acts between two faces, which may be apart.",
                "Give \"Side 1\" and \"Side 2\", names of side sets.");
  }

  void checkResponse(const Parameters& response) {
    checkName(response, "response", errors_);
    if (files::headsAnotherColumn(response.name(), [&](const std::string& name) { return responses_.has(name); })) {
      errors_.add(response.where(), "this name heads another column of the history.", "Take another one.");
    }
    knownName(response, "Interface", interfaces_, "Interfaces or Boundaries");
    knownName(response, "Part", parts_, "Parts");
    if (response.has("Interfaces")) {
      for (const std::string& name : response.texts("Interfaces")) {
        knownName(response.where("Interfaces"), name, interfaces_, "Interfaces or Boundaries");
      }
    }
    builtInResponses().check(response, errors_);
  }

  const laws::LawRegistry& laws_;
  Scene& scene_;
  const Parameters& input_;
  input::ErrorList& errors_;
  KnownNames parts_, materials_, fields_, joints_;
  KnownNames interfaces_;  // and boundaries
  KnownNames responses_;
  std::unordered_map<std::string, std::string> divided_;  // by the part: where a plane through it is given
  LawOutputs outputs_;
};

void readDerivatives(const input::InputTree& input, Scene& scene, input::ErrorList& errors) {
  const Parameters& output = scene.input.list("Output");
  if (!output.has("Derivatives")) return;
  const std::string where = output.where("Derivatives");
  scene.output.derivatives = output.texts("Derivatives");
  for (const std::string& entry : scene.output.derivatives) {
    errors.collect(where, [&] { lawEntry(input, scene.input, entry); });
  }
  if (latin::LatinOptions(scene.input.list("Solver")).stages.formulation == latin::Formulation::velocity) {
    errors.add(where, "there are none with the velocity form.", "Take Formulation = Displacement in the list Solver.");
  }
}

}  // namespace

Scene makeScene(const input::InputTree& input, const std::string& path, const std::vector<std::string>& overrides,
                const laws::LawRegistry& laws) {
  const laws::LawRegistry known = lawsOf(input, path, overrides, laws);
  Scene scene;
  scene.path = path;
  scene.input = input::check(input, sceneSpec(known), overrides);
  input::ErrorList errors;
  scene.times = stepTimes(scene.input.lists("Steps"), errors);
  SceneChecker(known, scene, errors).check();
  readDerivatives(input, scene, errors);
  errors.throwIfAny();
  scene.warnings = unusedEntries(input, overrides, scene.input, scene.times);
  for (std::string& sentence : implausibleNumbers(scene.input)) scene.warnings.push_back(std::move(sentence));
  const Parameters& solver = scene.input.list("Solver");
  scene.solver = latin::LatinOptions(solver);
  scene.wantsMeshErrors = solver.flag("Mesh Error") && !scene.input.hasList("Path Following");
  const Parameters& output = scene.input.list("Output");
  scene.output.fields = output.flag("Fields");
  scene.output.nodalStress = scene.output.fields && output.flag("Nodal Stress");
  if (!scene.output.derivatives.empty() && scene.solver.stages.elimination == latin::Elimination::affine) {
    scene.solver.stages.elimination = latin::Elimination::rigid;  // springs of the ground may be parameters
  }
  scene.hasConsistentMass = solver.text("Interface Mass") == "Consistent";
  return scene;
}

Scene readScene(const std::string& path, const std::vector<std::string>& overrides, const laws::LawRegistry& laws) {
  return makeScene(input::InputTree::fromFile(path), path, overrides, laws);
}

std::vector<std::string> inputFiles(const Scene& scene) {
  std::vector<std::string> files{scene.path};
  if (const auto mesh = meshFile(scene.input.list("Mesh"), scene.path)) files.push_back(*mesh);
  for (const std::string& plugin : pluginFiles(scene.input, scene.path)) files.push_back(plugin);
  return files;
}

}  // namespace harmos::scene
