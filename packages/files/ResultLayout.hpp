#pragma once

#include <vector>

#include <harmos/files/ResultMesh.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::files {

/// The file of parts: one element block per part and element type, named after the part. Every part has nodes of its
/// own, so that they are doubled at interfaces. Side sets <interface>_1 and <interface>_2, for outer boundaries
/// <boundary>; of interfaces without faces node sets of the same names. A name already in use gets "_set" appended.
struct PartsLayout {
  ResultMesh mesh;
  std::vector<int> firstNode;             // result node of a part's local node 0; the others follow
  std::vector<std::vector<int>> element;  // [part][position in Piece::elements]: result element
};
PartsLayout layOutParts(const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces,
                        const std::vector<mesh::InterfaceSurface>& surfaces);

/// The file of interfaces: its nodes are the node pairs, at the place of side 1; blocks of SHELL4 and TRI3, in 2-D
/// BAR2, named after the interface, or of SPHERE (points) where an interface has no faces.
struct InterfacesLayout {
  ResultMesh mesh;
  std::vector<int> firstPair;  // result node of a surface's pair 0; the others follow
};
InterfacesLayout layOutInterfaces(const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces,
                                  const std::vector<mesh::InterfaceSurface>& surfaces);

}  // namespace harmos::files
