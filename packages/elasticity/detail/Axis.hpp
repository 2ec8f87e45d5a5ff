#pragma once

#include <vector>

#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::elasticity {

/// Per node of the part, whether it lies on the axis of axisymmetry, see isFreeOnAxis(). Throws base::Error (input)
/// that counts the nodes of negative radius.
std::vector<bool> nodesOnAxis(const mesh::Mesh& mesh, const mesh::Piece& piece, Kinematics kinematics);

/// Whether this component of the displacement may differ from 0 on the axis: the one along it.
inline bool isFreeOnAxis(int component) {
  return component == 1;
}

}  // namespace harmos::elasticity
