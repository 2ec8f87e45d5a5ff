#include <harmos/scene/detail/ResponseRegistry.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/scene/detail/Place.hpp>

namespace harmos::scene {
namespace {

using Nodes = std::vector<latin::DisplacementResponse::Node>;

// Distance over the extent of the mesh within which a node is at a point.
constexpr double samePlace = 1e-6;

int onlyNodeOf(const std::string& name, const mesh::Mesh& mesh) {
  std::vector<std::string> known;
  for (const mesh::NodeSet& set : mesh.nodeSets) {
    if (set.name == name && set.node.size() == 1) return set.node.front();
    if (set.name == name) {
      throw base::Error("the node set \"" + name + "\" has " + std::to_string(set.node.size()) +
                            " nodes, but a point is one.\n  Use Type = Mean Displacement for the mean over a set.",
                        base::ExitCode::input);
    }
    known.push_back(set.name);
  }
  throw base::Error("the mesh has no node set \"" + name + "\".\n  " + base::suggestName(name, known, "Node sets"),
                    base::ExitCode::input);
}

/// The node at a point.
int nodeAt(const base::Vector3& point, const std::string& part, const ResponseContext& context) {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  base::Vector3 lower = point, upper = point;
  for (const mesh::Piece& piece : context.pieces) {
    if (!part.empty() && piece.part != part) continue;
    for (const int node : piece.nodes) {
      const base::Vector3& x = context.mesh.nodes[node];
      for (std::size_t d = 0; d < 3; ++d) {
        lower[d] = std::min(lower[d], x[d]);
        upper[d] = std::max(upper[d], x[d]);
      }
      const double distance = std::hypot(x[0] - point[0], x[1] - point[1], x[2] - point[2]);
      if (distance < least) {
        least = distance;
        nearest = node;
      }
    }
  }
  const double extent = std::hypot(upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]);
  if (least > samePlace * extent) {
    std::string text;
    for (int d = 0; d < context.mesh.dimension; ++d) {
      text += (d ? ", " : "") + base::toText(context.mesh.nodes[nearest][d]);
    }
    throw base::Error("there is no node at this point; the nearest is {" + text + "}.", base::ExitCode::input);
  }
  return nearest;
}

Nodes nodesOf(const input::Parameters& p, const ResponseContext& context) {
  const std::string part = p.has("Part") ? p.text("Part") : "";
  const int node =
      p.has("Point") ? nodeAt(vectorOf(p, "Point"), part, context) : onlyNodeOf(p.text("Node Set"), context.mesh);
  Nodes nodes;
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < context.pieces.size(); ++i) {
    const int local = mesh::localNode(context.pieces[i], node);
    if (local < 0 || (!part.empty() && context.pieces[i].part != part)) continue;
    nodes = {{static_cast<int>(i), local, 1.0}};
    if (parts.empty() || parts.back() != context.pieces[i].part) parts.push_back(context.pieces[i].part);
  }
  if (nodes.empty()) {
    throw base::Error("the node does not belong to " + (part.empty() ? "any part." : "the part \"" + part + "\"."),
                      base::ExitCode::input);
  }
  if (parts.size() > 1) {
    throw base::Error("the node belongs to several parts: " + base::joinNames(parts) + ".\n  Say which with \"Part\".",
                      base::ExitCode::input);
  }
  return nodes;
}

/// Displacement of a node along a direction.
struct PointDisplacement {
  static constexpr const char* name = "Point Displacement";

  static void describe(input::ParameterSpec& p) {
    p.summary("Displacement [length] of a node along a direction.");
    p.numbers("Point").example("{20, 0, 20}").unit("length").optional().doc("Coordinates of the node.");
    p.text("Node Set").optional().doc("Node set with this one node, instead of its coordinates.");
    p.text("Part").optional().doc("Part that the node belongs to, when several have nodes there.");
    p.numbers("Direction").example("{0, 0, 1}").required().doc("Of any length.");
  }

  static void check(const input::Parameters& p, input::ErrorList& errors) { checkPlace(p, "node", "Point", errors); }

  static std::unique_ptr<latin::Response> make(const input::Parameters& p, const ResponseContext& context) {
    return std::make_unique<latin::DisplacementResponse>(p.name(), nodesOf(p, context), directionOf(p, "Direction"));
  }
};

}  // namespace

HARMOS_CHECKED_RESPONSE(PointDisplacement)

}  // namespace harmos::scene
