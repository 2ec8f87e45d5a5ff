#include <harmos/mesh/detail/StructuredMesh.hpp>

#include <algorithm>
#include <numeric>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/PointSearch.hpp>
#include <harmos/mesh/ReferenceElement.hpp>

namespace harmos::mesh {
namespace {

/// Corners of the elements of a cell: 0..3 counter-clockwise below (or in the plane), 4..7 above, 8 the middle.
const std::vector<std::vector<int>>& elementsOfCell(ElementType type) {
  static const std::map<ElementType, std::vector<std::vector<int>>> all = {
      {ElementType::quad4, {{0, 1, 2, 3}}},
      {ElementType::tri3, {{0, 1, 2}, {0, 2, 3}}},
      {ElementType::hex8, {{0, 1, 2, 3, 4, 5, 6, 7}}},
      {ElementType::wedge6, {{0, 1, 2, 4, 5, 6}, {0, 2, 3, 4, 6, 7}}},
      // Kuhn's six tetrahedra around the diagonal from corner 0 to corner 6.
      {ElementType::tet4, {{0, 1, 2, 6}, {0, 3, 7, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}, {0, 2, 3, 6}, {0, 7, 4, 6}}},
      {ElementType::pyramid5,
       {{0, 4, 5, 1, 8}, {1, 5, 6, 2, 8}, {2, 6, 7, 3, 8}, {0, 3, 7, 4, 8}, {0, 1, 2, 3, 8}, {4, 7, 6, 5, 8}}},
  };
  return all.at(linearType(type));
}

/// Where in a cell the nodes of its elements are that are no corners.
class MiddleNodes {
 public:
  explicit MiddleNodes(ElementType type) {
    if (!isQuadratic(type)) return;
    const auto places = nodePlaces(type);
    shapes_ = shapeFunctions(linearType(type), {places.begin() + cornersPerElement(type), places.end()});
  }

  /// In units of the cell, for an element with these corners of it.
  std::vector<base::Vector3> inCell(const std::vector<int>& corners) const {
    static constexpr base::Vector3 cell[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                             {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    std::vector<base::Vector3> result(shapes_.points);
    for (int at = 0; at < shapes_.points; ++at) {
      for (int a = 0; a < shapes_.nodes; ++a) {
        result[at] = result[at] + shapes_.value[at * shapes_.nodes + a] * cell[corners[a]];
      }
    }
    return result;
  }

 private:
  ShapeFunctions shapes_;  // of the linear element
};

}  // namespace

StructuredMesh::StructuredMesh(int dimension) {
  mesh_.dimension = dimension;
}

void StructuredMesh::addBlock(const std::string& name, ElementType type) {
  blocks_.push_back({name, type, {}});
}

void StructuredMesh::addGrid(const std::array<int, 3>& cells, const Map& map) {
  blocks_.back().grids.push_back({{cells[0], cells[1], mesh_.dimension == 2 ? 0 : cells[2]}, map});
}

std::vector<BlockSize> StructuredMesh::sizes() const {
  std::vector<BlockSize> result;
  for (const Block& block : blocks_) {
    double cells = 0.0;
    for (const Grid& grid : block.grids) {
      cells += 1.0 * grid.cells[0] * grid.cells[1] * std::max(grid.cells[2], 1);
    }
    result.push_back({block.name, block.type, cells * static_cast<double>(elementsOfCell(block.type).size())});
  }
  return result;
}

void StructuredMesh::make(const Block& block) {
  const std::size_t firstNode = mesh_.nodes.size();
  mesh_.blocks.push_back({block.name, static_cast<std::int64_t>(mesh_.blocks.size()) + 1, block.type, {}});
  for (const Grid& grid : block.grids) makeGrid(grid);
  mergeCoincidentNodes(firstNode);
}

void StructuredMesh::makeGrid(const Grid& grid) {
  ElementBlock& block = mesh_.blocks.back();
  const bool flat = mesh_.dimension == 2;
  const std::array<int, 3>& n = grid.cells;
  const int offset = static_cast<int>(mesh_.nodes.size());
  const auto place = [&](double i, double j, double k) {
    return grid.map({i / n[0], j / n[1], flat ? 0.0 : k / n[2]});
  };
  for (int k = 0; k <= n[2]; ++k) {
    for (int j = 0; j <= n[1]; ++j) {
      for (int i = 0; i <= n[0]; ++i) mesh_.nodes.push_back(place(i, j, k));
    }
  }
  const int row = n[0] + 1;
  const int layer = row * (n[1] + 1);
  const MiddleNodes middles(block.type);
  for (int k = 0; k < std::max(n[2], 1); ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        const int corner = offset + i + row * j + layer * k;
        std::array<int, 9> nodes = {corner,
                                    corner + 1,
                                    corner + row + 1,
                                    corner + row,
                                    corner + layer,
                                    corner + layer + 1,
                                    corner + layer + row + 1,
                                    corner + layer + row,
                                    -1};
        if (block.type == ElementType::pyramid5) {
          nodes[8] = static_cast<int>(mesh_.nodes.size());
          mesh_.nodes.push_back(place(i + 0.5, j + 0.5, k + 0.5));
        }
        for (const auto& element : elementsOfCell(block.type)) {
          for (const int local : element) block.connectivity.push_back(nodes[local]);
          for (const base::Vector3& at : middles.inCell(element)) {
            block.connectivity.push_back(static_cast<int>(mesh_.nodes.size()));
            mesh_.nodes.push_back(place(i + at[0], j + at[1], k + at[2]));
          }
        }
      }
    }
  }
}

void StructuredMesh::addSideSet(const std::string& name, const std::string& block, const Region& region) {
  sideSets_.push_back({name, block, region});
}

void StructuredMesh::addNodeSet(const std::string& name, const std::string& block, const Region& region) {
  nodeSets_.push_back({name, block, region});
}

void StructuredMesh::mergeCoincidentNodes(std::size_t firstNode) {
  const std::vector<base::Vector3> points(mesh_.nodes.begin() + static_cast<std::ptrdiff_t>(firstNode),
                                          mesh_.nodes.end());
  base::Vector3 low = points.empty() ? base::Vector3{} : points.front();
  base::Vector3 high = low;
  for (const base::Vector3& point : points) {
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], point[d]);
      high[d] = std::max(high[d], point[d]);
    }
  }
  const double tolerance = 1e-9 * distance(low, high);
  const PointSearch search(points);
  std::vector<int> number(points.size());
  mesh_.nodes.resize(firstNode);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto lowest = static_cast<std::size_t>(search.within(points[i], tolerance).front());
    if (lowest < i) {
      number[i] = number[lowest];
    } else {
      number[i] = static_cast<int>(mesh_.nodes.size());
      mesh_.nodes.push_back(points[i]);
    }
  }
  for (int& node : mesh_.blocks.back().connectivity) node = number[static_cast<std::size_t>(node) - firstNode];
}

