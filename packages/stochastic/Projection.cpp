#include <harmos/stochastic/Projection.hpp>

#include <utility>

namespace harmos::stochastic {

Projection::Projection(std::shared_ptr<const probability::Basis> basis, probability::Quadrature quadrature)
    : basis_(std::move(basis)),
      quadrature_(std::move(quadrature)),
      values_(probability::valuesAt(*basis_, quadrature_)),
      projector_(probability::projector(*basis_, quadrature_)) {}

void Projection::toPoints(const base::Matrix& coefficients, base::Matrix& values) const {
  values.shapeUninitialized(coefficients.numRows(), points());
  values.multiply(Teuchos::NO_TRANS, Teuchos::TRANS, 1.0, coefficients, values_, 0.0);
}

void Projection::toCoefficients(const base::Matrix& values, base::Matrix& coefficients) const {
  coefficients.shapeUninitialized(values.numRows(), terms());
  coefficients.multiply(Teuchos::NO_TRANS, Teuchos::TRANS, 1.0, values, projector_, 0.0);
}

}  // namespace harmos::stochastic
