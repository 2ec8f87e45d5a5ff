#pragma once

#include <string>
#include <vector>

#include <harmos/mesh/Mesh.hpp>

namespace harmos::mesh {

/// One entry of the consistent interface mass, int N_row N_column dS [length^2; in 2-D length times thickness].
struct MassEntry {
  int row = 0;  // pair numbers
  int column = 0;
  double value = 0.0;
};

/// Geometry of one interface between two pieces, or between one piece and the ground (outer boundary).
///
/// Node pairs are conforming: pair p joins the local node node1[p] of piece1 and node2[p] of piece2.
struct InterfaceSurface {
  std::string name;                    // of the interface it belongs to
  int piece1 = -1;                     // index into the list of pieces
  int piece2 = -1;                     // -1: outer boundary, one side only
  std::vector<int> node1, node2;       // local node numbers in the pieces; node2 is empty for an outer boundary
  std::vector<base::Frame> frame;      // per pair, area-weighted mean of the faces' normals
  std::vector<double> area;            // per pair, int N dS [length^2; in 2-D length times thickness], > 0
  std::vector<double> gap;             // per pair, (x2 - x1).n [length], 0 where the nodes coincide
  std::vector<std::vector<int>> face;  // pair numbers of each face in the node order of side 1; empty for node sets
  std::vector<MassEntry> mass;         // both triangles, by row and column; its row sums are area; empty for node sets
};

}  // namespace harmos::mesh
