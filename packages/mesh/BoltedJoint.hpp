#pragma once

#include <vector>

#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/MeshSize.hpp>

namespace harmos::input {
class ParameterSpec;
class Parameters;
}  // namespace harmos::input

namespace harmos::mesh {

/// The form that boltedJoint() reads: Refinement [-], above 0, at most 20, and Element, a hexahedron.
input::ParameterSpec describeBoltedJoint();

/// Three plates held by two bolts, in hexahedra with conforming nodes at every interface; lengths in mm.
///
/// Blocks cover_bottom, centre, cover_top, bolt_1, head_1, bolt_2, head_2. Side sets plates_bottom, plates_top,
/// head_1_cover, nut_1_cover, head_2_cover, nut_2_cover, preload_1, preload_2, each with _1 (the lower body) and _2,
/// and fixed_bottom, fixed_top, loaded. `refinement` multiplies the number of elements in every direction, rounded and
/// at least 1; at 1 the mesh has 8516 nodes and 5796 elements. The plates lie normal to z, from z = 0 to 30, the covers
/// reach from the overlap to x = -80, where they are fixed, the centre to x = 80, where it is loaded. Source: after the
/// first example of Champaney, Blanze, Boucard (2004), dimensions our own.
/// Nodes of quadratic `element`s, hex20 or hex27, follow the circles.
Mesh boltedJoint(double refinement = 1.0, ElementType element = ElementType::hex8);
/// The same from a list that was checked against describeBoltedJoint(). Throws base::Error when it was not.
Mesh boltedJoint(const input::Parameters& parameters);
/// The blocks of this mesh, which is not made. Throws as boltedJoint().
std::vector<BlockSize> boltedJointSizes(const input::Parameters& parameters);

}  // namespace harmos::mesh
