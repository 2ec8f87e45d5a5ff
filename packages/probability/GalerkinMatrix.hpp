#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/probability/Quadrature.hpp>

namespace harmos::probability {

/// E[k psi_a psi_b] of a random number k by its values at the points, polynomials x polynomials:
/// G_ab = sum over q of w_q k_q psi_a(xi_q) psi_b(xi_q).
///
/// `k`: one value k_q per point; the matrix has their unit. Symmetric; positive definite when all weights and values
/// are positive and the points are enough to tell the polynomials apart. Where k takes negative values it may be
/// indefinite. Throws base::Error when `k` has not one value per point.
base::Matrix galerkinMatrix(const Basis& basis, const Quadrature& quadrature, const std::vector<double>& k);

}  // namespace harmos::probability
