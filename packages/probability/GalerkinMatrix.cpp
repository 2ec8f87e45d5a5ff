#include <harmos/probability/GalerkinMatrix.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::probability {

base::Matrix galerkinMatrix(const Basis& basis, const Quadrature& quadrature, const std::vector<double>& k) {
  if (static_cast<int>(k.size()) != quadrature.size())
    throw base::Error("a Galerkin matrix needs one value for each quadrature point");
  const base::Matrix values = valuesAt(basis, quadrature);
  base::Matrix scaled(values);
  for (int a = 0; a < basis.size(); ++a) {
    for (int q = 0; q < quadrature.size(); ++q) {
      const auto at = static_cast<std::size_t>(q);
      scaled(q, a) *= quadrature.weights[at] * k[at];
    }
  }
  base::Matrix matrix(basis.size(), basis.size());
  matrix.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, values, scaled, 0.0);
  return matrix;
}

}  // namespace harmos::probability
