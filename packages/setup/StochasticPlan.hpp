#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/base/ErrorList.hpp>
#include <harmos/base/Parameters.hpp>
#include <harmos/chaos/Quadrature.hpp>
#include <harmos/chaos/RandomVector.hpp>
#include <harmos/setup/StudyParameters.hpp>

namespace harmos::setup {

/// How a study deals with its random parameters.
struct StochasticPlan {
  enum class Method {
    chaos,        // expansions solved for directly
    collocation,  // expansions through the responses at quadrature points
    adaptive,     // piecewise linear interpolation
    sampling      // statistics of random configurations
  };
  /// Coefficients of variation that a sweep gives to one random parameter.
  struct Sweep {
    std::string name;
    std::size_t variable;  // among the random parameters
    std::vector<double> coefficients;
  };

  Method method = Method::sampling;
  std::shared_ptr<const chaos::RandomVector> variables;
  base::Matrix correlation;         // of the copula; empty: independent
  std::vector<std::size_t> places;  // of the random parameters among those of the study
  int order = 0;                    // of chaos and collocation
  /// Of each configuration with which the study begins, in their order: of the quadrature or the sample, then those
  /// that are held out. An adaptive design adds its points after them.
  std::vector<std::vector<double>> germs;
  chaos::Quadrature quadrature;  // of collocation
  int holdOuts = 0;              // configurations that are solved only to judge; the last of `germs`
  std::vector<Sweep> sweeps;
  std::vector<std::string> remarks;  // for the user

  const chaos::Distribution& distribution(std::size_t variable) const {
    return *variables->variables()[variable].distribution;
  }
};

/// Reads it from the input of a study, some parameters of which are random; null when that has errors, which are then
/// reported.
std::shared_ptr<const StochasticPlan> readStochasticPlan(const base::Parameters& study,
                                                         const std::vector<StudyParameter>& parameters,
                                                         base::ErrorList& errors);

/// The random parameters with other coefficients of variation, one per sweep.
std::shared_ptr<const chaos::RandomVector> withSpread(const StochasticPlan& plan,
                                                      const std::vector<double>& coefficients);

/// Gauss points of each germ with which an expansion of this order is computed; `asked`: the user's number, 0: none.
/// `isGalerkin`: stiffness times two polynomials is integrated, else fields times one.
std::vector<int> gaussPoints(const chaos::RandomVector& variables, int order, int asked, bool isGalerkin);

}  // namespace harmos::setup
