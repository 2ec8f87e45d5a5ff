#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/SpringLaw.hpp>

namespace harmos::laws {
namespace {

/// Elastic foundation of an outer boundary (Winkler): f_n = -k_n w_n, f_t = -k_t w_t.
struct ElasticFoundation : SpringLaw {
  static constexpr const char* name = "Elastic Foundation";
  static constexpr Sides sides = Sides::one;

  static void describe(input::ParameterSpec& p) {
    p.summary("Springs from an outer boundary to the ground: f_n = -k_n w_n, f_t = -k_t w_t.")
        .source("Winkler's foundation");
    p.equation("f_n = -k_n w_n, f_t = -k_t w_t");
    p.number("Normal Stiffness")
        .example("100")
        .unit("stress/length")
        .required()
        .atLeast(0.0)
        .varying()
        .doc("k_n per area.");
    p.number("Tangential Stiffness")
        .unit("stress/length")
        .defaultValue(0.0)
        .atLeast(0.0)
        .varying()
        .doc("k_t per area.");
  }

  using SpringLaw::SpringLaw;
};

}  // namespace

HARMOS_INTERFACE_LAW(ElasticFoundation)

}  // namespace harmos::laws
