#include <harmos/scene/detail/PathFollowing.hpp>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <harmos/assembly/PathCheck.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/latin/LoadFactorResponse.hpp>
#include <harmos/scene/detail/ResponseRegistry.hpp>

namespace harmos::scene {
namespace {

using input::Parameters;
using Names = std::vector<std::string>;

constexpr const char* loadFactorName = "load_factor";

Names namesOf(const std::vector<Parameters>& lists) {
  Names names;
  for (const Parameters& list : lists) names.push_back(list.name());
  return names;
}

/// The pairs of an interface that lie nearest to a point: those of one place.
void keepNearest(const base::Vector3& point, const assembly::Assembly& assembly,
                 std::vector<assembly::PathControl::Share>& shares) {
  double least = std::numeric_limits<double>::infinity();
  base::Vector3 place{};
  for (const auto& share : shares) {
    for (const base::Vector3& x : assembly.interfaces[share.interface].position) {
      if (!(base::distance(x, point) < least)) continue;
      least = base::distance(x, point);
      place = x;
    }
  }
  for (auto& share : shares) {
    const assembly::Interface& interface = assembly.interfaces[share.interface];
    for (int p = 0; p < interface.pairs(); ++p) {
      if (interface.position[p] != place) share.weight[p] = {};
    }
  }
}

}  // namespace

void describePathFollowing(input::ParameterSpec& spec) {
  spec.summary(
      "Loads whose size is found so that a joint opens as it is told to: follows force and displacement back where a "
      "joint snaps. What the loads prescribe is multiplied by one load factor per time step, which is reported as "
      "load_factor.");
  spec.texts("Loads").example("{pull}").required().doc(
      "Boundaries that prescribe tractions, pressures, forces or displacements, without a history; all others stay "
      "what "
      "they are.");
  spec.text("Interface").example("glue").required().doc("Whose jump is controlled.");
  spec.number("Opening").example("0.1").unit("length").required().varying().doc(
      "What the jump of the sides since the unloaded state is at every time step; give it a history that grows as "
      "the crack does.");
  spec.numbers("Direction")
      .optional()
      .doc(
          "Along which the jump is taken, of side 2 less side 1, of any length; absent: the normal of the interface, "
          "so that "
          "it opens.");
  spec.numbers("Point").unit("length").optional().doc(
      "The jump is that of the point of the interface nearest to it; absent: its mean over the interface.");
}

void checkPathFollowing(const Parameters& scene, const latin::LatinOptions& solver, input::ErrorList& errors) {
  if (!scene.hasList("Path Following")) return;
  const Parameters& path = scene.list("Path Following");
  const Names boundaries = namesOf(scene.lists("Boundaries")), interfaces = namesOf(scene.lists("Interfaces"));
  std::set<std::string> named;
  for (const std::string& name : path.texts("Loads")) {
    if (std::find(boundaries.begin(), boundaries.end(), name) == boundaries.end()) {
      errors.add(path.where("Loads"), base::quoted(name) + " is not in the list Boundaries.",
                 base::suggestName(name, boundaries, "Boundaries has"));
    } else if (!named.insert(name).second) {
      errors.add(path.where("Loads"), base::quoted(name) + " is named twice.", "Name it once.");
    }
  }
  if (path.texts("Loads").empty()) {
    errors.add(path.where("Loads"), "there are no loads whose size could be found.", "Name boundaries.");
  }
  const std::string& interface = path.text("Interface");
  if (std::find(interfaces.begin(), interfaces.end(), interface) == interfaces.end()) {
    errors.add(path.where("Interface"), base::quoted(interface) + " is not in the list Interfaces.",
               base::suggestName(interface, interfaces, "Interfaces has"));
  }
  errors.collect(path.where("Opening"), [&] {
    const input::Schedule opening = path.schedule("Opening");
    const std::vector<double> times = path.times();
    for (std::size_t t = 0; t < times.size(); ++t) {
      if (opening[static_cast<int>(t)] != 0.0) return;
    }
    errors.add(path.where("Opening"), "it is 0 at all time steps.", "Give the jump that is to be reached.");
  });
  if (solver.stages.formulation != latin::Formulation::displacement ||
      solver.algorithm != latin::Algorithm::accelerated) {
    errors.add(path.where(), "it needs the displacement form and the default algorithm.",
               "Remove \"Formulation\" and \"Algorithm\" in the list Solver.");
  }
  if (scene.list("Solver").text("Interface Mass") == "Consistent") {
    errors.add(path.where(), "it needs a lumped interface mass.", "Remove \"Interface Mass\" in the list Solver.");
  }
  if (scene.list("Output").has("Derivatives")) {
    errors.add(scene.list("Output").where("Derivatives"), "there are none with Path Following.", "Remove one of them.");
  }
  for (const Parameters& response : scene.lists("Responses")) {
    if (response.name() == loadFactorName) {
      errors.add(response.where(), "the load factor of Path Following has this name.", "Rename the response.");
    }
  }
}

void addPath(const Parameters& scene, assembly::Assembly& assembly,
             std::vector<std::shared_ptr<const latin::Response>>& responses, input::ErrorList& errors) {
  if (!scene.hasList("Path Following")) return;
  const Parameters& list = scene.list("Path Following");
  assembly::PathControl path;
  const Names& loads = list.texts("Loads");
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (std::find(loads.begin(), loads.end(), interface.name) == loads.end()) continue;
    const int index = static_cast<int>(i);
    path.loads.push_back(index);
    const std::string fault = assembly::faultOfLoad(assembly, index);
    if (fault.empty()) continue;
    errors.add(list.where("Loads"), base::quoted(interface.name) + ": " + fault + ".",
               "Name boundaries that prescribe tractions or displacements, other than 0, without histories.");
  }
  double area = 0.0;
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (interface.name != list.text("Interface") || interface.sides() != 2) continue;
    path.shares.push_back({static_cast<int>(i), {}});
    for (int p = 0; p < interface.pairs(); ++p) {
      path.shares.back().weight.push_back(list.has("Direction") ? directionOf(list, "Direction")
                                                                : interface.frame[p][0]);
    }
  }
  if (list.has("Point")) keepNearest(vectorOf(list, "Point"), assembly, path.shares);
  for (const auto& share : path.shares) {
    const assembly::Interface& interface = assembly.interfaces[share.interface];
    for (int p = 0; p < interface.pairs(); ++p) {
      if (base::norm(share.weight[p]) > 0.0) area += interface.area[p];
    }
  }
  for (auto& share : path.shares) {
    for (base::Vector3& weight : share.weight) weight = (1.0 / area) * weight;
  }
  const input::Schedule opening = list.schedule("Opening");
  for (int t = 0; t < assembly.steps(); ++t) path.values.push_back(opening[t]);
  assembly.path = std::move(path);
  responses.push_back(std::make_shared<latin::LoadFactorResponse>(loadFactorName));
}

}  // namespace harmos::scene
