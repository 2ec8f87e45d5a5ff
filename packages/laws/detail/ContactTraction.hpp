#pragma once

#include <harmos/laws/LocalLine.hpp>

namespace harmos::laws {

/// Normal traction t_n [stress] of unilateral contact on a line: t_n <= 0, opening >= 0, t_n * opening = 0.
///
/// `opening` [length] is the free opening delta_free_n + gap; `compliance` [length/stress] is that of the line.
inline double contactTraction(double opening, double compliance) {
  return opening >= 0.0 ? 0.0 : opening / compliance;
}

}  // namespace harmos::laws