Mesh StructuredMesh::take() {
  for (const Block& block : blocks_) make(block);
  const Elements elements(mesh_);
  const auto find = [&](const std::string& name) {
    const auto found = std::find_if(mesh_.blocks.begin(), mesh_.blocks.end(),
                                    [&](const ElementBlock& block) { return block.name == name; });
    return static_cast<int>(found - mesh_.blocks.begin());
  };
  const auto inside = [&](const Region& region) { return [&](int node) { return region(mesh_.nodes[node]); }; };
  std::map<std::string, std::vector<Face>> skins;
  for (const SetRequest& request : sideSets_) {
    if (skins.count(request.block) == 0) {
      const int block = find(request.block);
      std::vector<int> list(mesh_.blocks[block].elements());
      std::iota(list.begin(), list.end(), elements.first(block));
      skins[request.block] = skin(elements, list);
    }
    SideSet set{request.name, static_cast<std::int64_t>(mesh_.sideSets.size()) + 1, {}, {}};
    for (const Face& face : skins[request.block]) {
      if (!std::all_of(face.nodes.begin(), face.nodes.end(), inside(request.region))) continue;
      set.element.push_back(face.element);
      set.side.push_back(face.side);
    }
    mesh_.sideSets.push_back(std::move(set));
  }
  for (const SetRequest& request : nodeSets_) {
    NodeSet set{request.name, static_cast<std::int64_t>(mesh_.nodeSets.size()) + 1, {}};
    const ElementBlock& block = mesh_.blocks[find(request.block)];
    std::copy_if(block.connectivity.begin(), block.connectivity.end(), std::back_inserter(set.node),
                 inside(request.region));
    std::sort(set.node.begin(), set.node.end());
    set.node.erase(std::unique(set.node.begin(), set.node.end()), set.node.end());
    mesh_.nodeSets.push_back(std::move(set));
  }
  blocks_.clear();
  sideSets_.clear();
  nodeSets_.clear();
  Mesh result;
  std::swap(result, mesh_);
  mesh_.dimension = result.dimension;
  return result;
}

StructuredMesh::Map boxMap(const base::Vector3& lower, const base::Vector3& upper) {
  return [lower, upper](const base::Vector3& t) {
    base::Vector3 place{};
    for (std::size_t d = 0; d < 3; ++d) place[d] = (1.0 - t[d]) * lower[d] + t[d] * upper[d];
    return place;
  };
}

}  // namespace harmos::mesh
