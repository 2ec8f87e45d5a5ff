#include <cmath>

#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/SlipElements.hpp>

namespace harmos::laws {
namespace {

// Ratio of the widths of successive elements: narrow where a joint begins to slip.
constexpr double growth = 1.2;

/// Segalman's four-parameter Iwan model: sliders with the strengths phi, of which there are R phi^chi up to phi_max,
/// and S at phi_max, in the unit of a jump.
///
/// Small amplitudes u lose 4 R u^(3 + chi) / ((2 + chi) (3 + chi)) in a cycle. F_S, K_T, chi and beta = S phi_max^(-chi
/// - 1) (chi + 1) / R determine R, S and phi_max. The distribution is cut into pieces that grow like a geometric series
/// with phi, each an element with the stiffness and the strength of its piece, so that F_S and K_T are exact.
/// Source: Segalman, A four-parameter Iwan model for lap-type joints (2005), J. Appl. Mech. 72, 752-760.
struct FourParameterIwan : SlipElements {
  static constexpr const char* name = "Four-Parameter Iwan";
  static constexpr Sides sides = Sides::any;

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Micro-slip and macro-slip of a lap joint after Segalman: Jenkins elements with strengths distributed by a "
         "power law; small amplitudes lose energy like u^(3 + chi) per cycle.")
        .source("Segalman (2005), J. Appl. Mech. 72, 752-760");
    p.equation("t_t = integral of rho(phi) (delta_t - s_phi) dphi, |delta_t - s_phi| <= phi, rho = R phi^chi");
    p.number("Slip Limit").example("5").unit("stress").required().above(0.0).doc("F_S, traction at which all slides.");
    p.number("Tangential Stiffness")
        .example("1000")
        .unit("stress/length")
        .required()
        .above(0.0)
        .doc("K_T before anything slides.");
    p.number("Exponent").example("-0.5").unit("-").required().above(-1.0).atMost(0.0).doc("chi of the power law.");
    p.number("Ratio").unit("-").defaultValue(0.0).atLeast(0.0).doc(
        "beta, of the stiffness that goes at once at macro-slip to that which goes before.");
    p.integer("Elements").defaultValue(30).atLeast(1).atMost(200).doc("Into how many the distribution is cut.");
    NormalSpring::describe(p);
  }

  explicit FourParameterIwan(const input::Parameters& p) : SlipElements(elements(p)) {}

  static SlipElements elements(const input::Parameters& p) {
    const double strength = p.number("Slip Limit"), stiffness = p.number("Tangential Stiffness");
    const double chi = p.number("Exponent"), beta = p.number("Ratio");
    const int count = p.integer("Elements");
    const double sum = beta + (chi + 1.0) / (chi + 2.0);
    const double reach = strength * (1.0 + beta) / (stiffness * sum);  // phi_max
    const double powerStiffness = stiffness / (1.0 + beta);            // R phi_max^(chi + 1) / (chi + 1)
    std::vector<double> stiffnesses, strengths;
    double below = 0.0;
    for (int i = 1; i <= count; ++i) {
      // phi / phi_max at the end of the piece.
      const double above = i == count ? 1.0 : std::expm1(i * std::log(growth)) / std::expm1(count * std::log(growth));
      stiffnesses.push_back(powerStiffness * (std::pow(above, chi + 1.0) - std::pow(below, chi + 1.0)));
      strengths.push_back(powerStiffness * reach * (chi + 1.0) / (chi + 2.0) *
                          (std::pow(above, chi + 2.0) - std::pow(below, chi + 2.0)));
      below = above;
    }
    if (beta > 0.0) {
      stiffnesses.push_back(powerStiffness * beta);
      strengths.push_back(powerStiffness * beta * reach);
    }
    return {NormalSpring(p), std::move(stiffnesses), std::move(strengths), 0.0};
  }
};

}  // namespace

HARMOS_INTERFACE_LAW(FourParameterIwan)

}  // namespace harmos::laws
