#include <array>
#include <cassert>

#include <harmos/laws/InterfaceLaw.hpp>
#include <harmos/laws/NodalLaw.hpp>
#include <harmos/laws/detail/BuiltIn.hpp>

namespace harmos::laws {
namespace {

constexpr std::array<const char*, 3> components = {"X", "Y", "Z"};

/// A force on every node of a set: h t = F.
class NodalForce final : public InterfaceLaw, public NodalLaw {
 public:
  static constexpr const char* lawName = "Nodal Force";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Force on every node of a set, as nodal loads of other programs. At single nodes stresses and displacements "
        "grow with every refinement; Remote Force spreads one force over a face.");
    p.equation("h t_i = force along x, y and z, of every node");
    for (const char* component : components) {
      p.number(component).example("5").unit("force").defaultValue(0.0).varying().overSurface().doc(
          "Force on each node along this axis; in axisymmetry that of the whole circle.");
    }
  }

  explicit NodalForce(const input::Parameters& p) {
    for (std::size_t i = 0; i < 3; ++i) force_[i] = p.schedule(components[i]);
  }

  const char* name() const override { return lawName; }
  int historySize() const override { return 0; }
  Frame frame() const override { return Frame::global; }
  Sides sides() const override { return Sides::one; }
  bool prescribesTraction() const override { return true; }
  bool dissipates() const override { return false; }
  bool isAffine() const override { return true; }

  void solve(int step, const NodeArrays& nodes) const override {
    assert((nodes.count == 0 || nodes.area != nullptr) && "forces are divided by areas");
    const base::Vector3 force{force_[0][step], force_[1][step], force_[2][step]};
    for (int p = 0; p < nodes.count; ++p) nodes.state[p] = {(1.0 / nodes.area[p]) * force, Status::bonded};
  }

 private:
  std::array<input::Schedule, 3> force_;
};

}  // namespace

HARMOS_WHOLE_LAW(NodalForce)

}  // namespace harmos::laws
