#include <gtest/gtest.h>

#include <cmath>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/probability/Expansion.hpp>
#include <harmos/probability/GalerkinMatrix.hpp>
#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/Normal.hpp>

namespace harmos::probability {
namespace {

std::shared_ptr<const Basis> basisOf(const std::vector<std::shared_ptr<const Distribution>>& distributions, int order) {
  std::vector<Variable> variables;
  for (const auto& distribution : distributions) variables.push_back({"k", distribution});
  return std::make_shared<Basis>(std::make_shared<RandomVector>(std::move(variables)), order);
}

/// E[k_i psi_a psi_b] of parameter i.
base::Matrix stiffness(const Basis& basis, int points, std::size_t i) {
  const Quadrature quadrature = tensorQuadrature(basis.variables(), points);
  std::vector<double> k;
  for (const auto& point : quadrature.points) k.push_back(basis.variables().values(point)[i]);
  return galerkinMatrix(basis, quadrature, k);
}

/// Coefficients of u in k u = 1; empty when k is not positive definite.
// NOLINTNEXTLINE(performance-unnecessary-value-param): LAPACK overwrites it
std::vector<double> solve(base::Matrix k) {
  std::vector<double> u(k.numRows(), 0.0);
  u[0] = 1.0;
  int info = 0;
  Teuchos::LAPACK<int, double>().POSV('L', k.numRows(), 1, k.values(), k.stride(), u.data(), k.numRows(), &info);
  return info == 0 ? u : std::vector<double>();
}

Expansion gaussianSpring(double ratio, int order) {
  const auto basis = basisOf({std::make_shared<Normal>(1.0, ratio)}, order);
  return Expansion(basis, solve(stiffness(*basis, order + 1, 0)));
}

TEST(GalerkinMatrix, GaussianSpring) {
  const double means[] = {1.04166667, 1.04545455, 1.04602510}, deviations[] = {0.20833333, 0.23618875, 0.24307427};
  for (int order = 1; order <= 3; ++order) {
    const Expansion u = gaussianSpring(0.2, order);
    EXPECT_NEAR(u.mean(), means[order - 1], 1e-8);
    EXPECT_NEAR(u.standardDeviation(), deviations[order - 1], 1e-8);
  }
}

/// The eigenvalues of the matrix are the values of k at the points of the rule with order + 1 points.
TEST(GalerkinMatrix, GaussianSpringIsIndefiniteWhereARulePointHasNegativeStiffness) {
  for (int order = 2; order <= 8; ++order) {
    const double limit = 1.0 / Polynomials::hermite().gauss(order + 1).points.back();
    for (const bool isBeyond : {false, true}) {
      const double ratio = limit * (isBeyond ? 1.001 : 0.999);
      const auto basis = basisOf({std::make_shared<Normal>(1.0, ratio)}, order);
      EXPECT_EQ(solve(stiffness(*basis, order + 1, 0)).empty(), isBeyond) << "order " << order;
    }
  }
  const auto basis = basisOf({std::make_shared<Normal>(1.0, 0.25)}, 8);
  EXPECT_TRUE(solve(stiffness(*basis, 9, 0)).empty());
}

TEST(GalerkinMatrix, TwoLognormalSpringsInSeries) {
  const auto basis = basisOf({std::make_shared<Lognormal>(2.0, 0.4), std::make_shared<Lognormal>(5.0, 1.25)}, 3);
  std::vector<double> u(basis->size(), 0.0);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::vector<double> part = solve(stiffness(*basis, 20, i));
    for (std::size_t a = 0; a < u.size(); ++a) u[a] += part[a];
  }
  const double ratio = Expansion(basis, u).standardDeviation() / 0.116782985169;
  EXPECT_NEAR(ratio * ratio, 0.999893326221, 1e-10);
}

TEST(GalerkinMatrix, NeedsOneValuePerPoint) {
  const auto basis = basisOf({std::make_shared<Normal>(1.0, 0.1)}, 2);
  EXPECT_THROW(galerkinMatrix(*basis, tensorQuadrature(basis->variables(), 3), {1.0, 2.0}), base::Error);
}

}  // namespace
}  // namespace harmos::probability
