#pragma once

#include <harmos/base/Vector3.hpp>

namespace harmos::laws {

/// What the ascent search direction leaves to a law at one interface node: jump = freeJump - compliance * traction.
///
/// Eliminating both sides with E+ (f^ - f = k (w^ - w)) and interface equilibrium (f1^ + f2^ = 0) gives
///   delta^ = delta_free - H t,   delta_free = (w2 - w1) + f1/k1 - f2/k2,   H = 1/k1 + 1/k2,
/// with t = f1^ = -f2^, k1 and k2 the search directions of the sides [stress/length]. On an outer boundary side 2 is
/// the ground at rest: delta_free = -w1 + f1/k1, H = 1/k1.
struct LocalLine {
  base::Vector3 freeJump{};  ///< delta_free [length], components in the law's frame
  double compliance = 0.0;   ///< H [length/stress], > 0

  /// The jump delta^ [length] that belongs to a traction t [stress] on this line.
  base::Vector3 jump(const base::Vector3& traction) const {
    return {freeJump[0] - compliance * traction[0], freeJump[1] - compliance * traction[1],
            freeJump[2] - compliance * traction[2]};
  }
};

/// What a pair does; written to Exodus as the variable `contact_status`.
///
/// open: the sides are apart. stick: in contact, without sliding over the load step. slip: in contact, sliding or free
/// to slide. bonded: joined, by springs too; also all of a law that knows no states. broken: was bonded.
enum class Status { open = 0, stick = 1, slip = 2, bonded = 3, broken = 4 };

/// A point of the law's graph: the traction, and the status that goes with it.
struct LocalState {
  base::Vector3 traction{};        ///< t = f1^ = -f2^ on side 1 [stress], in the law's frame; t_n < 0 is compression
  Status status = Status::bonded;  ///< of the pair at the end of the load step
};

}  // namespace harmos::laws
