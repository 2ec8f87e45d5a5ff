#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/input/ErrorList.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/probability/Quadrature.hpp>
#include <harmos/probability/RandomVector.hpp>
#include <harmos/study/StudyDesign.hpp>
#include <harmos/study/StudyParameters.hpp>

namespace harmos::study {

/// How a study deals with its random parameters.
struct StochasticPlan {
  /// How the statistics are found.
  enum class Method {
    chaos,        // expansions solved for directly
    collocation,  // expansions through the responses at quadrature points
    adaptive,     // piecewise linear interpolation
    sampling      // statistics of random configurations
  };
  /// Coefficients of variation that a sweep gives to one random parameter.
  struct Sweep {
    std::string name;                  // of the sweep
    std::size_t variable;              // among the random parameters, from 0; normal or lognormal
    std::vector<double> coefficients;  // standard deviation over |mean| [-]
    std::string where;                 // they stand, for messages
  };

  Method method = Method::sampling;                            // that the design asks for
  std::shared_ptr<const probability::RandomVector> variables;  // the random parameters, in the order of the study
  base::Matrix correlation;         // of the copula [-], variables x variables; empty: independent
  std::string where;                // the correlations stand, else the design, for messages
  std::vector<std::size_t> places;  // of the random parameters among those of the study
  int order = 0;                    // of chaos and collocation; else 0
  int points = 0;                   // Gauss points of each germ that the user asks for; 0: as many as needed
  /// Of each configuration with which the study begins, in their order: of the quadrature or the sample, then those
  /// that are held out. One per random parameter [-]. An adaptive design adds its points after them.
  std::vector<std::vector<double>> germs;
  probability::Quadrature quadrature;  // of collocation
  int holdOuts = 0;                    // configurations that are solved only to judge; the last of `germs`
  std::vector<Sweep> sweeps;           // of chaos; else empty
  std::vector<std::string> remarks;    // for the user

  /// Of a random parameter, from 0; lives as long as `variables`.
  const probability::Distribution& distribution(std::size_t variable) const {
    return *variables->variables()[variable].distribution;
  }
};

/// Reads it from the input of a study, some parameters of which are random; null when that has errors, which are then
/// reported.
std::shared_ptr<const StochasticPlan> readStochasticPlan(const input::Parameters& study, const StudyDesign& design,
                                                         const std::vector<StudyParameter>& parameters,
                                                         input::ErrorList& errors);

/// The random parameters with other coefficients of variation, one per sweep: their means stay, their standard
/// deviations become coefficient times |mean|. Nothing of the plan changes.
std::shared_ptr<const probability::RandomVector> withSpread(const StochasticPlan& plan,
                                                            const std::vector<double>& coefficients);

/// Gauss points of each germ with which an expansion of this order is computed; `asked`: the user's number, 0: none.
/// `isGalerkin`: stiffness times two polynomials is integrated, else fields times one.
/// One number per random parameter: `asked` if there is one; else `order` + 1, and 6 more for Galerkin where a
/// parameter is not affine in its germ, of correlated ones where none is normal.
std::vector<int> gaussPoints(const probability::RandomVector& variables, int order, int asked, bool isGalerkin);

/// Random parameters of an adaptive interpolation.
constexpr int mostAdaptiveVariables = 3;

/// Points of a tensor grid that are not refused.
constexpr double mostTensorPoints = 1e5;

}  // namespace harmos::study
