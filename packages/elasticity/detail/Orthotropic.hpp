#pragma once

#include <harmos/base/Vector3.hpp>
#include <harmos/elasticity/Material.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::elasticity {

/// Orthotropic linear elasticity with material axes 1, 2, 3:
/// eps_11 = s_11/E_1 - nu_12 s_22/E_1 - nu_13 s_33/E_1 and so on, gamma_12 = s_12/G_12.
///
/// nu_ij is the contraction along j over the extension along i under tension along i; nu_ij/E_i = nu_ji/E_j.
/// Source: Jones, Mechanics of Composite Materials, 2nd ed. (1999), section 2.3; positive energy: section 2.4.
class Orthotropic : public Material {
 public:
  static constexpr const char* name = "Orthotropic";
  static void describe(input::ParameterSpec& spec);

  struct Constants {
    std::array<double, 3> youngsModulus{};  ///< E_1, E_2, E_3 [stress], > 0
    std::array<double, 3> poissonsRatio{};  ///< nu_12, nu_23, nu_13
    std::array<double, 3> shearModulus{};   ///< G_12, G_23, G_13 [stress], > 0
    base::Vector3 axis1{1.0, 0.0, 0.0};
    base::Vector3 axis2{0.0, 1.0, 0.0};
  };

  /// The axes need no unit length; axis 2 is made orthogonal to axis 1, axis 3 is their cross product.
  /// Throws base::Error when a constant is not positive, the energy is not, or the axes are parallel.
  explicit Orthotropic(const Constants& constants);
  explicit Orthotropic(const input::Parameters& parameters);
  ElasticityMatrix elasticity() const override { return elasticity_; }
  std::optional<double> density() const override { return density_; }
  std::optional<Strain> thermalExpansion() const override { return expansion_; }

 private:
  ElasticityMatrix elasticity_;
  std::optional<double> density_;
  std::optional<Strain> expansion_;
};

}  // namespace harmos::elasticity
