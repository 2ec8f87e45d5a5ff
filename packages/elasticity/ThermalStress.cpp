#include <harmos/elasticity/detail/ThermalStress.hpp>

#include <numeric>

namespace harmos::elasticity {

Strain thermalStress(const Material& material, Kinematics kinematics) {
  const ElasticityMatrix c = reduced(material.elasticity(), kinematics);
  const Strain alpha = material.thermalExpansion().value_or(Strain{});
  Strain stress{};
  for (std::size_t m = 0; m < 6; ++m) stress[m] = std::inner_product(alpha.begin(), alpha.end(), c[m].begin(), 0.0);
  return stress;
}

}  // namespace harmos::elasticity
