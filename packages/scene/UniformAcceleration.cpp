#include <harmos/scene/detail/UniformAcceleration.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::scene {

namespace {

constexpr std::array<const char*, 3> components = {"X", "Y", "Z"};

}  // namespace

void UniformAcceleration::describe(input::ParameterSpec& spec, const std::string& doc) {
  for (const char* component : components) {
    spec.number(component).unit("length/time^2").defaultValue(0.0).varying().doc(doc);
  }
}

UniformAcceleration::UniformAcceleration(const input::Parameters& parameters, elasticity::Kinematics kinematics,
                                         double sign)
    : value_{parameters.schedule("X"), parameters.schedule("Y"), parameters.schedule("Z")}, sign_(sign) {
  const auto refuse = [&](const char* component, const std::string& why) {
    if (parameters.number(component) == 0.0) return;
    throw base::Error(parameters.where(component) + ": " + why + "\n  Remove " + component + ".",
                      base::ExitCode::input);
  };
  if (elasticity::dimensionOf(kinematics) == 2) refuse("Z", "in the plane there is no acceleration along z.");
  if (elasticity::isAxisymmetric(kinematics)) {
    refuse("X", "in axisymmetry x is the radius, along which nothing is accelerated uniformly.");
  }
}

elasticity::AffineField UniformAcceleration::acceleration(int step) const {
  return {{sign_ * value_[0][step], sign_ * value_[1][step], sign_ * value_[2][step]}, {}};
}

}  // namespace harmos::scene
