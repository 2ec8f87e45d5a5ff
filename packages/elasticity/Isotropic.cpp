#include <harmos/elasticity/detail/Isotropic.hpp>

#include <cmath>
#include <string>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/elasticity/detail/MaterialEntries.hpp>

namespace harmos::elasticity {
namespace {

// Beyond, bulk and shear modulus differ by more than the digits that an estimate of errors needs.
constexpr double smallestRatio = -0.999;
constexpr double largestRatio = 0.4999999;

}  // namespace

void Isotropic::describe(input::ParameterSpec& spec) {
  spec.summary("Isotropic linear elasticity: stress = lambda tr(eps) I + 2 mu eps.");
  spec.number("Young's Modulus")
      .unit("stress")
      .required()
      .above(0.0)
      .doc("E, tension over strain in uniaxial tension.");
  spec.number("Poisson's Ratio")
      .unit("-")
      .required()
      .atLeast(smallestRatio)
      .atMost(largestRatio)
      .doc("nu, contraction over extension in uniaxial tension. Above about 0.45 use the part's formulation B-Bar.");
  describeDensity(spec);
  describeExpansion(spec, "Thermal Expansion", "alpha, strain per change of temperature, for Temperatures.");
}

Isotropic::Isotropic(double youngsModulus, double poissonsRatio)
    : youngsModulus_(youngsModulus), poissonsRatio_(poissonsRatio) {
  if (!(youngsModulus > 0.0 && std::isfinite(youngsModulus) && poissonsRatio >= smallestRatio &&
        poissonsRatio <= largestRatio)) {
    throw base::Error("An isotropic material needs a Young's modulus above 0 and a Poisson's ratio from " +
                          base::toText(smallestRatio) + " to " + base::toText(largestRatio) + "; given are " +
                          base::toText(youngsModulus) + " and " + base::toText(poissonsRatio) + ".",
                      base::ExitCode::input);
  }
}

Isotropic::Isotropic(const input::Parameters& parameters)
    : Isotropic(parameters.number("Young's Modulus"), parameters.number("Poisson's Ratio")) {
  density_ = optionalNumber(parameters, "Density");
  expansion_ = optionalNumber(parameters, "Thermal Expansion");
}

std::optional<Strain> Isotropic::thermalExpansion() const {
  if (!expansion_) return std::nullopt;
  return Strain{*expansion_, *expansion_, *expansion_, 0.0, 0.0, 0.0};
}

ElasticityMatrix Isotropic::elasticity() const {
  const double mu = youngsModulus_ / (2.0 * (1.0 + poissonsRatio_));
  const double lambda = 2.0 * mu * poissonsRatio_ / (1.0 - 2.0 * poissonsRatio_);
  ElasticityMatrix c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) c[i][j] = lambda;
    c[i][i] += 2.0 * mu;
    c[i + 3][i + 3] = mu;
  }
  return c;
}

}  // namespace harmos::elasticity
