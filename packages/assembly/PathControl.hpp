#pragma once

#include <vector>

#include <harmos/base/Vector3.hpp>

namespace harmos::assembly {

/// Loads whose size is found instead of given, so that a joint opens as it is told to: path following by the opening of
/// a crack, which also follows paths along which loads and displacements turn back.
///
/// What the boundaries `loads` prescribe is multiplied by one load factor lambda [-] per load step, an unknown; the
/// equation for it is
///   sum over pairs of h weight.(w2 - w1) = value,
/// with the jump w2 - w1 [length] in global axes and the interface mass h [area].
struct PathControl {
  /// Share of an interface in what is controlled.
  struct Share {
    int interface = -1;                 ///< position in the assembly, of an interface with two sides
    std::vector<base::Vector3> weight;  ///< per pair [1/area], global components
  };
  /// Positions of boundaries. Their laws prescribe tractions, or hold displacements without springs, and what they
  /// prescribe is the same at all load steps.
  std::vector<int> loads;
  std::vector<Share> shares;   ///< of which the sum is controlled
  std::vector<double> values;  ///< at the end of every load step [length]

  /// Whether the load factor multiplies what a boundary prescribes.
  bool scales(int interface) const {
    for (const int load : loads) {
      if (load == interface) return true;
    }
    return false;
  }
};

}  // namespace harmos::assembly
