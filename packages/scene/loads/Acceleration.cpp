#include <harmos/scene/detail/UniformAcceleration.hpp>

namespace harmos::scene {
namespace {

/// Inertia of an accelerated frame: b = -rho a.
struct Acceleration {
  static constexpr const char* name = "Acceleration";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Inertia of an assembly whose support is accelerated: the body force -rho a (d'Alembert); displacements are "
        "those relative to the support. Vibrations are not computed.");
    UniformAcceleration::describe(p, "Component of a, the acceleration of the support, along this axis.");
  }

  static std::unique_ptr<VolumeLoad> make(const input::Parameters& p, elasticity::Kinematics kinematics) {
    return std::make_unique<UniformAcceleration>(p, kinematics, -1.0);
  }
};

}  // namespace

HARMOS_VOLUME_LOAD(Acceleration)

}  // namespace harmos::scene
