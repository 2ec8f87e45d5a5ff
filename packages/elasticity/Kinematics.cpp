#include <harmos/elasticity/Kinematics.hpp>

#include <algorithm>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>

namespace harmos::elasticity {
namespace {

std::size_t indexOf(const std::string& name, const std::vector<std::string>& names, const char* kind) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw base::Error(
        "There is no " + std::string(kind) + " \"" + name + "\".\n  " + base::suggestName(name, names, "Allowed"),
        base::ExitCode::input);
  }
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

const std::vector<std::string>& kinematicsNames() {
  static const std::vector<std::string> names{"3-D", "Plane Strain", "Plane Stress", "Axisymmetric",
                                              "Axisymmetric With Torsion"};
  return names;
}

Kinematics kinematicsNamed(const std::string& name) {
  return static_cast<Kinematics>(indexOf(name, kinematicsNames(), "kinematics"));
}

const std::vector<std::string>& formulationNames() {
  static const std::vector<std::string> names{"Full Integration", "B-Bar", "Incompatible Modes"};
  return names;
}

Formulation formulationNamed(const std::string& name) {
  return static_cast<Formulation>(indexOf(name, formulationNames(), "formulation"));
}

std::vector<std::size_t> workingComponents(Kinematics kinematics) {
  if (componentsOf(kinematics) == 3) return {0, 1, 2, 3, 4, 5};
  if (isAxisymmetric(kinematics)) return {0, 1, 2, 3};
  return {0, 1, 3};
}

ElasticityMatrix reduced(const ElasticityMatrix& elasticity, Kinematics kinematics) {
  ElasticityMatrix c = elasticity;
  if (kinematics != Kinematics::planeStress) return c;
  for (const std::size_t gone : {2U, 4U, 5U}) {  // zz, yz, zx: one Schur complement after the other
    for (std::size_t i = 0; i < 6; ++i) {
      if (i == gone) continue;
      const double factor = c[i][gone] / c[gone][gone];
      for (std::size_t j = 0; j < 6; ++j) {
        if (j != gone) c[i][j] -= factor * c[gone][j];
      }
    }
    for (std::size_t i = 0; i < 6; ++i) c[i][gone] = c[gone][i] = 0.0;
  }
  return c;
}

}  // namespace harmos::elasticity
