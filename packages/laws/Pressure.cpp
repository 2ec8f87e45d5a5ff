#include <harmos/laws/detail/BuiltIn.hpp>

namespace harmos::laws {
namespace {

/// Prescribed pressure of an outer boundary: f = -p n with the outward normal n.
struct Pressure {
  static constexpr const char* name = "Pressure";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::one;
  static constexpr bool prescribesTraction = true;
  static constexpr bool isAffine = true;

  static void describe(input::ParameterSpec& p) {
    p.summary("Prescribed pressure on an outer boundary, positive when it pushes on the body.");
    p.equation("t = -p n");
    p.number("Pressure")
        .example("10")
        .unit("stress")
        .required()
        .varying()
        .doc("Force per area against the outward normal.");
  }

  explicit Pressure(const input::Parameters& p) : value(p.schedule("Pressure")) {}

  LocalState solve(const LocalLine&, const NodeContext& at, const double*, double*) const {
    return {{-value[at.step], 0.0, 0.0}, Status::bonded};
  }

  input::Schedule value;
};

}  // namespace

HARMOS_INTERFACE_LAW(Pressure)

}  // namespace harmos::laws
