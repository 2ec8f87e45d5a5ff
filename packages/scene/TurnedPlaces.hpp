#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/laws/TurnedLaw.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>

namespace harmos::scene {

/// Undeformed places [length] of the nodes that side 1 of a surface moves with, of each point all of its own; `nodes`
/// are those of the body. Where points are nodes: their places.
std::vector<base::Vector3> placesOfNodes(const mesh::TraceOperator& trace, const std::vector<base::Vector3>& nodes);

/// Gives the points of a surface that lie between nodes the gaps of TurnedLaw::distanceBeyondMean(); `nodes` are those
/// of the body of side 1.
void measureGaps(const laws::TurnedLaw& law, const std::vector<base::Vector3>& nodes, mesh::InterfaceSurface& surface);

/// Throws base::Error (input), which names the interface, where one of these laws, by name, cannot act at the nodes of
/// its interfaces, those of one name together; see TurnedLaw::demandPlaces().
void demandPlaces(const assembly::Assembly& assembly,
                  const std::map<std::string, std::shared_ptr<const laws::InterfaceLaw>>& laws);

}  // namespace harmos::scene
