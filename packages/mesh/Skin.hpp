#pragma once

#include <vector>

#include <harmos/mesh/Elements.hpp>

namespace harmos::mesh {

/// One side of one element (an edge in 2-D); nodes in the order of sideNodes().
struct Face {
  int element = -1;        // mesh element number
  int side = -1;           // of that element, counted from 0
  std::vector<int> nodes;  // mesh node numbers
};

/// Corners of a face of a mesh of this many dimensions that has so many nodes; they come first.
int cornersOfFace(int dimension, std::size_t nodes);

/// The sides of `elements` that no two of them share, by element and side. Sides are shared if they have the same
/// nodes. `elements` are mesh element numbers, each once.
std::vector<Face> skin(const Elements& mesh, const std::vector<int>& elements);

/// Of these, the ones that have some of `nodes` (mesh node numbers, ascending): looks at no element without them.
std::vector<Face> skinAt(const Elements& mesh, const std::vector<int>& elements, const std::vector<int>& nodes);

}  // namespace harmos::mesh
