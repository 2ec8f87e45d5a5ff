#include <harmos/probability/Quadrature.hpp>

namespace harmos::probability {

Quadrature tensorQuadrature(const RandomVector& variables, int pointsPerGerm) {
  return tensorQuadrature(variables, std::vector<int>(variables.dimension(), pointsPerGerm));
}

Quadrature tensorQuadrature(const RandomVector& variables, const std::vector<int>& points) {
  Quadrature quadrature{{{}}, {1.0}};
  for (int i = 0; i < variables.dimension(); ++i) {
    const GaussRule rule = variables.polynomials(i).gauss(points[i]);
    Quadrature product;
    for (std::size_t q = 0; q < quadrature.points.size(); ++q) {
      for (std::size_t k = 0; k < rule.points.size(); ++k) {
        product.points.push_back(quadrature.points[q]);
        product.points.back().push_back(rule.points[k]);
        product.weights.push_back(quadrature.weights[q] * rule.weights[k]);
      }
    }
    quadrature = std::move(product);
  }
  return quadrature;
}

base::Matrix valuesAt(const Basis& basis, const Quadrature& quadrature) {
  base::Matrix values(quadrature.size(), basis.size());
  for (int q = 0; q < quadrature.size(); ++q) {
    const std::vector<double> psi = basis.evaluate(quadrature.points[q]);
    for (int a = 0; a < basis.size(); ++a) values(q, a) = psi[a];
  }
  return values;
}

base::Matrix projector(const Basis& basis, const Quadrature& quadrature) {
  base::Matrix projector(valuesAt(basis, quadrature), Teuchos::TRANS);
  for (int q = 0; q < quadrature.size(); ++q) {
    for (int a = 0; a < basis.size(); ++a) projector(a, q) *= quadrature.weights[q];
  }
  return projector;
}

}  // namespace harmos::probability
