#include <gtest/gtest.h>

#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/Normal.hpp>
#include <harmos/probability/Quadrature.hpp>
#include <harmos/probability/Uniform.hpp>

namespace harmos::probability {
namespace {

std::shared_ptr<const RandomVector> mixedVariables(int count) {
  std::vector<Variable> variables;
  for (int i = 0; i < count; ++i) {
    if (i % 2 == 0) {
      variables.push_back({"k" + std::to_string(i), std::make_shared<Lognormal>(2.0, 0.4)});
    } else {
      variables.push_back({"mu" + std::to_string(i), std::make_shared<Uniform>(0.1, 0.3)});
    }
  }
  return std::make_shared<RandomVector>(std::move(variables));
}

double distanceFromOrthonormal(const Basis& basis, const Quadrature& quadrature) {
  base::Matrix product(basis.size(), basis.size());
  product.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, projector(basis, quadrature), valuesAt(basis, quadrature),
                   0.0);
  double largest = 0.0;
  for (int a = 0; a < basis.size(); ++a) {
    for (int b = 0; b < basis.size(); ++b) largest = std::max(largest, std::abs(product(a, b) - (a == b ? 1.0 : 0.0)));
  }
  return largest;
}

TEST(Basis, TermsAreInGradedLexicographicOrder) {
  using Indices = std::vector<std::vector<int>>;
  EXPECT_EQ(Basis(mixedVariables(2), 3).indices(),
            (Indices{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}}));
  EXPECT_EQ(Basis(mixedVariables(3), 2).indices(), (Indices{{0, 0, 0},
                                                            {1, 0, 0},
                                                            {0, 1, 0},
                                                            {0, 0, 1},
                                                            {2, 0, 0},
                                                            {1, 1, 0},
                                                            {1, 0, 1},
                                                            {0, 2, 0},
                                                            {0, 1, 1},
                                                            {0, 0, 2}}));
  EXPECT_EQ(Basis(mixedVariables(1), 0).size(), 1);
  EXPECT_EQ(Basis(mixedVariables(6), 4).size(), 210);
}

TEST(Basis, IsTheProductOfThePolynomialsOfTheGerms) {
  const Basis basis(mixedVariables(2), 3);
  const auto psi = basis.evaluate({0.7, -0.2});
  // He_2 and P_1, normalised.
  EXPECT_NEAR(psi[7], (0.49 - 1.0) / std::sqrt(2.0) * std::sqrt(3.0) * -0.2, 1e-14);
  EXPECT_EQ(psi[0], 1.0);
}

TEST(Basis, RefusesAnOrderThatMakesNoSense) {
  EXPECT_THROW(Basis(mixedVariables(2), -1), base::Error);
  EXPECT_THROW(Basis(mixedVariables(40), 12), base::Error);
}

TEST(Quadrature, TensorGridIsOrthonormalWithTheLastGermFastest) {
  const auto variables = mixedVariables(3);
  const Quadrature quadrature = tensorQuadrature(*variables, 5);
  EXPECT_EQ(quadrature.size(), 125);
  EXPECT_EQ(quadrature.points[0][0], quadrature.points[24][0]);
  EXPECT_NE(quadrature.points[0][2], quadrature.points[1][2]);
  EXPECT_LT(distanceFromOrthonormal(Basis(variables, 4), quadrature), 1e-12);
}

TEST(Quadrature, SparseGridIsOrthonormalWithFewerPoints) {
  for (int dimension = 1; dimension <= 5; ++dimension) {
    for (int order = 0; order <= 4; ++order) {
      const Basis basis(mixedVariables(dimension), order);
      const Quadrature quadrature = sparseQuadrature(basis);
      EXPECT_LT(distanceFromOrthonormal(basis, quadrature), 1e-11) << dimension << " germs, order " << order;
      if (dimension == 5 && order == 3) {
        EXPECT_LT(quadrature.size(), 1024);
      }
    }
  }
}

}  // namespace
}  // namespace harmos::probability
