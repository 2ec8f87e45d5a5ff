#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <harmos/mesh/FaceIntegrals.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::mesh {

/// Collects the faces or the single nodes that one pair of parts (or one part and the ground) share at an interface.
class SurfaceBuilder {
 public:
  /// piece2 = -1 for an outer boundary. With a unit vector `projection`, from side 1 to side 2, normals are along it
  /// and gaps are measured along it; otherwise gaps are 0.
  SurfaceBuilder(const Mesh& mesh, const std::vector<Piece>& pieces, int piece1, int piece2,
                 const std::optional<base::Vector3>& projection = std::nullopt);

  /// nodes2 in the order of nodes1, empty for an outer boundary; mesh node numbers. The mass may be left out.
  void addFace(const std::vector<int>& nodes1, const std::vector<int>& nodes2, const FaceIntegrals& integrals);
  /// A node pair that belongs to no face. `normal` may have any length, also zero if there is no direction.
  void addNode(int node1, int node2, double area, const base::Vector3& normal);

  /// Pairs ascend by the local nodes of side 1. Throws base::Error(input) if a pair has no area.
  InterfaceSurface build(const std::string& name) const;

 private:
  using Pair = std::pair<int, int>;  // mesh nodes; second -1 for an outer boundary
  struct PairData {
    double area = 0.0;
    base::Vector3 normal{};
  };

  const Mesh& mesh_;
  const std::vector<Piece>& pieces_;
  int piece1_, piece2_;
  std::optional<base::Vector3> projection_;
  std::map<Pair, PairData> pairs_;
  std::vector<std::vector<Pair>> faces_;
  std::map<std::pair<Pair, Pair>, double> mass_;
};

/// The surfaces of one interface: a builder per pair of pieces that meet. Keeps references to the mesh and the parts.
class SurfaceBuilders {
 public:
  /// `projection` as for SurfaceBuilder.
  SurfaceBuilders(const Mesh& mesh, const std::vector<Piece>& pieces,
                  const std::optional<base::Vector3>& projection = std::nullopt)
      : mesh_(mesh), pieces_(pieces), projection_(projection) {}

  /// The builder of a pair, made when first asked for; piece2 = -1 for an outer boundary.
  SurfaceBuilder& at(int piece1, int piece2);
  /// By ascending pieces.
  std::vector<InterfaceSurface> build(const std::string& name) const;

 private:
  const Mesh& mesh_;
  const std::vector<Piece>& pieces_;
  std::optional<base::Vector3> projection_;
  std::map<std::pair<int, int>, SurfaceBuilder> all_;
};

/// The frame of an interface node from its normal (any length; zero: the x axis). t1 is the direction, in the tangent
/// plane, of the axis that is least normal to the interface, the first of x, y, z among equals; in 2-D t1 = t2 x n.
base::Frame frameFromNormal(const base::Vector3& normal, int dimension);

}  // namespace harmos::mesh
