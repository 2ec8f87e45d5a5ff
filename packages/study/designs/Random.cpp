#include <harmos/design/RandomDesign.hpp>
#include <harmos/study/detail/DesignRegistry.hpp>

namespace harmos::study {
namespace {

/// Independent values.
struct Random {
  static constexpr const char* name = "Random";

  static void describe(input::ParameterSpec& p) {
    p.summary("Independent values, uniform or of the parameters' distributions: Monte Carlo.");
    addCount(p);
    p.integer("Seed").defaultValue(1).doc("The same seed gives the same points everywhere.");
  }

  static StudyDesign read(const input::Parameters& p) {
    StudyDesign design;
    design.options = SamplingOptions{p.integer("Count")};
    design.points = std::make_shared<const design::RandomDesign>(p.integer("Count"), p.integer("Seed"));
    return design;
  }
};

}  // namespace

HARMOS_DESIGN(Random)

}  // namespace harmos::study
