#include <harmos/scene/TurnedPlaces.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/laws/FieldLaw.hpp>

namespace harmos::scene {

std::vector<base::Vector3> placesOfNodes(const mesh::TraceOperator& trace, const std::vector<base::Vector3>& nodes) {
  std::vector<base::Vector3> places;
  for (int p = 0; p < trace.points(); ++p) {
    for (const auto& entry : trace.row(p)) places.push_back(nodes[entry.node]);
  }
  return places;
}

void measureGaps(const laws::TurnedLaw& law, const std::vector<base::Vector3>& nodes, mesh::InterfaceSurface& surface) {
  if (surface.trace1.isSelection()) return;
  for (int p = 0; p < surface.pairs(); ++p) {
    std::vector<base::Vector3> places;
    std::vector<double> weights;
    for (const auto& entry : surface.trace1.row(p)) {
      places.push_back(nodes[entry.node]);
      weights.push_back(entry.weight);
    }
    surface.gap[p] = law.distanceBeyondMean(places, weights, surface.position[p]);
  }
}

void demandPlaces(const assembly::Assembly& assembly,
                  const std::map<std::string, std::shared_ptr<const laws::InterfaceLaw>>& laws) {
  std::map<std::string, std::vector<base::Vector3>> places;
  for (const assembly::Interface& interface : assembly.interfaces) {
    const auto law = laws.find(interface.name);
    if (law == laws.end() || laws::roleOf<laws::TurnedLaw>(*law->second) == nullptr) continue;
    const auto more = placesOfNodes(interface.trace1, assembly.bodies[interface.body1].nodes);
    auto& all = places[interface.name];
    all.insert(all.end(), more.begin(), more.end());
  }
  for (const auto& [name, ofName] : places) {
    try {
      laws::roleOf<laws::TurnedLaw>(*laws.at(name))->demandPlaces(ofName, assembly.steps());
    } catch (const base::Error& error) {
      throw base::Error(base::quoted(name) + ": " + error.what(), error.code());
    }
  }
}

}  // namespace harmos::scene
