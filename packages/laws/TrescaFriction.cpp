#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/ContactTraction.hpp>
#include <harmos/laws/detail/SlidingLaw.hpp>

namespace harmos::laws {
namespace {

/// Unilateral contact with given friction: |t_t| <= tau whatever the pressure, also where the sides are apart.
///
/// So the tangential part knows nothing of the normal one, and the law is monotone: there is one solution only.
/// Source: Duvaut, Lions: Les inequations en mecanique et en physique (1972), chapter III.
struct TrescaFriction : SlidingLaw {
  static constexpr const char* name = "Tresca Friction";

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Unilateral contact with given friction: |t_t| <= tau whatever the pressure, also where the sides are apart.")
        .source("Duvaut, Lions (1972), chapter III");
    p.equation("opening >= 0, t_n <= 0, their product 0; |t_t| <= tau");
    p.number("Shear Limit")
        .example("5")
        .unit("stress")
        .required()
        .atLeast(0.0)
        .varying()
        .doc("tau, at which the sides slide.");
    p.number("Gap").unit("length").defaultValue(0.0).varying().doc(
        "Opening of the undeformed surfaces beyond their geometric distance; negative is interference.");
  }

  explicit TrescaFriction(const input::Parameters& p) : limit(p.schedule("Shear Limit")), gap(p.schedule("Gap")) {}

  double shearLimit(const NodeContext& at, const base::Vector3& /*traction*/) const { return limit[at.step]; }

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const double normal = contactTraction(line.freeJump[0] + at.gap + gap[at.step], line.compliance);
    const SlipState slip = slipOnLine(line, 0.0, SlipMemory::slip(old), {limit[at.step], 0.0, 0.0});
    SlipMemory::keep(slip.slip, slip.distance, old, now);
    return {{normal, slip.traction.t1, slip.traction.t2}, slip.slides ? Status::slip : Status::stick};
  }

  input::Schedule limit;
  input::Schedule gap;
};

}  // namespace

HARMOS_INTERFACE_LAW(TrescaFriction)

}  // namespace harmos::laws
