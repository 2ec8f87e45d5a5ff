#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/RigidTool.hpp>

namespace harmos::laws {
namespace {

// Component of a direction that is 0 but for rounding.
constexpr double none = 1e-12;

/// A half-space that ends at a plane: g = (x - P).N, n = -N with the normal N out of the tool.
class RigidPlane final : public RigidTool {
 public:
  static constexpr const char* lawName = "Rigid Plane";

  static void describe(input::ParameterSpec& p) {
    p.summary("Contact with a rigid plane, with friction; the tool moves by histories of X, Y, Z. Small sliding.");
    p.equation(
        "g = (x - Point).Normal, opening = g + motion.n - w.n >= 0, t_n <= 0, opening t_n = 0; |t_t| <= mu |t_n|");
    p.numbers("Point").example("{25, 5, 10}").unit("length").required().doc("On the plane.");
    p.numbers("Normal")
        .example("{0, 0, -1}")
        .required()
        .doc("Direction out of the tool, towards the part, of any length.");
    describeTool(p);
  }

  explicit RigidPlane(const input::Parameters& p)
      : RigidTool(p), point_(vectorOf(p, "Point")), normal_(directionOf(p, "Normal")) {}

  const char* name() const override { return lawName; }
  void demandModel(int dimension, bool isAxisymmetric) const override {
    const bool isTilted = isAxisymmetric ? std::abs(normal_[1]) < 1.0 - none : std::abs(normal_[2]) > none;
    if (dimension == 3 || !isTilted) return;
    throw base::Error(isAxisymmetric
                          ? "a plane that is not perpendicular to the axis y is none of revolution.\n  Make its "
                            "Normal {0, 1} or {0, -1}."
                          : "the Normal leaves the plane of the model.\n  Give it two numbers.",
                      base::ExitCode::input);
  }

 protected:
  Side sideAt(const base::Vector3& place) const override { return {-1.0 * normal_, dot(place - point_, normal_)}; }

 private:
  base::Vector3 point_, normal_;
};

}  // namespace

HARMOS_WHOLE_LAW(RigidPlane)

}  // namespace harmos::laws
