#include <array>
#include <sstream>

#include <harmos/base/Error.hpp>

#include <harmos/laws/TurnedLaw.hpp>
#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/CylinderAxes.hpp>

namespace harmos::laws {
namespace {

constexpr std::array<const char*, 3> components = {"Radial", "Tangential", "Axial"};

/// Prescribed displacement of an outer boundary in cylindrical components: w_i = value; a component that is not given
/// is free (f_i = 0). Displacements are small: a tangential one does not turn the axes.
class CylindricalDisplacement final : public InterfaceLaw, public TurnedLaw {
 public:
  static constexpr const char* lawName = "Cylindrical Displacement";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Prescribed displacement in radial, tangential and axial components about an axis; components that are not "
        "given "
        "are free. In results the radial direction stands for the normal.");
    p.equation("w_i = given along the radial, tangential and axial direction; t_i = 0 where nothing is given");
    CylinderAxes::describe(p);
    for (const char* component : components) {
      p.number(component).example("0.01").unit("length").optional().varying().overSurface().doc(
          "Displacement along this direction; absent: free.");
    }
  }

  explicit CylindricalDisplacement(const input::Parameters& p) : axes_(p) {
    for (std::size_t i = 0; i < 3; ++i) {
      isFixed_[i] = p.has(components[i]);
      if (isFixed_[i]) value_[i] = p.schedule(components[i]);
    }
  }

  const char* name() const override { return lawName; }
  int historySize() const override { return 0; }
  Frame frame() const override { return Frame::interface; }
  Sides sides() const override { return Sides::one; }
  bool prescribesTraction() const override { return false; }
  bool dissipates() const override { return false; }
  bool isAffine() const override { return true; }
  Creases creases() const override { return Creases::ignore; }
  std::optional<AdmissibleTractions> admissibleTractions(int) const override {
    return AdmissibleTractions::components(isFixed_[0], isFixed_[1], isFixed_[2]);
  }
  base::Frame axesAt(const base::Vector3& place) const override {
    const base::Frame axes = axes_.at(place);
    if (base::norm(axes[0]) > 0.0) return axes;
    std::ostringstream text;
    text << "a node at (" << place[0] << ", " << place[1] << ", " << place[2]
         << ") lies on the axis, where no direction is radial.\n  Leave it out of the set, or move the axis.";
    throw base::Error(text.str(), base::ExitCode::input);
  }

  void solve(int step, const NodeArrays& nodes) const override {
    for (int p = 0; p < nodes.count; ++p) {
      LocalState state;
      for (std::size_t i = 0; i < 3; ++i) {
        // The ground is side 2 at rest, so w1 = value means delta = -value.
        if (isFixed_[i]) state.traction[i] = (nodes.line[p].freeJump[i] + value_[i][step]) / nodes.line[p].compliance;
      }
      nodes.state[p] = state;
    }
  }

 private:
  CylinderAxes axes_;
  std::array<bool, 3> isFixed_{};
  std::array<input::Schedule, 3> value_;
};

}  // namespace

HARMOS_WHOLE_LAW(CylindricalDisplacement)

}  // namespace harmos::laws
