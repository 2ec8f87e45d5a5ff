#include <harmos/study/detail/DesignRegistry.hpp>

namespace harmos::study {
namespace {

/// Piecewise linear interpolation over random parameters.
struct AdaptiveCollocation {
  static constexpr const char* name = "Adaptive Collocation";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Piecewise linear interpolation, refined where the response bends: for contact and friction, whose kinks no "
        "polynomial follows. One to three random parameters.");
    p.source("Ma, Zabaras, J. Comput. Phys. 228 (2009)");
    p.text("Response").optional().doc("Which response chooses the points; absent: all of them.");
    p.number("Tolerance")
        .unit("-")
        .defaultValue(1e-3)
        .above(0.0)
        .below(1.0)
        .doc("Error of mean and standard deviation to stop at, relative to the standard deviation.");
    p.integer("Maximum Count")
        .defaultValue(500)
        .atLeast(3)
        .atMost(design::mostConfigurations)
        .doc("Most configurations.");
    addHoldOuts(p, "interpolation");
  }

  static StudyDesign read(const input::Parameters& p) {
    InterpolationOptions options;
    if (p.has("Response")) options.response = p.text("Response");
    options.tolerance = p.number("Tolerance");
    options.largestCount = p.integer("Maximum Count");
    options.holdOuts = readHoldOuts(p);
    StudyDesign design;
    design.options = std::move(options);
    return design;
  }
};

}  // namespace

HARMOS_DESIGN(AdaptiveCollocation)

}  // namespace harmos::study
