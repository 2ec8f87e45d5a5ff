#include <harmos/scene/detail/Responses.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>

namespace harmos::scene {

namespace {

using input::Parameters;
using Field = latin::MaximumResponse::Field;
using Nodes = std::vector<latin::DisplacementResponse::Node>;

const std::vector<std::pair<std::string, Field>> fields = {{"Contact Pressure", Field::contactPressure},
                                                           {"Normal Traction", Field::normalTraction},
                                                           {"Tangential Traction", Field::tangentialTraction},
                                                           {"Opening", Field::opening},
                                                           {"Slip", Field::slip}};

class ResponseBuilder {
 public:
  ResponseBuilder(const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces, const mesh::InterfaceFinder& finder,
                  const assembly::Assembly& assembly)
      : mesh_(mesh), pieces_(pieces), finder_(finder), assembly_(assembly) {}

  std::shared_ptr<const latin::Response> make(const Parameters& r) const {
    const std::string& type = r.type();
    const std::string& name = r.name();
    if (type == "Mean Displacement") {
      return std::make_unique<latin::DisplacementResponse>(name, surfaceNodes(r), vector(r, "Direction", true));
    }
    if (type == "Point Displacement") {
      return std::make_unique<latin::DisplacementResponse>(name, pointNodes(r), vector(r, "Direction", true));
    }
    if (type == "Interface Force") {
      return std::make_unique<latin::ResultantResponse>(name, interfacesNamed({r.text("Interface")}),
                                                        std::vector<base::Vector3>{vector(r, "Direction", true)});
    }
    if (type == "Bolt Force") {
      return std::make_unique<latin::ResultantResponse>(name, interfacesNamed({r.text("Interface")}),
                                                        std::vector<base::Vector3>{});
    }
    if (type == "Interface Moment") {
      // In the plane the only moment is about z.
      const base::Vector3 axis = r.has("Axis") ? vector(r, "Axis", true) : base::Vector3{0.0, 0.0, 1.0};
      return std::make_unique<latin::ResultantResponse>(name, interfacesNamed({r.text("Interface")}),
                                                        std::vector<base::Vector3>{axis},
                                                        std::vector<base::Vector3>{vector(r, "Centre", false)});
    }
    const std::vector<int> interfaces =
        interfacesNamed(r.has("Interfaces") ? r.texts("Interfaces") : std::vector<std::string>());
    if (type == "Dissipation") return std::make_unique<latin::DissipationResponse>(name, interfaces);
    const auto field =
        std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.first == r.text("Field"); });
    return std::make_unique<latin::MaximumResponse>(name, interfaces, field->second);
  }

 private:
  static base::Vector3 vector(const Parameters& r, const std::string& entry, bool normalise) {
    const std::vector<double>& given = r.numbers(entry);
    base::Vector3 point{};
    std::copy(given.begin(), given.end(), point.begin());
    if (normalise) {
      const double length = std::hypot(point[0], point[1], point[2]);
      for (double& x : point) x /= length;
    }
    return point;
  }

  /// Positions of the interfaces of these names, an interface between pieces having several; without names, of all.
  std::vector<int> interfacesNamed(const std::vector<std::string>& names) const {
    std::vector<int> named;
    for (std::size_t i = 0; i < assembly_.interfaces.size(); ++i) {
      const std::string& name = assembly_.interfaces[i].name;
      if (names.empty() || std::find(names.begin(), names.end(), name) != names.end()) {
        named.push_back(static_cast<int>(i));
      }
    }
    return named;
  }

  /// The nodes of a set with their shares of its area, which add up to 1.
  Nodes surfaceNodes(const Parameters& r) const {
    const auto surfaces = r.has("Side Set")
                              ? finder_.onSideSet(r.name(), r.text("Side Set"))
                              : finder_.onNodeSet(r.name(), r.text("Node Set"), r.has("Part") ? r.text("Part") : "");
    double total = 0.0;
    Nodes nodes;
    for (const mesh::InterfaceSurface& surface : surfaces) {
      for (std::size_t i = 0; i < surface.node1.size(); ++i) {
        nodes.push_back({surface.piece1, surface.node1[i], surface.area[i]});
        total += surface.area[i];
      }
    }
    for (auto& node : nodes) node.weight /= total;
    return nodes;
  }

