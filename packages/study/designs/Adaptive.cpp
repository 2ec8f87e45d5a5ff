#include <harmos/design/AdaptiveDesign.hpp>
#include <harmos/study/detail/DesignRegistry.hpp>

namespace harmos::study {
namespace {

/// Points that are chosen as results come, for the surface of a response.
struct Adaptive {
  static constexpr const char* name = "Adaptive";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Chooses its points itself until the surface of one response is known to a tolerance over the box of the free "
        "parameters, which may set laws and loads only.");
    p.text("Response").required().doc("Name of an entry of the study's Responses.");
    p.number("Tolerance")
        .unit("-")
        .defaultValue(1e-2)
        .above(0.0)
        .below(1.0)
        .doc("Largest error of the surface, at 95 % confidence, relative to the largest value of the response.");
    p.integer("Initial Count")
        .defaultValue(0)
        .atLeast(0)
        .atMost(design::mostConfigurations)
        .doc("Points to begin with; 0: twice as many as a quadratic polynomial has terms.");
    p.integer("Maximum Count").defaultValue(200).atLeast(1).atMost(design::mostConfigurations).doc("Most points.");
    p.integer("Seed").defaultValue(0).doc("0: plain Sobol' sequences; else with a random digital shift.");
  }

  static StudyDesign read(const input::Parameters& p) {
    AdaptiveOptions options;
    options.response = p.text("Response");
    options.refinement.tolerance = p.number("Tolerance");
    options.refinement.initialCount = p.integer("Initial Count");
    options.refinement.maximumCount = p.integer("Maximum Count");
    options.refinement.seed = p.integer("Seed");
    StudyDesign design;
    design.points = std::make_shared<const design::AdaptiveDesign>(options.refinement);
    design.options = std::move(options);
    return design;
  }
};

}  // namespace

HARMOS_DESIGN(Adaptive)

}  // namespace harmos::study
