#include <harmos/study/detail/DesignRegistry.hpp>

namespace harmos::study {
namespace {

/// The rows of a table.
struct List {
  static constexpr const char* name = "List";

  static void describe(input::ParameterSpec& p) {
    p.summary("The rows of a table.");
    p.text("File").required().doc(
        "CSV, path relative to the study's file; its header names all free parameters, in any order.");
  }

  static StudyDesign read(const input::Parameters& p) {
    StudyDesign design;
    design.options = TableOptions{p.text("File")};
    return design;
  }
};

}  // namespace

HARMOS_DESIGN(List)

}  // namespace harmos::study
