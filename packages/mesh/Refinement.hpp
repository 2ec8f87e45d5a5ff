#pragma once

#include <harmos/mesh/Mesh.hpp>

namespace harmos::mesh {

/// The mesh with every element split at the middles of its edges: triangles and quadrilaterals into 4, tetrahedra,
/// wedges and hexahedra into 8, so that elements that shared a side still do.
///
/// No node moves, and the old ones keep their numbers; new ones lie on the element as it is, on the curve of quadratic
/// edges. Tetrahedra are cut along the shortest diagonal inside. Elements of a block follow one another in the old
/// order; sides of side sets are replaced by their parts. A new node is in a node set if the corners around it (of its
/// edge, its face, or its element) are, and lie on one side of the skin of a block or all around one element. Throws
/// base::Error (input) naming the block: pyramids, which do not split into pyramids; and when there would be more nodes
/// than an int can count.
Mesh refined(const Mesh& mesh);

/// The mesh with quadratic elements in place of linear ones: tri6, quad8, tet10, wedge15, hex20. New nodes are in the
/// middle of straight edges and in sets as in refined(); elements keep their numbers, quadratic ones stay as they are.
/// Throws base::Error (input) naming the block for pyramids, of which there are only linear ones, and as refined().
Mesh raised(const Mesh& mesh);

/// The quadratic element that it puts in the place of a linear one; others stay.
ElementType raised(ElementType type);

}  // namespace harmos::mesh
