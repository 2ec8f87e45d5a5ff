#pragma once

#include <array>
#include <optional>

/// Linear elastic parts: stiffness matrices, body forces and stresses from meshes and materials.
namespace harmos::elasticity {

/// Stress from strain, stress = C strain [stress], symmetric positive definite. Components xx, yy, zz, xy, yz, zx;
/// shear strains are engineering strains, gamma = 2 eps.
using ElasticityMatrix = std::array<std::array<double, 6>, 6>;

/// A strain in the same components.
using Strain = std::array<double, 6>;

/// A linear elastic material, the same at every point of a part. Holds only constants.
class Material {
 public:
  virtual ~Material() = default;
  /// C [stress] in the global axes x, y, z.
  virtual ElasticityMatrix elasticity() const = 0;
  /// rho [mass/volume]; nothing: not given.
  virtual std::optional<double> density() const { return std::nullopt; }
  /// Strain per change of temperature, free of stress [1/temperature], in the global axes; nothing: not given.
  virtual std::optional<Strain> thermalExpansion() const { return std::nullopt; }
};

}  // namespace harmos::elasticity
