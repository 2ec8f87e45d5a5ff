#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/ElasticSlider.hpp>

namespace harmos::laws {
namespace {

/// Tangential elastoplasticity with linear isotropic and kinematic hardening, see ElasticSlider.
/// Source: Simo, Hughes, Computational Inelasticity (1998), sections 1.5 and 1.6, for a vector along the surface.
struct TangentialPlasticity : ElasticSlider {
  static constexpr const char* name = "Tangential Plasticity";

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Elastoplastic joint along the surface with linear hardening: t_t = k_t (delta_t - s), |t_t - h_k s| <= tau + "
         "h_i p, s along t_t - h_k s, p the length of its way.")
        .source("Simo, Hughes (1998), sections 1.5 and 1.6");
    p.equation("t_t = k_t (delta_t - s), |t_t - h_k s| <= tau + h_i times the way of s");
    p.number("Tangential Stiffness")
        .example("1000")
        .unit("stress/length")
        .required()
        .above(0.0)
        .doc("k_t of the spring.");
    p.number("Yield Stress")
        .example("5")
        .unit("stress")
        .required()
        .atLeast(0.0)
        .doc("tau of the joint that has not yielded yet.");
    p.number("Isotropic Hardening")
        .unit("stress/length")
        .defaultValue(0.0)
        .atLeast(0.0)
        .doc("h_i, growth of the yield stress by the way of the slip.");
    p.number("Kinematic Hardening")
        .unit("stress/length")
        .defaultValue(0.0)
        .atLeast(0.0)
        .doc("h_k, shift of the elastic range by the slip.");
    NormalSpring::describe(p);
  }

  explicit TangentialPlasticity(const input::Parameters& p)
      : ElasticSlider(NormalSpring(p), 1.0 / p.number("Tangential Stiffness"),
                      {p.number("Yield Stress"), p.number("Isotropic Hardening"), p.number("Kinematic Hardening")}) {}
};

}  // namespace

HARMOS_INTERFACE_LAW(TangentialPlasticity)

}  // namespace harmos::laws
