#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/laws/InterfaceLaw.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/TraceOperator.hpp>

namespace harmos::assembly {

/// An interface: a mechanical object of its own, with a law and unknowns on one or two sides.
///
/// It has points. At point p the sides move by w_s = B_s u_s [length], with the trace operators B of the bodies' nodes,
/// whose rows have the sum 1, and tractions f_s [stress] are the nodal forces B_s^T h f_s. An outer boundary has
/// body2 = -1 and no trace2. Sign: jump = w2 - w1 [length], n from side 1 to side 2 (out of body1), t = f1 = -f2
/// [stress], so t.n < 0 is compression. Where the meshes of both sides match, a point is a pair of nodes, and B selects
/// them; at a crease of the surface the same nodes are several pairs then, one for each smooth patch, with frames and
/// areas of their own. All vectors per pair have pairs() entries.
struct Interface {
  std::string name;  ///< several pieces may share a name when METIS has cut the parts that they join
  std::shared_ptr<const laws::InterfaceLaw> law;  ///< never null; interfaces may share one
  int body1 = -1;                                 ///< index into Assembly::bodies
  int body2 = -1;                                 ///< the same; -1: boundary
  mesh::TraceOperator trace1;                     ///< B_1, points x nodes of body1
  mesh::TraceOperator trace2;                     ///< B_2, points x nodes of body2; no points on a boundary
  std::vector<base::Vector3> position;            ///< per pair: undeformed place on the interface [length]
  std::vector<base::Frame> frame;                 ///< per pair: rows n, t1, t2
  /// Per pair: lumped interface mass h [length^2; in 2-D length times thickness], > 0. Where the law prescribes its
  /// traction, int N dS, which on quadratic faces may be 0 or negative; in the frame, the length of int N n dS with its
  /// sign along n, so that a pressure acts along the normals of the faces.
  std::vector<double> area;
  /// Per pair: geometric opening (x2 - x1).n [length]; on a boundary 0, or TurnedLaw::distanceBeyondMean() of its law.
  std::vector<double> gap;
  std::vector<mesh::MassEntry> mass;  ///< consistent interface mass [as area], both triangles; empty: lumped
  /// Laws of whole faces (CoupledLaw) take interfaces of one number together, the pieces of a face; -1: none besides.
  int face = -1;
  /// Between pieces of one part, joined perfectly: nothing that the problem has, so that its forces measure nothing.
  bool isCut = false;

  /// How many points there are.
  int pairs() const { return trace1.points(); }
  /// 1 on a boundary, 2 otherwise.
  int sides() const { return body2 < 0 ? 1 : 2; }
  /// Body of a side; side 1 is 0, side 2 is 1.
  int body(int side) const { return side == 0 ? body1 : body2; }
  /// B of a side, owned by the interface.
  const mesh::TraceOperator& trace(int side) const { return side == 0 ? trace1 : trace2; }
  /// What the law is told of all pairs at a load step, counted from 0 in `times`, the ends of the load steps in
  /// ascending order, of which several may be the same; the arrays are the interface's own. Lines, histories and states
  /// are left to the caller.
  laws::NodeArrays nodes(const std::vector<double>& times, int step) const;
  /// Asks the law at a load step; what nodes() gives, completed by the caller. Throws base::Error (notConverged), which
  /// names interface, load step and point, where it finds no point on a line.
  void solve(int step, const laws::NodeArrays& at) const;
};

}  // namespace harmos::assembly
