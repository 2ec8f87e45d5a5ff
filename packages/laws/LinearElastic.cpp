#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/SpringLaw.hpp>

namespace harmos::laws {
namespace {

/// Linear elastic joint (glue): t_n = k_n delta_n, t_t = k_t delta_t.
/// A layer of thickness e, modulus E and ratio nu has k_n = E/e, k_t = E / (2 (1 + nu) e).
/// Source: Champaney, Blanze, Boucard (2004), section 4.2.
struct LinearElastic : SpringLaw {
  static constexpr const char* name = "Linear Elastic";
  static constexpr Sides sides = Sides::two;

  static void describe(input::ParameterSpec& p) {
    p.summary("Linear elastic joint (glue): traction = stiffness times jump.")
        .source("Champaney, Blanze, Boucard (2004), section 4.2");
    p.equation("t_n = k_n delta_n, t_t = k_t delta_t");
    p.number("Normal Stiffness")
        .example("1000")
        .unit("stress/length")
        .required()
        .atLeast(0.0)
        .varying()
        .doc("k_n; a glue layer of modulus E and thickness e has E/e.");
    p.number("Tangential Stiffness")
        .example("400")
        .unit("stress/length")
        .required()
        .atLeast(0.0)
        .varying()
        .doc("k_t; a glue layer has E / (2 (1 + nu) e).");
  }

  using SpringLaw::SpringLaw;
};

}  // namespace

HARMOS_INTERFACE_LAW(LinearElastic)

}  // namespace harmos::laws
