#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/laws/InterfaceLaw.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>

namespace harmos::assembly {

/// An interface: a mechanical object of its own, with a law and unknowns on one or two sides.
///
/// Pair p joins node1[p] of substructure body1 and node2[p] of body2, local node numbers. An outer boundary has
/// body2 = -1 and no node2. Sign: jump = w2 - w1 [length], n from side 1 to side 2 (out of body1), t = f1 = -f2
/// [stress], so t.n < 0 is compression. At a crease of the surface the same nodes are several pairs, one for each
/// smooth patch, with frames and areas of their own. All vectors per pair have pairs() entries.
struct Interface {
  std::string name;  ///< several pieces may share a name when METIS has cut the parts that they join
  std::shared_ptr<const laws::InterfaceLaw> law;  ///< never null; interfaces may share one
  int body1 = -1;                                 ///< index into Assembly::bodies
  int body2 = -1;                                 ///< the same; -1: boundary
  std::vector<int> node1;                         ///< per pair: node of body1, counted from 0
  std::vector<int> node2;                         ///< per pair: node of body2, counted from 0; empty on a boundary
  std::vector<base::Frame> frame;                 ///< per pair: rows n, t1, t2
  /// Per pair: lumped interface mass h [length^2; in 2-D length times thickness], > 0; where the law prescribes its
  /// traction in the frame, the length of int N n dS, so that a pressure acts along the normals of the faces.
  std::vector<double> area;
  std::vector<double> gap;            ///< per pair: geometric opening (x2 - x1).n [length]; 0 on a boundary
  std::vector<mesh::MassEntry> mass;  ///< consistent interface mass [as area], both triangles; empty: lumped

  /// How many pairs there are; on a boundary nodes.
  int pairs() const { return static_cast<int>(node1.size()); }
  /// 1 on a boundary, 2 otherwise.
  int sides() const { return body2 < 0 ? 1 : 2; }
  /// Body of a side; side 1 is 0, side 2 is 1.
  int body(int side) const { return side == 0 ? body1 : body2; }
  /// Nodes of a side, one per pair; owned by the interface.
  const std::vector<int>& nodes(int side) const { return side == 0 ? node1 : node2; }
};

}  // namespace harmos::assembly
