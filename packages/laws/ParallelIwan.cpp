#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/SlipElements.hpp>

namespace harmos::laws {
namespace {

/// Parallel Iwan model: Jenkins elements beside each other, which let go one after the other, see SlipElements.
/// Source: Iwan, On a class of models for the yielding behavior of continuous and composite systems (1967).
struct ParallelIwan : SlipElements {
  static constexpr const char* name = "Parallel Iwan";
  static constexpr Sides sides = Sides::any;

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Jenkins elements in parallel along the surface, springs in series with sliders, which let go one after the "
         "other: micro-slip of a joint.")
        .source("Iwan (1967)");
    p.equation("t_t = k_0 delta_t + sum of k_i (delta_t - s_i), |k_i (delta_t - s_i)| <= tau_i");
    p.numbers("Stiffnesses")
        .example("{500, 300, 200}")
        .unit("stress/length")
        .required()
        .above(0.0)
        .overSurface()
        .doc("k_i of the springs.");
    p.numbers("Slip Limits")
        .example("{1, 2, 4}")
        .unit("stress")
        .required()
        .above(0.0)
        .overSurface()
        .doc("tau_i of the sliders, as many.");
    p.number("Residual Stiffness")
        .unit("stress/length")
        .defaultValue(0.0)
        .atLeast(0.0)
        .doc("Of a spring beside them that does not slide.");
    NormalSpring::describe(p);
  }

  static void check(const input::Parameters& p, input::ErrorList& errors) {
    const std::size_t springs = p.numbers("Stiffnesses").size(), sliders = p.numbers("Slip Limits").size();
    if (springs == sliders && springs > 0) return;
    errors.add(p.where("Slip Limits"),
               std::to_string(springs) + " stiffnesses and " + std::to_string(sliders) + " slip limits are given.",
               "Give one of each per element.");
  }

  explicit ParallelIwan(const input::Parameters& p)
      : SlipElements(NormalSpring(p), p.numbers("Stiffnesses"), p.numbers("Slip Limits"),
                     p.number("Residual Stiffness")) {}
};

}  // namespace

HARMOS_INTERFACE_LAW(ParallelIwan)

}  // namespace harmos::laws
