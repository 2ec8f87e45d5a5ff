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
/// body2 = -1 and no node2. Sign: jump = w2 - w1, n from side 1 to side 2, t = f1 = -f2.
struct Interface {
  std::string name;  ///< several pieces may share a name when METIS has cut the parts that they join
  std::shared_ptr<const laws::InterfaceLaw> law;
  int body1 = -1;
  int body2 = -1;
  std::vector<int> node1;
  std::vector<int> node2;
  std::vector<base::Frame> frame;     ///< per pair: rows n, t1, t2
  std::vector<double> area;           ///< per pair: lumped interface mass h [area], > 0
  std::vector<double> gap;            ///< per pair: geometric opening [length]
  std::vector<mesh::MassEntry> mass;  ///< consistent interface mass, both triangles; empty: lumped

  int pairs() const { return static_cast<int>(node1.size()); }
  int sides() const { return body2 < 0 ? 1 : 2; }
  int body(int side) const { return side == 0 ? body1 : body2; }
  const std::vector<int>& nodes(int side) const { return side == 0 ? node1 : node2; }
};

}  // namespace harmos::assembly
