#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/scene/detail/ResponseRegistry.hpp>
#include <harmos/scene/detail/VolumeLoad.hpp>

namespace harmos::scene {
namespace {

/// Inertia of a turning frame, with omega and its rate e along the axis d through the point p, r = x - p:
/// a = omega^2 (r - (r.d) d) - e d x r.
class TurningFrame final : public VolumeLoad {
 public:
  TurningFrame(const base::Vector3& point, const base::Vector3& axis, input::Schedule velocity, input::Schedule rate)
      : velocity_(std::move(velocity)), rate_(std::move(rate)) {
    for (std::size_t i = 0; i < 3; ++i) {
      base::Vector3 unit{};
      unit[i] = 1.0;
      outwards_.slope[i] = unit - axis[i] * axis;
      // Row i of the matrix of -d x r: e_i . (-d x r) = (d x e_i) . r.
      backwards_.slope[i] = base::cross(axis, unit);
    }
    for (elasticity::AffineField* field : {&outwards_, &backwards_}) {
      field->constant = -1.0 * base::product(field->slope, point);
    }
  }

  elasticity::AffineField acceleration(int step) const override {
    elasticity::AffineField result;
    result.add(velocity_[step] * velocity_[step], outwards_);
    result.add(rate_[step], backwards_);
    return result;
  }

 private:
  input::Schedule velocity_, rate_;
  elasticity::AffineField outwards_, backwards_;  // of omega^2 = 1, of e = 1
};

/// Centrifugal force of parts that turn with their support.
struct Rotation {
  static constexpr const char* name = "Rotation";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Inertia of an assembly that turns: the centrifugal force rho omega^2 r and, where the speed changes, the "
        "force "
        "rho e r against it; displacements are those relative to the turning support, stiffness is not changed by "
        "them.");
    p.number("Angular Velocity")
        .unit("radians/time")
        .required()
        .varying()
        .doc("omega; its history multiplies omega, the force goes with the square.");
    p.number("Angular Acceleration").unit("radians/time^2").defaultValue(0.0).varying().doc("e, the rate of omega.");
    p.numbers("Point").unit("length").optional().doc("Point on the axis; absent: the origin.");
    p.numbers("Axis").optional().doc(
        "Direction of the axis, of any length, needed in space; in the plane it is z, in axisymmetry y.");
  }

  static std::unique_ptr<VolumeLoad> make(const input::Parameters& p, elasticity::Kinematics kinematics) {
    base::Vector3 axis{0.0, 0.0, 1.0}, point{};
    if (p.has("Point")) point = vectorOf(p, "Point");
    if (elasticity::isAxisymmetric(kinematics)) {
      axis = {0.0, 1.0, 0.0};
      if (point[0] != 0.0) refuse(p.where("Point"), "in axisymmetry the axis is x = 0.", "Remove Point.");
      if (p.number("Angular Acceleration") != 0.0 && elasticity::componentsOf(kinematics) == 2) {
        refuse(p.where("Angular Acceleration"), "this axisymmetry is without torsion.",
               "Remove it, or choose Kinematics = Axisymmetric With Torsion.");
      }
    } else if (elasticity::dimensionOf(kinematics) == 3) {
      if (!p.has("Axis")) refuse(p.where(), "in space the axis has a direction.", "Give \"Axis\".");
      axis = directionOf(p, "Axis");
    }
    return std::make_unique<TurningFrame>(point, axis, p.schedule("Angular Velocity"),
                                          p.schedule("Angular Acceleration"));
  }

 private:
  [[noreturn]] static void refuse(const std::string& where, const std::string& what, const std::string& repair) {
    throw base::Error(where + ": " + what + "\n  " + repair, base::ExitCode::input);
  }
};

}  // namespace

HARMOS_VOLUME_LOAD(Rotation)

}  // namespace harmos::scene
