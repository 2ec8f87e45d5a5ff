#include <harmos/design/SobolDesign.hpp>
#include <harmos/study/detail/DesignRegistry.hpp>

namespace harmos::study {
namespace {

/// A sequence of low discrepancy.
struct Sobol {
  static constexpr const char* name = "Sobol";

  static void describe(input::ParameterSpec& p) {
    p.summary("Sobol' sequence: fills the space evenly; a longer one begins with the shorter one.");
    p.source("Joe, Kuo, SIAM J. Sci. Comput. 30 (2008)");
    addCount(p);
    p.integer("Seed").defaultValue(0).doc("0: the plain sequence; else a random digital shift.");
  }

  static StudyDesign read(const input::Parameters& p) {
    StudyDesign design;
    design.options = SamplingOptions{p.integer("Count")};
    design.points = std::make_shared<const design::SobolDesign>(p.integer("Count"), p.integer("Seed"));
    return design;
  }
};

}  // namespace

HARMOS_DESIGN(Sobol)

}  // namespace harmos::study
