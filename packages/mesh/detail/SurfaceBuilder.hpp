#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <harmos/mesh/FaceIntegrals.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/Piece.hpp>
#include <harmos/mesh/SmoothPatches.hpp>

namespace harmos::mesh {

/// A point of a surface: a pair of nodes, and the smooth patch of faces around it.
using SurfacePoint = std::tuple<int, int, int>;  // mesh nodes, the second -1 on an outer boundary; patch

/// Adds up what one pair of pieces (or one piece and the ground) share at an interface.
class SurfaceBuilder {
 public:
  /// piece2 = -1 for an outer boundary. With a unit vector `projection`, from side 1 to side 2, normals are along it
  /// and gaps are measured along it; otherwise gaps are 0.
  SurfaceBuilder(const Mesh& mesh, const std::vector<Piece>& pieces, int piece1, int piece2,
                 const std::optional<base::Vector3>& projection = std::nullopt);

  /// A face of the surface, its corners in the order of the integrals. The mass may be left out.
  void addFace(const std::vector<SurfacePoint>& corners, const FaceIntegrals& integrals);
  /// What a point has besides the faces of the surface. Normals may have any length, also zero if there is no
  /// direction.
  void addPoint(const SurfacePoint& point, const NodalWeight& weight);

  /// Pairs ascend by the local nodes of side 1. Throws base::Error(input) if a pair has no area.
  InterfaceSurface build(const std::string& name) const;

 private:
  const Mesh& mesh_;
  const std::vector<Piece>& pieces_;
  int piece1_, piece2_;
  std::optional<base::Vector3> projection_;
  std::map<SurfacePoint, NodalWeight> points_;
  std::vector<std::vector<SurfacePoint>> faces_;
  std::map<std::pair<SurfacePoint, SurfacePoint>, double> mass_;
};

}  // namespace harmos::mesh
