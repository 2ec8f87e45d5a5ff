#pragma once

#include <string>
#include <vector>

#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>
#include <harmos/mesh/RedundantPairs.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::scene {

/// Whether a point of meshes that do not match has its unknowns in the surface of other pieces.
bool isCopy(const mesh::InterfaceSurface& surface, int p);

/// Whether the law of this interface is a laws::NodalLaw.
bool isOfNodes(const Scene& scene, const std::string& interface);

/// Throws base::Error (input), which names node and parts, where a laws::NodalLaw would act on a node of several parts,
/// as a force on each of them.
void demandOnePart(const laws::InterfaceLaw& law, const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces,
                   const std::vector<mesh::InterfaceSurface>& surfaces);

/// Which pairs carry the unknowns of all: those of mesh::mergeRedundantPairs(), which see; with consistent masses every
/// pair itself, but for laws::NodalLaw, which acts once, whatever pieces of a part have the node.
std::vector<std::vector<mesh::PairCarrier>> carriersOf(const Scene& scene, const std::vector<mesh::Piece>& pieces,
                                                       int dimension, bool isConsistent,
                                                       std::vector<mesh::InterfaceSurface>& surfaces);

}  // namespace harmos::scene
