#pragma once

#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/laws/LocalLine.hpp>

namespace harmos::laws {

/// What laws that are about sliding do along the normal: a spring or rigid, and bonded or free to open. The tangential
/// part knows nothing of it.
struct NormalSpring {
  /// Declares its parameters.
  static void describe(input::ParameterSpec& p) {
    p.number("Normal Stiffness").unit("stress/length").optional().above(0.0).doc("k_n; absent: rigid.");
    p.flag("Opens").defaultValue(false).doc("Whether the sides part instead of carrying tension.");
  }

  explicit NormalSpring(const input::Parameters& p)
      : compliance(p.has("Normal Stiffness") ? 1.0 / p.number("Normal Stiffness") : 0.0), opens(p.flag("Opens")) {}

  /// t_n [stress] on a line; `gap` counts only where the sides can part.
  double traction(const LocalLine& line, double gap) const {
    const double opening = line.freeJump[0] + (opens ? gap : 0.0);
    return opens && opening >= 0.0 ? 0.0 : opening / (line.compliance + compliance);
  }
  /// t_n^2 / (2 k_n) [stress length].
  double energy(double traction) const { return 0.5 * compliance * traction * traction; }

  double compliance;  ///< 1 / k_n [length/stress], or 0
  bool opens;         ///< no tension
};

}  // namespace harmos::laws
