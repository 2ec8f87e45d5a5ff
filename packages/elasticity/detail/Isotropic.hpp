#pragma once

#include <harmos/elasticity/Material.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::elasticity {

/// Isotropic linear elasticity: stress = lambda tr(eps) I + 2 mu eps,
/// lambda = E nu / ((1 + nu) (1 - 2 nu)), mu = E / (2 (1 + nu)).
class Isotropic : public Material {
 public:
  static constexpr const char* name = "Isotropic";
  static void describe(input::ParameterSpec& spec);

  /// E > 0 [stress], -1 < nu < 0.5. Throws base::Error otherwise.
  Isotropic(double youngsModulus, double poissonsRatio);
  explicit Isotropic(const input::Parameters& parameters);
  ElasticityMatrix elasticity() const override;
  std::optional<double> density() const override { return density_; }
  std::optional<Strain> thermalExpansion() const override;

 private:
  double youngsModulus_, poissonsRatio_;
  std::optional<double> density_, expansion_;
};

}  // namespace harmos::elasticity