  Nodes pointNodes(const Parameters& r) const {
    const std::string part = r.has("Part") ? r.text("Part") : "";
    const int node = r.has("Point") ? nodeAt(vector(r, "Point", false), part) : onlyNodeOf(r.text("Node Set"));
    Nodes nodes;
    std::vector<std::string> parts;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const int local = mesh::localNode(pieces_[p], node);
      if (local < 0 || (!part.empty() && pieces_[p].part != part)) continue;
      nodes = {{static_cast<int>(p), local, 1.0}};
      if (parts.empty() || parts.back() != pieces_[p].part) parts.push_back(pieces_[p].part);
    }
    if (nodes.empty()) {
      throw base::Error("the node does not belong to " + (part.empty() ? "any part." : "the part \"" + part + "\"."),
                        base::ExitCode::input);
    }
    if (parts.size() > 1) {
      throw base::Error(
          "the node belongs to several parts: " + base::joinNames(parts) + ".\n  Say which with \"Part\".",
          base::ExitCode::input);
    }
    return nodes;
  }

  int onlyNodeOf(const std::string& name) const {
    std::vector<std::string> known;
    for (const mesh::NodeSet& set : mesh_.nodeSets) {
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

  /// The node at a point, within a millionth of the mesh's extent.
  int nodeAt(const base::Vector3& point, const std::string& part) const {
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    base::Vector3 lower = point, upper = point;
    for (const mesh::Piece& piece : pieces_) {
      if (!part.empty() && piece.part != part) continue;
      for (const int node : piece.nodes) {
        const base::Vector3& x = mesh_.nodes[node];
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
    if (least > 1e-6 * extent) {
      std::string text;
      for (int d = 0; d < mesh_.dimension; ++d) {
        text += (d ? ", " : "") + base::toText(mesh_.nodes[nearest][d]);
      }
      throw base::Error("there is no node at this point; the nearest is {" + text + "}.", base::ExitCode::input);
    }
    return nearest;
  }

  const mesh::Mesh& mesh_;
  const std::vector<mesh::Piece>& pieces_;
  const mesh::InterfaceFinder& finder_;
  const assembly::Assembly& assembly_;
};

}  // namespace

std::vector<input::ParameterSpec> responseForms() {
  input::ParameterSpec mean("Mean Displacement"), point("Point Displacement"), force("Interface Force"),
      moment("Interface Moment"), bolt("Bolt Force"), dissipation("Dissipation"), maximum("Maximum");

  mean.summary("Mean displacement [length] of a surface along a direction, weighted by area.");
  mean.text("Side Set").optional().doc("Side set of the mesh.");
  mean.text("Node Set").optional().doc("Node set of the mesh, instead of a side set.");
  mean.text("Part").optional().doc("Part whose nodes of the node set are meant, when parts share nodes.");
  mean.numbers("Direction").required().doc("Of any length.");

  point.summary("Displacement [length] of a node along a direction.");
  point.numbers("Point").unit("length").optional().doc("Coordinates of the node.");
  point.text("Node Set").optional().doc("Node set with this one node, instead of its coordinates.");
  point.text("Part").optional().doc("Part that the node belongs to, when several have nodes there.");
  point.numbers("Direction").required().doc("Of any length.");

  const std::string side1 =
      "Name of an interface or boundary; the force acts on its side 1, on a boundary on the part.";
  force.summary("Resultant [force] of the tractions of an interface or boundary along a direction.");
  force.text("Interface").required().doc(side1);
  force.numbers("Direction").required().doc("Of any length.");

  bolt.summary("Force [force] along the normal of an interface, positive in tension.");
  bolt.text("Interface").required().doc("Name of an interface or boundary that cuts through the bolt.");

  moment.summary("Resultant moment [force length] of the tractions of an interface or boundary about an axis.");
  moment.text("Interface").required().doc(side1);
  moment.numbers("Centre").unit("length").required().doc("Point on the axis.");
  moment.numbers("Axis").optional().doc("Direction of the axis, of any length; absent: z.");

  dissipation.summary("Energy [force length] lost in interfaces until the time step.");
  dissipation.texts("Interfaces").optional().doc("Names of interfaces or boundaries; absent: all.");

  std::vector<std::string> fieldNames;
  for (const auto& field : fields) fieldNames.push_back(field.first);
  maximum.summary("Largest value of a field over the nodes of interfaces.");
  maximum.texts("Interfaces").optional().doc("Names of interfaces or boundaries; absent: all.");
  maximum.text("Field").required().oneOf(fieldNames).doc("Pressure and tractions in [stress], the others in [length].");
  return {mean, point, force, bolt, moment, dissipation, maximum};
}

std::vector<std::shared_ptr<const latin::Response>> makeResponses(
    const std::vector<input::Parameters>& responses, const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces,
    const mesh::InterfaceFinder& finder, const assembly::Assembly& assembly, input::ErrorList& errors) {
  const ResponseBuilder builder(mesh, pieces, finder, assembly);
  std::vector<std::shared_ptr<const latin::Response>> made;
  for (const Parameters& response : responses) {
    errors.collect(response.where(), [&] { made.push_back(builder.make(response)); });
  }
  return made;
}

}  // namespace harmos::scene
