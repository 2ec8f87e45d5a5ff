#include <harmos/design/GridDesign.hpp>
#include <harmos/study/detail/DesignRegistry.hpp>

namespace harmos::study {
namespace {

/// All combinations of levels.
struct Grid {
  static constexpr const char* name = "Grid";

  static void describe(input::ParameterSpec& p) {
    p.summary("All combinations of the levels; the last parameter varies fastest.");
  }

  static StudyDesign read(const input::Parameters&) {
    StudyDesign design;
    design.points = std::make_shared<const design::GridDesign>();
    return design;
  }
};

}  // namespace

HARMOS_DESIGN(Grid)

}  // namespace harmos::study
