#pragma once

#include <vector>

#include <harmos/mesh/FaceMatching.hpp>
#include <harmos/mesh/Mesh.hpp>

namespace harmos::mesh {

/// What lies on each other of two sides without being a pair of matchFaces().
struct FaceOverlap {
  std::vector<int> faces1, faces2;  // ascending: indices into the lists of faces
};

/// Two faces lie on each other when their normals are opposite, they overlap by more than a hundredth of the smaller
/// one seen along the first one's normal, and they either lie in one plane, within a thousandth of their shortest edge,
/// or touch in a node and hardly deviate, as the facets of two meshes of one curved surface do. `matched`: pairs of
/// faces that are left out. In 2-D faces have two nodes. O((n + pairs of faces that overlap) log n).
FaceOverlap findOverlap(const Mesh& mesh, const std::vector<Face>& side1, const std::vector<Face>& side2,
                        const std::vector<FacePair>& matched);

}  // namespace harmos::mesh
