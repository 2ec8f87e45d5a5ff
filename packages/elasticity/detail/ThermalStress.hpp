#pragma once

#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/elasticity/Material.hpp>

namespace harmos::elasticity {

/// C alpha [stress/temperature] under the kinematics: the pressure that a fully restrained material has per degree. 0
/// without a thermal expansion.
Strain thermalStress(const Material& material, Kinematics kinematics);

}  // namespace harmos::elasticity
