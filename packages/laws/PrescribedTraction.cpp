#include <array>

#include <harmos/laws/detail/BuiltIn.hpp>

namespace harmos::laws {
namespace {

/// Prescribed traction of an outer boundary in global components: f = (X, Y, Z) [stress].
struct PrescribedTraction {
  static constexpr const char* name = "Prescribed Traction";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::one;
  static constexpr Frame frame = Frame::global;
  static constexpr bool prescribesTraction = true;
  static constexpr bool isAffine = true;

  static void describe(input::ParameterSpec& p) {
    p.summary("Prescribed traction (force per area) in global components.");
    p.equation("t_i = given along x, y and z");
    for (const char* component : {"X", "Y", "Z"}) {
      p.number(component).example("5").unit("stress").defaultValue(0.0).varying().doc("Traction along this axis.");
    }
  }

  explicit PrescribedTraction(const input::Parameters& p) : value{p.schedule("X"), p.schedule("Y"), p.schedule("Z")} {}

  LocalState solve(const LocalLine&, const NodeContext& at, const double*, double*) const {
    LocalState state;
    for (std::size_t i = 0; i < 3; ++i) state.traction[i] = value[i][at.step];
    return state;
  }

  std::array<input::Schedule, 3> value;
};

}  // namespace

HARMOS_INTERFACE_LAW(PrescribedTraction)

}  // namespace harmos::laws
