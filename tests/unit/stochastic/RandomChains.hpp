#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/Normal.hpp>
#include <harmos/stochastic/StochasticSolver.hpp>

#include "../latin/Chains.hpp"

namespace harmos::stochastic {

using Law = std::shared_ptr<const laws::InterfaceLaw>;

inline std::shared_ptr<const probability::RandomVector> randomVector(
    const std::vector<std::shared_ptr<const probability::Distribution>>& distributions) {
  std::vector<probability::Variable> variables;
  for (const auto& distribution : distributions) {
    variables.push_back({"x" + std::to_string(variables.size()), distribution});
  }
  return std::make_shared<probability::RandomVector>(variables);
}

/// Gauss points in all germs, `points` of each; 0: one more than the order.
inline std::shared_ptr<const Projection> projectionOf(const std::shared_ptr<const probability::RandomVector>& variables,
                                                      int order, int points = 0) {
  return std::make_shared<Projection>(std::make_shared<probability::Basis>(variables, order),
                                      probability::tensorQuadrature(*variables, points > 0 ? points : order + 1));
}

/// Laws at the points from those of one realisation of the random parameters.
inline Realisations realisations(const Projection& projection,
                                 const std::function<std::vector<Law>(const std::vector<double>&)>& lawsOf) {
  Realisations result;
  for (const auto& point : projection.quadrature().points) {
    result.push_back(lawsOf(projection.basis()->variables().values(point)));
  }
  return result;
}

inline Law spring(double normal, double tangential = 1.0) {
  return laws::makeLaw("Linear Elastic", {{"Normal Stiffness", normal}, {"Tangential Stiffness", tangential}});
}

inline Law foundation(double normal, double tangential = 1.0) {
  return laws::makeLaw("Elastic Foundation", {{"Normal Stiffness", normal}, {"Tangential Stiffness", tangential}});
}

inline Law pull(double x, double y = 0.0, const std::map<std::string, std::vector<double>>& histories = {}) {
  return laws::makeLaw("Prescribed Traction", {{"X", x}, {"Y", y}}, histories);
}

/// ground |- spring 1 -|--- left: 10 ---|- spring 2 -|--- right: 20 ---> traction.
inline assembly::Assembly springsInSeries(std::vector<Law> laws, int steps = 1) {
  assembly::Assembly assembly = latin::twoChains(std::move(laws[1]), std::move(laws[2]), steps);
  assembly.interfaces[0].law = std::move(laws[0]);
  return assembly;
}

inline std::shared_ptr<const latin::Response> displacement(const std::string& name, int body, int node,
                                                           base::Vector3 direction = {1.0, 0.0, 0.0}) {
  return std::make_shared<latin::DisplacementResponse>(
      name, std::vector<latin::DisplacementResponse::Node>{{body, node, 1.0}}, direction);
}

}  // namespace harmos::stochastic
