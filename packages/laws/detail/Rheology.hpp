#pragma once

#include <array>
#include <string>

#include <harmos/laws/detail/BuiltIn.hpp>

namespace harmos::laws {

/// What laws of glue share that consist of a spring and a dashpot along the normal, and one of each along the surface.
/// History: three lengths.
struct Rheology {
  static constexpr int historySize = 3;
  static constexpr Sides sides = Sides::any;
  static constexpr bool dissipates = true;
  static constexpr bool isSmooth = true;

  /// Declares its parameters; `spring` and `dashpot` say what they do in the law.
  static void describe(input::ParameterSpec& p, const std::string& spring, const std::string& dashpot) {
    for (const std::string along : {"Normal", "Tangential"}) {
      p.number(along + " Stiffness").example("1000").unit("stress/length").required().above(0.0).doc(spring);
      p.number(along + " Viscosity").example("500").unit("stress time/length").required().above(0.0).doc(dashpot);
    }
  }

  explicit Rheology(const input::Parameters& p)
      : stiffness{p.number("Normal Stiffness"), p.number("Tangential Stiffness"), p.number("Tangential Stiffness")},
        viscosity{p.number("Normal Viscosity"), p.number("Tangential Viscosity"), p.number("Tangential Viscosity")} {}

  /// They carry whatever is asked for.
  static AdmissibleTractions admissibleTractions(int /*step*/) { return {}; }

  std::array<double, 3> stiffness;  ///< k_n, k_t, k_t [stress/length]
  std::array<double, 3> viscosity;  ///< eta_n, eta_t, eta_t [stress time/length]
};

}  // namespace harmos::laws
