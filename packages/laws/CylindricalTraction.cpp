#include <array>

#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/CylinderAxes.hpp>

namespace harmos::laws {
namespace {

/// Prescribed traction of an outer boundary in cylindrical components: f = R e_r + T e_t + A e_a [stress].
struct CylindricalTraction {
  static constexpr const char* name = "Cylindrical Traction";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::one;
  static constexpr Frame frame = Frame::global;
  static constexpr bool prescribesTraction = true;
  static constexpr bool isAffine = true;

  static void describe(input::ParameterSpec& p) {
    p.summary("Prescribed traction (force per area) in radial, tangential and axial components about an axis.");
    p.equation("t_i = given along the radial, tangential and axial direction");
    CylinderAxes::describe(p);
    for (const char* component : {"Radial", "Tangential", "Axial"}) {
      p.number(component).example("5").unit("stress").defaultValue(0.0).varying().doc("Traction along this direction.");
    }
  }

  explicit CylindricalTraction(const input::Parameters& p)
      : axes(p), value{p.schedule("Radial"), p.schedule("Tangential"), p.schedule("Axial")} {}

  LocalState solve(const LocalLine&, const NodeContext& at, const double*, double*) const {
    const base::Frame directions = axes.at(at.position());
    LocalState state;
    for (std::size_t i = 0; i < 3; ++i) {
      state.traction = state.traction + value[i][at.step] * directions[i];
    }
    return state;
  }

  CylinderAxes axes;
  std::array<input::Schedule, 3> value;
};

}  // namespace

HARMOS_INTERFACE_LAW(CylindricalTraction)

}  // namespace harmos::laws
