#include <harmos/elasticity/detail/Axis.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/mesh/Depth.hpp>
#include <harmos/mesh/Elements.hpp>

namespace harmos::elasticity {

std::vector<bool> nodesOnAxis(const mesh::Mesh& mesh, const mesh::Piece& piece, Kinematics kinematics) {
  std::vector<bool> isOnAxis(piece.nodes.size(), false);
  if (!isAxisymmetric(kinematics)) return isOnAxis;
  double largest = 0.0;
  for (const int node : piece.nodes) largest = std::max(largest, std::abs(mesh.nodes[node][0]));
  int count = 0, worst = -1;
  for (std::size_t local = 0; local < piece.nodes.size(); ++local) {
    const int node = piece.nodes[local];
    const double radius = mesh.nodes[node][0];
    isOnAxis[local] = std::abs(radius) <= mesh::Depth::onAxis * largest;
    if (isOnAxis[local] || radius > 0.0) continue;
    ++count;
    if (worst < 0 || radius < mesh.nodes[worst][0]) worst = node;
  }
  if (count == 0) return isOnAxis;
  throw base::Error("Part " + base::quoted(piece.part) + " has " + std::to_string(count) +
                        (count == 1 ? " node" : " nodes") + " with a negative radius x, the farthest " +
                        mesh::nodeName(mesh, worst) +
                        ". In axisymmetry the axis is x = 0 and parts lie at x >= 0: move the mesh.",
                    base::ExitCode::input);
}

}  // namespace harmos::elasticity
