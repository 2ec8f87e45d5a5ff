#pragma once

#include <string>
#include <vector>

#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/TraceOperator.hpp>

namespace harmos::mesh {

/// One entry of the consistent interface mass, int N_row N_column dS [length^2; in 2-D length times thickness].
struct MassEntry {
  int row = 0;         // pair number
  int column = 0;      // pair number
  double value = 0.0;  // in the unit above
};

/// Geometry of one interface between two pieces, or between one piece and the ground (outer boundary).
///
/// Pair p is a point of the surface, and trace1 and trace2 say what it feels of the local nodes of piece1 and piece2:
/// where the meshes match, it joins one node of each. Where the surface turns at a crease, a pair of nodes occurs once
/// for every smooth patch of faces around it, each with the area and the normal of its own faces. n is the unit normal
/// from side 1 to side 2, on a boundary out of the part, and the x axis where there is none, such as at inner nodes;
/// x1, x2 are coordinates.
struct InterfaceSurface {
  std::string name;                     // of the interface it belongs to
  int piece1 = -1;                      // index into the list of pieces
  int piece2 = -1;                      // -1: outer boundary, one side only
  TraceOperator trace1;                 // pairs x local nodes of piece1
  TraceOperator trace2;                 // the same of piece2; no points for an outer boundary
  std::vector<base::Vector3> position;  // per pair, its place [length], of two nodes that of side 1
  std::vector<int> patch;               // per pair, patch of its nodes from 0, the same in all surfaces of an interface
  std::vector<base::Frame> frame;       // per pair, n the direction of `normal`
  std::vector<base::Vector3> normal;    // per pair, NodalWeight::normal; with a projection, which n then is, area n
  std::vector<double> area;             // per pair, NodalWeight::area [length^2; in 2-D length times thickness], > 0
  std::vector<base::Vector3> flux;      // per pair of a boundary, NodalWeight::flux [as area]; of others may be empty
  std::vector<double> share;            // the same of NodalWeight::share
  std::vector<double> gap;              // per pair, (x2 - x1).n [length]; 0 without a projection
  std::vector<std::vector<int>> face;  // pair numbers of each face in the node order of side 1, or of the side that has
                                       // it; empty for single nodes
  /// Per pair where the meshes do not match, else empty: its number in the whole interface. Where several surfaces have
  /// the same one, all but one of them are copies: with area 0 and without entries in the trace operators.
  std::vector<int> point;
  /// Both triangles, by row and column; its row sums are area as it was found. Empty for single nodes, and where the
  /// faces of both sides differ.
  std::vector<MassEntry> mass;

  /// How many pairs there are.
  int pairs() const { return trace1.points(); }
};

}  // namespace harmos::mesh
