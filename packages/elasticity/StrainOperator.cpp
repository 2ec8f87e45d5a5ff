#include <harmos/elasticity/detail/StrainOperator.hpp>

namespace harmos::elasticity {

StrainOperator::StrainOperator(Kinematics kinematics)
    : gradients(isAxisymmetric(kinematics) ? 3 : dimensionOf(kinematics)), components(componentsOf(kinematics)) {
  constexpr std::size_t voigt[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  for (int k = 0; k < dimensionOf(kinematics); ++k) {
    for (int i = 0; i < components; ++i) terms.push_back({voigt[i][k], k, i});
  }
  if (!isAxisymmetric(kinematics)) return;
  terms.push_back({2, 2, 0});
  if (components == 3) terms.push_back({5, 2, 2, -1.0});
}

}  // namespace harmos::elasticity
