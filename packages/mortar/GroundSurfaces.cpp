#include <harmos/mortar/GroundSurfaces.hpp>

#include <map>
#include <utility>

#include <harmos/mesh/InterfaceFrame.hpp>
#include <harmos/mortar/detail/FacingCells.hpp>
#include <harmos/mortar/detail/PointBuilder.hpp>

namespace harmos::mortar {
namespace {

/// The points of faces that lie on themselves.
JoinedSurface ownPoints(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces, double creaseAngle,
                        const mesh::Depth& depth) {
  const SideCells side{faces, cellsOf(mesh.dimension, mesh.nodes, faces)};
  std::vector<std::pair<int, int>> pairs;
  for (int cell = 0; cell < static_cast<int>(side.cells.size()); ++cell) pairs.emplace_back(cell, cell);
  const auto couplings = coupleFaces(mesh.dimension, mesh.nodes, depth, side, side, pairs, {});
  return PointBuilder(faces, couplings, creaseAngle).build();
}

}  // namespace

std::vector<mesh::InterfaceSurface> groundSurfaces(const std::string& name, const mesh::Mesh& mesh,
                                                   const std::vector<mesh::Face>& faces, double creaseAngle,
                                                   const mesh::Depth& depth, const std::vector<mesh::Piece>& pieces,
                                                   const mesh::PieceMap& map) {
  std::map<int, std::vector<mesh::Face>> ofPieces;
  for (const mesh::Face& face : faces) ofPieces[map.of(face.element)].push_back(face);
  std::vector<mesh::InterfaceSurface> surfaces;
  for (const auto& [piece, own] : ofPieces) {
    const JoinedSurface points = ownPoints(mesh, own, creaseAngle, depth);
    mesh::InterfaceSurface& surface = surfaces.emplace_back();
    surface.name = name;
    surface.piece1 = piece;
    surface.patch = points.patch;
    surface.normal = surface.flux = points.normal;
    surface.area = surface.share = points.area;
    surface.gap.assign(points.area.size(), 0.0);
    surface.face = points.face;
    for (int p = 0; p < static_cast<int>(points.area.size()); ++p) {
      std::vector<mesh::TraceOperator::Entry> row;
      for (const auto& [node, weight] : points.trace[0].row(p)) {
        row.push_back({localNode(pieces[piece], node), weight});
      }
      surface.trace1.append(row);
      surface.position.push_back(points.trace[0].at(p, mesh.nodes));
      surface.frame.push_back(mesh::frameFromNormal(points.normal[p], mesh.dimension));
    }
  }
  return surfaces;
}

}  // namespace harmos::mortar
