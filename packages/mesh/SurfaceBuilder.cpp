#include <harmos/mesh/detail/SurfaceBuilder.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/InterfaceFrame.hpp>

namespace harmos::mesh {

SurfaceBuilder::SurfaceBuilder(const Mesh& mesh, const std::vector<Piece>& pieces, int piece1, int piece2,
                               const std::optional<base::Vector3>& projection)
    : mesh_(mesh), pieces_(pieces), piece1_(piece1), piece2_(piece2), projection_(projection) {}

void SurfaceBuilder::addFace(const std::vector<SurfacePoint>& corners, const FaceIntegrals& integrals) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    addPoint(corners[i], integrals.weight[i]);
    for (std::size_t j = 0; j < integrals.mass.size(); ++j) mass_[{corners[i], corners[j]}] += integrals.mass[i][j];
  }
  faces_.push_back(corners);
}

void SurfaceBuilder::addPoint(const SurfacePoint& point, const NodalWeight& weight) {
  points_[point] += weight;
}

InterfaceSurface SurfaceBuilder::build(const std::string& name) const {
  InterfaceSurface surface;
  surface.name = name;
  surface.piece1 = piece1_;
  surface.piece2 = piece2_;
  std::map<SurfacePoint, int> number;
  for (const auto& [point, data] : points_) {
    const auto& [node1, node2, patch] = point;
    const base::Vector3& place1 = mesh_.nodes[node1];
    if (!(data.area > 0.0)) {
      throw base::Error((piece2_ < 0 ? "Boundary " : "Interface ") + base::quoted(name) + ": the faces around " +
                            nodeName(mesh_, node1) + " have no area. Repair the mesh there" +
                            (projection_ ? ", or choose a Projection Direction that is not parallel to faces." : "."),
                        base::ExitCode::input);
    }
    number[point] = surface.pairs();
    surface.trace1.append({{localNode(pieces_[piece1_], node1), 1.0}});
    surface.position.push_back(place1);
    surface.patch.push_back(patch);
    surface.normal.push_back(projection_ ? data.area * *projection_ : data.normal);
    surface.frame.push_back(frameFromNormal(surface.normal.back(), mesh_.dimension));
    surface.area.push_back(data.area);
    surface.flux.push_back(projection_ ? data.share * *projection_ : data.flux);
    surface.share.push_back(data.share);
    surface.gap.push_back(0.0);
    if (piece2_ < 0) continue;
    surface.trace2.append({{localNode(pieces_[piece2_], node2), 1.0}});
    if (projection_) surface.gap.back() = dot(mesh_.nodes[node2] - place1, surface.frame.back()[0]);
  }
  for (const auto& face : faces_) {
    surface.face.emplace_back();
    for (const SurfacePoint& point : face) surface.face.back().push_back(number[point]);
  }
  for (const auto& [entry, value] : mass_) {
    surface.mass.push_back({number[entry.first], number[entry.second], value});
  }
  return surface;
}

}  // namespace harmos::mesh
