#include <harmos/scene/detail/ResponseRegistry.hpp>

#include <harmos/scene/detail/Place.hpp>

namespace harmos::scene {
namespace {

using Nodes = std::vector<latin::DisplacementResponse::Node>;

/// The nodes of a set with their shares of its area, which add up to 1.
Nodes nodesOf(const input::Parameters& p, const ResponseContext& context) {
  const auto surfaces =
      p.has("Side Set") ? context.finder.onSideSet(p.name(), p.text("Side Set"))
                        : context.finder.onNodeSet(p.name(), p.text("Node Set"), p.has("Part") ? p.text("Part") : "");
  double total = 0.0;
  Nodes nodes;
  for (const mesh::InterfaceSurface& surface : surfaces) {
    for (int pair = 0; pair < surface.pairs(); ++pair) {
      for (const auto& [node, weight] : surface.trace1.row(pair)) {
        nodes.push_back({surface.piece1, node, weight * surface.share[pair]});
      }
      total += surface.share[pair];
    }
  }
  for (auto& node : nodes) node.weight /= total;
  return nodes;
}

/// Mean displacement of a surface along a direction.
struct MeanDisplacement {
  static constexpr const char* name = "Mean Displacement";

  static void describe(input::ParameterSpec& p) {
    p.summary("Mean displacement [length] of a surface along a direction, weighted by area.");
    p.text("Side Set").example("upper_zmax").optional().doc("Side set of the mesh.");
    p.text("Node Set").optional().doc("Node set of the mesh, instead of a side set.");
    p.text("Part").optional().doc("Part whose nodes of the node set are meant, when parts share nodes.");
    p.numbers("Direction").example("{0, 0, 1}").required().doc("Of any length.");
  }

  static void check(const input::Parameters& p, input::ErrorList& errors) {
    checkPlace(p, "surface", "Side Set", errors);
  }

  static std::unique_ptr<latin::Response> make(const input::Parameters& p, const ResponseContext& context) {
    return std::make_unique<latin::DisplacementResponse>(p.name(), nodesOf(p, context), directionOf(p, "Direction"));
  }
};

}  // namespace

HARMOS_CHECKED_RESPONSE(MeanDisplacement)

}  // namespace harmos::scene
