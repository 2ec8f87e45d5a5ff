#pragma once

#include <vector>

#include <harmos/files/ResultMesh.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::files {

/// The file of parts: one element block per piece and element type, named after the piece, PIECE or where it has
/// several types PIECE_TYPE. Every piece has nodes of its own, so that they are doubled at interfaces. Side sets
/// INTERFACE_1 and INTERFACE_2, for outer boundaries BOUNDARY; of interfaces without faces, and of sides whose
/// nodes are no points of the interface, node sets of the same names.
/// A name already in use gets "_set" appended. Elements have the numbers of the user's file unless they are children of
/// those, nodes where each is there once.
struct PartsLayout {
  ResultMesh mesh;                        // coordinates as in the mesh [length]
  std::vector<int> firstNode;             // result node of a piece's local node 0; the others follow
  std::vector<std::vector<int>> element;  // [piece][position in Piece::elements]: result element
};
/// Lays out the file of parts, on one rank that has all pieces; nothing is kept of the arguments.
PartsLayout layOutParts(const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces,
                        const std::vector<mesh::InterfaceSurface>& surfaces);

/// The file of interfaces: its nodes are the pairs at their positions; blocks of SHELL4 and TRI3, in 2-D
/// BAR2, named after the interface, or of SPHERE (points) where an interface has no faces. INTERFACE_TYPE where an
/// interface has faces of two types. At a crease several nodes lie at one place, each on the faces of its patch, so
/// that pressures and normals do not mix there.
struct InterfacesLayout {
  ResultMesh mesh;             // coordinates as in the mesh [length]; no sets
  std::vector<int> firstPair;  // result node of a surface's pair 0; the others follow
};
/// Lays out the file of interfaces, likewise, in 2 or 3 dimensions.
InterfacesLayout layOutInterfaces(int dimension, const std::vector<mesh::InterfaceSurface>& surfaces);

}  // namespace harmos::files
