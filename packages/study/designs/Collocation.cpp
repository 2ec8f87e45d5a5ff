#include <harmos/study/detail/DesignRegistry.hpp>

namespace harmos::study {
namespace {

/// Expansions through the responses at the points of a quadrature.
struct Collocation {
  static constexpr const char* name = "Collocation";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Solves the configurations at the points of a quadrature rule, and projects the responses on the polynomials.");
    addOrder(p);
    p.text("Points In")
        .defaultValue("Tensor")
        .oneOf({"Tensor", "Sparse"})
        .doc("Tensor: all combinations of Gauss points. Sparse: Smolyak's sparse grid.");
  }

  static StudyDesign read(const input::Parameters& p) {
    CollocationOptions options;
    options.order = p.integer("Order");
    options.points = p.integer("Points");
    options.holdOuts = readHoldOuts(p);
    options.isSparse = p.text("Points In") == "Sparse";
    StudyDesign design;
    design.options = options;
    return design;
  }
};

}  // namespace

HARMOS_DESIGN(Collocation)

}  // namespace harmos::study
