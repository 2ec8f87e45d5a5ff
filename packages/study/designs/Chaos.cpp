#include <harmos/study/detail/DesignRegistry.hpp>

namespace harmos::study {
namespace {

/// Expansions that are solved for.
struct Chaos {
  static constexpr const char* name = "Chaos";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "All fields expanded on orthonormal polynomials of the random parameters, and solved at once: the coefficients "
        "are right-hand sides of the constant operators. Random parameters may set laws and loads only.");
    addOrder(p);
    p.source("Champaney, Blanze, Boucard (2004), section 4; Ghanem, Spanos (1991)");
    p.text("Local Stage")
        .defaultValue("Automatic")
        .oneOf({"Automatic", "Galerkin", "Pseudo-Spectral"})
        .doc(
            "Galerkin: the residual of every law is orthogonal to the polynomials; affine laws only. Pseudo-Spectral: "
            "laws at Gauss points, projected; any law. Automatic: Galerkin where all laws are affine, unless it is "
            "much "
            "dearer; harmos check says which and why.");
    p.number("Tolerance")
        .unit("-")
        .optional()
        .above(0.0)
        .below(1.0)
        .doc(
            "Raise the order from 1 until the standard deviation of the Response changes by less, relative to itself; "
            "Order is then the highest that is tried.");
    p.text("Response").optional().doc("Which response chooses the order; absent: all of them.");
  }

  static StudyDesign read(const input::Parameters& p) {
    ChaosOptions options;
    options.order = p.integer("Order");
    options.points = p.integer("Points");
    options.holdOuts = readHoldOuts(p);
    const std::string& stage = p.text("Local Stage");
    using LocalStage = ChaosOptions::LocalStage;
    options.localStage = stage == "Galerkin"          ? LocalStage::galerkin
                         : stage == "Pseudo-Spectral" ? LocalStage::pseudoSpectral
                                                      : LocalStage::automatic;
    if (p.has("Tolerance")) options.tolerance = p.number("Tolerance");
    if (p.has("Response")) options.response = p.text("Response");
    StudyDesign design;
    design.options = std::move(options);
    return design;
  }
};

}  // namespace

HARMOS_DESIGN(Chaos)

}  // namespace harmos::study
