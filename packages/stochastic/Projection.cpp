#include <harmos/stochastic/Projection.hpp>

#include <utility>

namespace harmos::stochastic {

Projection::Projection(std::shared_ptr<const chaos::Basis> basis, chaos::Quadrature quadrature)
    : basis_(std::move(basis)),
      quadrature_(std::move(quadrature)),
      values_(chaos::valuesAt(*basis_, quadrature_)),
      projector_(chaos::projector(*basis_, quadrature_)) {}

void Projection::toPoints(const base::Matrix& coefficients, base::Matrix& values) const {
  values.shapeUninitialized(coefficients.numRows(), points());
  values.multiply(Teuchos::NO_TRANS, Teuchos::TRANS, 1.0, coefficients, values_, 0.0);
}

void Projection::toCoefficients(const base::Matrix& values, base::Matrix& coefficients) const {
  coefficients.shapeUninitialized(values.numRows(), terms());
  coefficients.multiply(Teuchos::NO_TRANS, Teuchos::TRANS, 1.0, values, projector_, 0.0);
}

}  // namespace harmos::stochastic
