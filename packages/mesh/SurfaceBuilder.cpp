#include <harmos/mesh/detail/SurfaceBuilder.hpp>

#include <cmath>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/base/Vector3.hpp>

namespace harmos::mesh {

SurfaceBuilder::SurfaceBuilder(const Mesh& mesh, const std::vector<Piece>& pieces, int piece1, int piece2,
                               const std::optional<base::Vector3>& projection)
    : mesh_(mesh), pieces_(pieces), piece1_(piece1), piece2_(piece2), projection_(projection) {}

void SurfaceBuilder::addFace(const std::vector<int>& nodes1, const std::vector<int>& nodes2,
                             const FaceIntegrals& integrals) {
  std::vector<Pair> face;
  for (std::size_t i = 0; i < nodes1.size(); ++i) {
    face.emplace_back(nodes1[i], nodes2.empty() ? -1 : nodes2[i]);
    PairData& data = pairs_[face.back()];
    data.area += integrals.area[i];
    data.normal = data.normal + integrals.normal[i];
  }
  for (std::size_t i = 0; i < face.size(); ++i) {
    for (std::size_t j = 0; j < integrals.mass.size(); ++j) mass_[{face[i], face[j]}] += integrals.mass[i][j];
  }
  faces_.push_back(std::move(face));
}

void SurfaceBuilder::addNode(int node1, int node2, double area, const base::Vector3& normal) {
  PairData& data = pairs_[{node1, node2}];
  data.area += area;
  data.normal = data.normal + normal;
}

InterfaceSurface SurfaceBuilder::build(const std::string& name) const {
  InterfaceSurface surface;
  surface.name = name;
  surface.piece1 = piece1_;
  surface.piece2 = piece2_;
  std::map<Pair, int> number;
  for (const auto& [pair, data] : pairs_) {
    const base::Vector3& place1 = mesh_.nodes[pair.first];
    if (!(data.area > 0.0)) {
      std::ostringstream message;
      message << "Interface \"" << name << "\": the faces around the node at (" << place1[0] << ", " << place1[1]
              << ", " << place1[2] << ") have no area. Repair the mesh there"
              << (projection_ ? ", or choose a Projection Direction that is not parallel to faces." : ".");
      throw base::Error(message.str(), base::ExitCode::input);
    }
    number[pair] = static_cast<int>(surface.node1.size());
    surface.node1.push_back(localNode(pieces_[piece1_], pair.first));
    surface.frame.push_back(frameFromNormal(projection_ ? *projection_ : data.normal, mesh_.dimension));
    surface.area.push_back(data.area);
    surface.gap.push_back(0.0);
    if (piece2_ < 0) continue;
    surface.node2.push_back(localNode(pieces_[piece2_], pair.second));
    if (projection_) {
      surface.gap.back() = dot(mesh_.nodes[pair.second] - place1, surface.frame.back()[0]);
    }
  }
  for (const auto& face : faces_) {
    surface.face.emplace_back();
    for (const Pair& pair : face) surface.face.back().push_back(number[pair]);
  }
  for (const auto& [entry, value] : mass_) {
    surface.mass.push_back({number[entry.first], number[entry.second], value});
  }
  return surface;
}

SurfaceBuilder& SurfaceBuilders::at(int piece1, int piece2) {
  return all_.try_emplace({piece1, piece2}, mesh_, pieces_, piece1, piece2, projection_).first->second;
}

std::vector<InterfaceSurface> SurfaceBuilders::build(const std::string& name) const {
  std::vector<InterfaceSurface> surfaces;
  for (const auto& [pieces, builder] : all_) surfaces.push_back(builder.build(name));
  return surfaces;
}

base::Frame frameFromNormal(const base::Vector3& normal, int dimension) {
  const double length = norm(normal);
  const base::Vector3 n = length > 0.0 ? (1.0 / length) * normal : base::Vector3{1.0, 0.0, 0.0};
  if (dimension == 2) return {n, base::Vector3{-n[1], n[0], 0.0}, base::Vector3{0.0, 0.0, 1.0}};
  // A margin decides between axes that are equally far from n but for rounding.
  constexpr double margin = 1e-6;
  std::size_t axis = 0;
  for (std::size_t d = 1; d < 3; ++d) {
    if (std::abs(n[d]) < std::abs(n[axis]) - margin) axis = d;
  }
  base::Vector3 t1 = (-n[axis]) * n;
  t1[axis] += 1.0;
  t1 = (1.0 / norm(t1)) * t1;
  return {n, t1, cross(n, t1)};
}

}  // namespace harmos::mesh
