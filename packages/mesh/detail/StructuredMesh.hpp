#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <harmos/mesh/MeshSize.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {

/// Builds a mesh from structured grids that are mapped into place; nothing is made before all of them are known.
///
/// Nodes of the grids of one block are merged where they coincide (within 1e-9 of the block's size), so that a block
/// may be pieced together from several grids, and a grid may close upon itself; nodes of different blocks stay apart.
class StructuredMesh {
 public:
  /// Carries the unit square or cube into place; must keep the orientation (positive Jacobian).
  using Map = std::function<base::Vector3(const base::Vector3&)>;
  using Region = std::function<bool(const base::Vector3&)>;

  explicit StructuredMesh(int dimension);

  /// Starts a block; the grids that follow belong to it.
  void addBlock(const std::string& name, ElementType type);
  /// Cells per direction; each cell is one hexahedron or quadrilateral, or two wedges, two triangles, six tetrahedra
  /// (all cells cut the same way, so that the faces of neighbours agree), or six pyramids around a node in its middle.
  /// All nodes of quadratic elements are on the map, middles of edges included.
  void addGrid(const std::array<int, 3>& cells, const Map& map);
  /// The faces on the skin of a block whose nodes all lie in the region.
  void addSideSet(const std::string& name, const std::string& block, const Region& region);
  /// The nodes of a block that lie in the region.
  void addNodeSet(const std::string& name, const std::string& block, const Region& region);

  /// Of the blocks in their order.
  std::vector<BlockSize> sizes() const;
  /// Makes the mesh and hands it over; the builder is empty afterwards.
  Mesh take();

 private:
  struct Grid {
    std::array<int, 3> cells;
    Map map;
  };
  struct Block {
    std::string name;
    ElementType type;
    std::vector<Grid> grids;
  };
  struct SetRequest {
    std::string name, block;
    Region region;
  };

  /// Adds a block to the mesh, with all of its nodes.
  void make(const Block& block);
  void makeGrid(const Grid& grid);
  /// Of the last block.
  void mergeCoincidentNodes(std::size_t firstNode);

  std::vector<Block> blocks_;
  Mesh mesh_;
  std::vector<SetRequest> sideSets_, nodeSets_;
};

/// The map of the unit cube onto the box between two corners; exact at both.
StructuredMesh::Map boxMap(const base::Vector3& lower, const base::Vector3& upper);

}  // namespace harmos::mesh
