#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/ElasticSlider.hpp>

namespace harmos::laws {
namespace {

/// Jenkins element: a spring in series with a slider of constant strength, |t_t| <= tau, t_t = k_t (delta_t - s).
/// Source: Iwan, On a class of models for the yielding behavior of continuous and composite systems (1967).
struct Jenkins : ElasticSlider {
  static constexpr const char* name = "Jenkins";

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Jenkins element along the surface: a spring in series with a slider of constant strength, whatever the "
         "pressure: t_t = k_t (delta_t - s), |t_t| <= tau.")
        .source("Iwan (1967); Gaul, Nitsche (2001), section 3.2");
    p.equation("t_t = k_t (delta_t - s), |t_t| <= tau");
    p.number("Tangential Stiffness")
        .example("1000")
        .unit("stress/length")
        .required()
        .above(0.0)
        .doc("k_t of the spring.");
    p.number("Slip Limit").example("5").unit("stress").required().atLeast(0.0).doc("tau, at which the slider moves.");
    NormalSpring::describe(p);
  }

  explicit Jenkins(const input::Parameters& p)
      : ElasticSlider(NormalSpring(p), 1.0 / p.number("Tangential Stiffness"), {p.number("Slip Limit"), 0.0, 0.0}) {}
};

}  // namespace

HARMOS_INTERFACE_LAW(Jenkins)

}  // namespace harmos::laws
