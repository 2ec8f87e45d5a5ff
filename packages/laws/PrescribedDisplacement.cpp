#include <array>

#include <harmos/laws/detail/BuiltIn.hpp>

namespace harmos::laws {
namespace {

constexpr std::array<const char*, 3> components = {"X", "Y", "Z"};

/// Prescribed displacement of an outer boundary, component by component in the global frame: w_i = value; a component
/// that is not given is free (f_i = 0).
struct PrescribedDisplacement {
  static constexpr const char* name = "Prescribed Displacement";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::one;
  static constexpr Frame frame = Frame::global;
  static constexpr bool isAffine = true;

  static void describe(input::ParameterSpec& p) {
    p.summary("Prescribed displacement in global components; components that are not given are free.");
    p.equation("w_i = given along x, y and z; t_i = 0 where nothing is given");
    for (const char* component : components) {
      p.number(component).example("0.01").unit("length").optional().varying().doc(
          "Displacement along this axis; absent: free.");
    }
  }

  explicit PrescribedDisplacement(const input::Parameters& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      fixed[i] = p.has(components[i]);
      if (fixed[i]) value[i] = p.schedule(components[i]);
    }
  }

  AdmissibleTractions admissibleTractions(int) const {
    return AdmissibleTractions::components(fixed[0], fixed[1], fixed[2]);
  }

  LocalState solve(const LocalLine& line, const NodeContext& at, const double*, double*) const {
    LocalState state;
    for (std::size_t i = 0; i < 3; ++i) {
      // The ground is side 2 at rest, so w1 = value means delta = -value.
      if (fixed[i]) state.traction[i] = (line.freeJump[i] + value[i][at.step]) / line.compliance;
    }
    return state;
  }

  std::array<bool, 3> fixed{};
  std::array<input::Schedule, 3> value;
};

}  // namespace

HARMOS_INTERFACE_LAW(PrescribedDisplacement)

}  // namespace harmos::laws
