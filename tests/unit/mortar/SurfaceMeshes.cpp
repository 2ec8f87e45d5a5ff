#include "SurfaceMeshes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace harmos::mortar {
namespace {

/// Makes nodes on a grid with twice as many cells, so that those between corners are on it.
class GridNodes {
 public:
  GridNodes(mesh::Mesh& mesh, const Grid& grid) : mesh_(mesh), grid_(grid) {}

  int at(int i, int j) {
    const auto [entry, isNew] = number_.try_emplace({i, j}, static_cast<int>(mesh_.nodes.size()));
    if (isNew) mesh_.nodes.push_back(place(i, j));
    return entry->second;
  }

 private:
  base::Vector3 place(int i, int j) {
    const bool isCorner = i % 2 == 0 && j % 2 == 0;
    if (isCorner || grid_.hasCurvedEdges) return grid_.map(coordinate(i, j, 0), coordinate(i, j, 1));
    // Half-way between corners; in the middle of a cell the mean of all four, of triangles of the two on the diagonal.
    const bool isOnDiagonal = grid_.nodesPerFace == 6;
    base::Vector3 sum{};
    double count = 0.0;
    for (int a = i - i % 2; a <= i + i % 2; a += 2) {
      for (int b = j - j % 2; b <= j + j % 2; b += 2) {
        if (isOnDiagonal && i % 2 == 1 && j % 2 == 1 && (a < i) != (b < j)) continue;
        sum = sum + grid_.map(coordinate(a, b, 0), coordinate(a, b, 1));
        count += 1.0;
      }
    }
    return (1.0 / count) * sum;
  }

  double coordinate(int i, int j, int d) const {
    const int cells = d == 0 ? grid_.first : grid_.second, position = d == 0 ? i : j;
    const bool isInside = i > 0 && i < 2 * grid_.first && j > 0 && j < 2 * grid_.second;
    double moved = 0.0;
    if (isInside && i % 2 == 0 && j % 2 == 0) {
      std::mt19937 random(static_cast<unsigned>(1000 * i + 10 * j + d));
      moved = grid_.distortion * (static_cast<double>(random() % 2001) / 1000.0 - 1.0);
    }
    return (0.5 * position + moved) / cells;
  }

  mesh::Mesh& mesh_;
  const Grid& grid_;
  std::map<std::pair<int, int>, int> number_;
};

/// Offsets of nodes from the corner of a cell, in halves of its size, in the order of the face.
std::vector<std::vector<std::pair<int, int>>> facesOfCell(int nodesPerFace) {
  std::vector<std::pair<int, int>> quadrilateral = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0},
                                                    {2, 1}, {1, 2}, {0, 1}, {1, 1}};
  if (nodesPerFace == 3 || nodesPerFace == 6) {
    std::vector<std::pair<int, int>> lower = {{0, 0}, {2, 0}, {2, 2}, {1, 0}, {2, 1}, {1, 1}};
    std::vector<std::pair<int, int>> upper = {{0, 0}, {2, 2}, {0, 2}, {1, 1}, {1, 2}, {0, 1}};
    lower.resize(static_cast<std::size_t>(nodesPerFace));
    upper.resize(static_cast<std::size_t>(nodesPerFace));
    return {lower, upper};
  }
  quadrilateral.resize(static_cast<std::size_t>(nodesPerFace));
  return {quadrilateral};
}

/// The other way round: corners from the first one on backwards, nodes of edges with them.
void reverse(std::vector<int>& nodes, int corners) {
  std::reverse(nodes.begin() + 1, nodes.begin() + corners);
  const auto mids = std::min<std::size_t>(nodes.size(), static_cast<std::size_t>(2 * corners));
  std::reverse(nodes.begin() + corners, nodes.begin() + static_cast<std::ptrdiff_t>(mids));
}

}  // namespace

Side meshGrid(mesh::Mesh& mesh, const std::string& name, const Grid& grid) {
  GridNodes nodes(mesh, grid);
  Side side;
  side.name = name;
  if (mesh.dimension == 2) {
    for (int i = 0; i < grid.first; ++i) {
      mesh::Face& face = side.faces.emplace_back();
      face.nodes = {nodes.at(2 * i, 0), nodes.at(2 * i + 2, 0)};
      if (grid.isReversed) std::swap(face.nodes[0], face.nodes[1]);
      if (grid.nodesPerFace == 3) face.nodes.push_back(nodes.at(2 * i + 1, 0));
    }
    return side;
  }
  const int corners = grid.nodesPerFace == 3 || grid.nodesPerFace == 6 ? 3 : 4;
  for (int i = 0; i < grid.first; ++i) {
    for (int j = 0; j < grid.second; ++j) {
      for (const auto& offsets : facesOfCell(grid.nodesPerFace)) {
        mesh::Face& face = side.faces.emplace_back();
        for (const auto& [a, b] : offsets) face.nodes.push_back(nodes.at(2 * i + a, 2 * j + b));
        if (grid.isReversed) reverse(face.nodes, corners);
      }
    }
  }
  return side;
}

Grid::Map plane(double height) {
  return rectangle(0.0, 0.0, 1.0, 1.0, height);
}

Grid::Map rectangle(double x0, double y0, double x1, double y1, double height) {
  return [=](double a, double b) { return base::Vector3{x0 + a * (x1 - x0), y0 + b * (y1 - y0), height}; };
}

Grid::Map turned(const Grid::Map& map) {
  return [map](double a, double b) {
    const base::Vector3 axis = (1.0 / std::sqrt(14.0)) * base::Vector3{1.0, 2.0, 3.0};
    const base::Vector3 x = map(a, b);
    const double c = std::cos(0.7), s = std::sin(0.7);
    return c * x + s * cross(axis, x) + (1.0 - c) * dot(axis, x) * axis + base::Vector3{0.3, -1.1, 2.0};
  };
}

}  // namespace harmos::mortar
