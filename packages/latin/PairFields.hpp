#pragma once

#include <vector>

#include <harmos/latin/Iterate.hpp>

namespace harmos::latin {

/// Local-stage fields of one interface in its nodes' frames (n, t1, t2), complete on every rank.
struct PairFields {
  int pairs = 0;                        ///< of the interface
  int steps = 0;                        ///< of the assembly
  std::vector<double> times;            ///< end of each load step [time]
  std::vector<base::Vector3> traction;  ///< t = f1^ [stress], steps x pairs
  std::vector<base::Vector3> jump;      ///< delta = w2 - w1 [length], steps x pairs; ground: -w1
  std::vector<laws::Status> status;     ///< steps x pairs

  /// Position of a load step and a pair, both from 0, in the lists; not checked.
  std::size_t at(int step, int pair) const {
    return static_cast<std::size_t>(step) * static_cast<std::size_t>(pairs) + static_cast<std::size_t>(pair);
  }
};

/// Collective. All load steps must be selected. Boundaries with prescribed traction have that traction, and the jump
/// -w1 of the linear stage.
PairFields pairFields(const Iterate& state, int interfaceIndex);

}  // namespace harmos::latin
