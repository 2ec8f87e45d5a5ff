#pragma once

#include <functional>
#include <string>

#include <harmos/mortar/JoinSurfaces.hpp>

namespace harmos::mortar {

/// A surface (in 2-D a line) that is meshed by a grid of faces.
struct Grid {
  using Map = std::function<base::Vector3(double, double)>;  // of [0, 1]^2

  int nodesPerFace = 4;  // 2, 3 in 2-D; 3, 4, 6, 8, 9 in 3-D
  int first = 1;         // faces (pairs of triangles) along the first coordinate
  int second = 1;        // along the second one; 1 in 2-D
  Map map;
  bool isReversed = false;      // normals along -(d map/d1 x d map/d2); in 2-D to the left of the line
  bool hasCurvedEdges = false;  // nodes between corners lie where the map says, not half-way
  double distortion = 0.0;      // of corners inside, over the size of a cell
};

/// Adds nodes to the mesh, whose dimension counts, and returns the faces.
Side meshGrid(mesh::Mesh& mesh, const std::string& name, const Grid& grid);

/// The unit square in z = height, and in 2-D the unit line in y = height.
Grid::Map plane(double height = 0.0);
/// The rectangle between two corners, in z = height.
Grid::Map rectangle(double x0, double y0, double x1, double y1, double height = 0.0);
/// Of `map` turned about the axis (1, 2, 3) by 0.7, and moved.
Grid::Map turned(const Grid::Map& map);

}  // namespace harmos::mortar
