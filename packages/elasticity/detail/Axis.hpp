#pragma once

#include <vector>

#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::elasticity {

/// Per node of the part, whether it lies on the axis of axisymmetry, where nothing moves along the radius. Throws
/// base::Error (input) that counts the nodes of negative radius.
std::vector<bool> nodesOnAxis(const mesh::Mesh& mesh, const mesh::Piece& piece, Kinematics kinematics);

}  // namespace harmos::elasticity
