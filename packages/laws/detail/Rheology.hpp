#pragma once

#include <array>
#include <string>

#include <harmos/laws/detail/BuiltIn.hpp>

namespace harmos::laws {

/// A spring and a dashpot along the normal, and another one of each along the surface.
struct Rheology {
  /// Declares its parameters; `spring` and `dashpot` say what they do in the law.
  static void describe(input::ParameterSpec& p, const std::string& spring, const std::string& dashpot) {
    for (const std::string along : {"Normal", "Tangential"}) {
      p.number(along + " Stiffness").unit("stress/length").required().above(0.0).doc(spring);
      p.number(along + " Viscosity").unit("stress time/length").required().above(0.0).doc(dashpot);
    }
  }

  explicit Rheology(const input::Parameters& p)
      : stiffness{p.number("Normal Stiffness"), p.number("Tangential Stiffness"), p.number("Tangential Stiffness")},
        viscosity{p.number("Normal Viscosity"), p.number("Tangential Viscosity"), p.number("Tangential Viscosity")} {}

  std::array<double, 3> stiffness;  ///< k_n, k_t, k_t [stress/length]
  std::array<double, 3> viscosity;  ///< eta_n, eta_t, eta_t [stress time/length]
};

}  // namespace harmos::laws
