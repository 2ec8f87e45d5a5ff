#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <harmos/base/Error.hpp>
#include <harmos/probability/Expansion.hpp>
#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/Normal.hpp>
#include <harmos/probability/Quadrature.hpp>
#include <harmos/probability/Uniform.hpp>

namespace harmos::probability {
namespace {

template <class Function>
Expansion project(const std::shared_ptr<const Basis>& basis, const Quadrature& quadrature, const Function& function) {
  std::vector<double> values;
  for (const auto& germs : quadrature.points) values.push_back(function(basis->variables().values(germs)));
  return project(basis, quadrature, values);
}

std::shared_ptr<const Basis> springs(int order) {
  return std::make_shared<Basis>(
      std::make_shared<RandomVector>(std::vector<Variable>{{"k1", std::make_shared<Lognormal>(2.0, 0.4)},
                                                           {"k2", std::make_shared<Lognormal>(5.0, 1.25)}}),
      order);
}

double seriesDisplacement(const std::vector<double>& k) {
  return 1.0 / k[0] + 1.0 / k[1];
}

Expansion seriesExpansion(int order) {
  const auto basis = springs(order);
  return project(basis, tensorQuadrature(basis->variables(), order + 6), seriesDisplacement);
}

/// Exact, of the sum of two independent lognormal numbers.
constexpr double springMean = 0.7325, springDeviation = 0.116782985169, springSkewness = 0.501476076602,
                 springKurtosis = 3.463260496861, springMainIndex = 0.793062717606;

TEST(Expansion, TwoRandomSpringsInSeries) {
  const Expansion u = seriesExpansion(8);
  EXPECT_NEAR(u.mean(), springMean, 1e-12);
  EXPECT_NEAR(u.standardDeviation(), springDeviation, 1e-12);
  EXPECT_NEAR(u.skewness(), springSkewness, 1e-10);
  EXPECT_NEAR(u.kurtosis(), springKurtosis, 1e-9);
  const auto indices = sobolIndices(u);
  ASSERT_EQ(indices.size(), 3u);
  EXPECT_NEAR(indices[0].main, springMainIndex, 1e-10);
  EXPECT_NEAR(indices[0].main + indices[1].main, 1.0, 1e-12);
  EXPECT_NEAR(indices[2].main, 0.0, 1e-12);
  EXPECT_LT(u.lastDegreeShare(), 1e-12);
  EXPECT_NEAR(u.evaluate({1.0, -0.5}), seriesDisplacement(u.basis().variables().values({1.0, -0.5})), 1e-6);
}

TEST(Expansion, TruncationAtOrderThreeCostsTheKnownShareOfTheVariance) {
  const Expansion u = seriesExpansion(3);
  EXPECT_NEAR(std::pow(u.standardDeviation() / springDeviation, 2), 0.999996143397, 1e-10);
  // The last degree that is there tells of those that are not.
  EXPECT_GT(u.lastDegreeShare(), 1.0 - 0.999996143397);
}

/// sin x1 + a sin^2 x2 + b x3^4 sin x1.
TEST(Expansion, Ishigami) {
  const double pi = std::acos(-1.0);
  const auto x = std::make_shared<Uniform>(-pi, pi);
  const auto basis = std::make_shared<Basis>(
      std::make_shared<RandomVector>(std::vector<Variable>{{"x1", x}, {"x2", x}, {"x3", x}}), 12);
  const Expansion y = project(basis, tensorQuadrature(basis->variables(), 14), [](const std::vector<double>& v) {
    return std::sin(v[0]) * (1.0 + 0.1 * std::pow(v[2], 4)) + 7.0 * std::pow(std::sin(v[1]), 2);
  });
  EXPECT_NEAR(y.mean(), 3.5, 1e-4);
  EXPECT_NEAR(std::pow(y.standardDeviation(), 2), 13.8445879407, 1e-3);
  const auto indices = sobolIndices(y);
  ASSERT_EQ(indices.size(), 7u);
  EXPECT_NEAR(indices[0].main, 0.3139051911, 1e-4);
  EXPECT_NEAR(indices[1].main, 0.4424111448, 1e-4);
  EXPECT_NEAR(indices[2].main, 0.0, 1e-8);
  EXPECT_EQ(indices[4].germs, (std::vector<int>{0, 2}));
  EXPECT_NEAR(indices[4].main, 0.2436836641, 1e-4);
  EXPECT_NEAR(indices[0].total, 0.3139051911 + 0.2436836641, 1e-4);
  EXPECT_NEAR(indices[2].total, 0.2436836641, 1e-4);
}

/// The cube of a standard normal number: moments of order 12.
TEST(Expansion, HigherMomentsOfAPolynomialAreExact) {
  const auto basis = std::make_shared<Basis>(
      std::make_shared<RandomVector>(std::vector<Variable>{{"x", std::make_shared<Normal>(0.0, 1.0)}}), 3);
  const Expansion cube = project(basis, tensorQuadrature(basis->variables(), 4),
                                 [](const std::vector<double>& x) { return x[0] * x[0] * x[0]; });
  EXPECT_NEAR(cube.standardDeviation(), std::sqrt(15.0), 1e-12);
  EXPECT_NEAR(cube.skewness(), 0.0, 1e-12);
  EXPECT_NEAR(cube.kurtosis(), 10395.0 / 225.0, 1e-10);
}

/// Chi squared with eight degrees of freedom, less 4: the sum of the squares of eight standard normal numbers.
TEST(Expansion, HigherMomentsInManyGerms) {
  constexpr std::size_t germs = 8;
  const std::vector<Variable> variables(germs, {"x", std::make_shared<Normal>(0.0, 1.0)});
  const auto basis = std::make_shared<Basis>(std::make_shared<RandomVector>(variables), 3);
  std::vector<double> coefficients(basis->size(), 0.0);
  coefficients[0] = 4.0;
  for (std::size_t a = 1; a < coefficients.size(); ++a) {
    const auto& index = basis->indices()[a];
    if (std::count(index.begin(), index.end(), 2) == 1 && std::count(index.begin(), index.end(), 0) == germs - 1)
      coefficients[a] = std::sqrt(2.0);
  }
  const Expansion sum(basis, coefficients);
  EXPECT_NEAR(sum.standardDeviation(), 4.0, 1e-12);
  EXPECT_NEAR(sum.skewness(), 1.0, 1e-10);
  EXPECT_NEAR(sum.kurtosis(), 3.0 + 12.0 / 8.0, 1e-10);
}

/// A response of one germ has the same moments whether the basis knows of five others or not.
TEST(Expansion, HigherMomentsDoNotDependOnTheWayTheyAreComputed) {
  const auto moments = [](std::size_t germs) {
    const std::vector<Variable> variables(germs, {"k", std::make_shared<Uniform>(0.0, 1.0)});
    const auto basis = std::make_shared<Basis>(std::make_shared<RandomVector>(variables), 4);
    std::vector<double> coefficients(basis->size(), 0.0);
    for (std::size_t a = 0; a < coefficients.size(); ++a) {
      const auto& index = basis->indices()[a];
      if (std::count(index.begin() + 1, index.end(), 0) == static_cast<std::ptrdiff_t>(germs) - 1)
        coefficients[a] = 1.0 / (1.0 + index[0]);
    }
    const Expansion expansion(basis, coefficients);
    return std::pair{expansion.skewness(), expansion.kurtosis()};
  };
  EXPECT_NEAR(moments(6).first, moments(1).first, 1e-10);
  EXPECT_NEAR(moments(6).second, moments(1).second, 1e-10);
}

TEST(Expansion, OfAConstantHasNoSharesOfItsVariance) {
  const auto basis = springs(2);
  const Expansion constant(basis, {4.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  EXPECT_EQ(constant.standardDeviation(), 0.0);
  EXPECT_TRUE(std::isnan(constant.skewness()));
  EXPECT_TRUE(std::isnan(constant.kurtosis()));
  EXPECT_TRUE(std::isnan(constant.lastDegreeShare()));
  for (const auto& index : sobolIndices(constant)) {
    EXPECT_TRUE(std::isnan(index.main));
    EXPECT_TRUE(std::isnan(index.total));
  }
}

TEST(Expansion, NeedsOneCoefficientPerPolynomial) {
  EXPECT_THROW(Expansion(springs(2), {1.0, 2.0}), base::Error);
}

}  // namespace
}  // namespace harmos::probability
