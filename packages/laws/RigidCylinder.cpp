#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/RoundTool.hpp>

namespace harmos::laws {
namespace {

// Component of a direction that is 0 but for rounding.
constexpr double none = 1e-12;

/// A cylinder without end; its middle is its axis.
class RigidCylinder final : public RoundTool {
 public:
  static constexpr const char* lawName = "Rigid Cylinder";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Contact with a rigid cylinder without end, from outside or inside, with friction; the tool moves by histories "
        "of X, Y, Z. Small sliding.");
    p.equation(
        "g = |arm to x| - Radius, opening = g + motion.n - w.n >= 0, t_n <= 0, opening t_n = 0; |t_t| <= mu |t_n|");
    p.numbers("Point").example("{25, 5, 35}").unit("length").required().doc("On the axis.");
    p.numbers("Axis")
        .example("{1, 0, 0}")
        .optional()
        .doc("Direction of the axis, of any length; absent, and in the plane: z.");
    describeRound(p);
  }

  explicit RigidCylinder(const input::Parameters& p) : RoundTool(p), point_(vectorOf(p, "Point")) {
    if (p.has("Axis")) axis_ = directionOf(p, "Axis");
  }

  const char* name() const override { return lawName; }
  void demandModel(int dimension, bool isAxisymmetric) const override {
    if (dimension == 3) return;
    if (isAxisymmetric && (std::abs(axis_[1]) < 1.0 - none || point_[0] != 0.0)) {
      throw base::Error(
          "a cylinder of revolution has the axis y.\n  Make its Axis {0, 1}, and its Point one of that axis.",
          base::ExitCode::input);
    }
    if (!isAxisymmetric && std::abs(axis_[2]) < 1.0 - none) {
      throw base::Error("in the plane the axis is z.\n  Leave out Axis.", base::ExitCode::input);
    }
  }

 protected:
  base::Vector3 armTo(const base::Vector3& place) const override {
    const base::Vector3 arm = place - point_;
    return arm - dot(arm, axis_) * axis_;
  }

 private:
  base::Vector3 point_;
  base::Vector3 axis_{0.0, 0.0, 1.0};
};

}  // namespace

HARMOS_WHOLE_LAW(RigidCylinder)

}  // namespace harmos::laws
