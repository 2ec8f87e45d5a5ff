#include <harmos/scene/detail/UniformAcceleration.hpp>

namespace harmos::scene {
namespace {

/// Weight: b = rho g.
struct Gravity {
  static constexpr const char* name = "Gravity";

  static void describe(input::ParameterSpec& p) {
    p.summary("Weight: the body force rho g of parts whose materials have a Density.");
    UniformAcceleration::describe(p, "Component of g, the acceleration of free fall, along this axis.");
  }

  static std::unique_ptr<VolumeLoad> make(const input::Parameters& p, elasticity::Kinematics kinematics) {
    return std::make_unique<UniformAcceleration>(p, kinematics, 1.0);
  }
};

}  // namespace

HARMOS_VOLUME_LOAD(Gravity)

}  // namespace harmos::scene
