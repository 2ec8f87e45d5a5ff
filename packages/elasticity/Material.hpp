#pragma once

#include <array>

namespace harmos::elasticity {

/// Stress from strain, stress = C strain [stress], symmetric positive definite. Components xx, yy, zz, xy, yz, zx;
/// shear strains are engineering strains, gamma = 2 eps.
using ElasticityMatrix = std::array<std::array<double, 6>, 6>;

/// A linear elastic material, the same at every point of a part.
class Material {
 public:
  virtual ~Material() = default;
  virtual ElasticityMatrix elasticity() const = 0;
};

}  // namespace harmos::elasticity
