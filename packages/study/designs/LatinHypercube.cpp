#include <harmos/design/LatinHypercubeDesign.hpp>
#include <harmos/study/detail/DesignRegistry.hpp>

namespace harmos::study {
namespace {

/// Every stratum of every parameter once.
struct LatinHypercube {
  static constexpr const char* name = "Latin Hypercube";

  static void describe(input::ParameterSpec& p) {
    p.summary("Every parameter's range is cut into as many strata as there are points; each is hit once.");
    p.source("McKay, Beckman, Conover, Technometrics 21 (1979)");
    addCount(p);
    p.integer("Seed").defaultValue(1).doc("The same seed gives the same points everywhere.");
  }

  static StudyDesign read(const input::Parameters& p) {
    StudyDesign design;
    design.options = SamplingOptions{p.integer("Count")};
    design.points = std::make_shared<const design::LatinHypercubeDesign>(p.integer("Count"), p.integer("Seed"));
    return design;
  }
};

}  // namespace

HARMOS_DESIGN(LatinHypercube)

}  // namespace harmos::study
