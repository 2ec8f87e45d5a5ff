#include <harmos/base/Error.hpp>
#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/RoundTool.hpp>

namespace harmos::laws {
namespace {

/// A sphere; its middle is its centre.
class RigidSphere final : public RoundTool {
 public:
  static constexpr const char* lawName = "Rigid Sphere";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Contact with a rigid sphere, from outside or inside, with friction; the tool moves by histories of X, Y, Z. "
        "Small sliding.");
    p.equation(
        "g = |x - Centre| - Radius, opening = g + motion.n - w.n >= 0, t_n <= 0, opening t_n = 0; |t_t| <= mu |t_n|");
    p.numbers("Centre").example("{25, 5, 35}").unit("length").required().doc("Of the sphere.");
    describeRound(p);
  }

  explicit RigidSphere(const input::Parameters& p) : RoundTool(p), centre_(vectorOf(p, "Centre")) {}

  const char* name() const override { return lawName; }
  void demandModel(int dimension, bool isAxisymmetric) const override {
    if (dimension == 3 || (isAxisymmetric && centre_[0] == 0.0)) return;
    throw base::Error(isAxisymmetric
                          ? "a sphere of revolution has its centre on the axis y.\n  Make the first number of "
                            "Centre 0."
                          : "a sphere is none in the plane.\n  Take Rigid Cylinder, or model the part in space.",
                      base::ExitCode::input);
  }

 protected:
  base::Vector3 armTo(const base::Vector3& place) const override { return place - centre_; }

 private:
  base::Vector3 centre_;
};

}  // namespace

HARMOS_WHOLE_LAW(RigidSphere)

}  // namespace harmos::laws
