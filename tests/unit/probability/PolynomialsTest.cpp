#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include <harmos/base/Error.hpp>
#include <harmos/probability/Polynomials.hpp>

namespace harmos::probability {
namespace {

double largestOrthonormalityError(const Polynomials& polynomials, int degree) {
  const GaussRule rule = polynomials.gauss(degree + 1);
  double largest = 0.0;
  for (int i = 0; i <= degree; ++i) {
    for (int j = 0; j <= degree; ++j) {
      double product = 0.0;
      for (std::size_t q = 0; q < rule.points.size(); ++q) {
        const auto p = polynomials.evaluate(rule.points[q], degree);
        product += rule.weights[q] * p[i] * p[j];
      }
      largest = std::max(largest, std::abs(product - (i == j ? 1.0 : 0.0)));
    }
  }
  return largest;
}

double moment(const Polynomials& polynomials, int count, int power) {
  const GaussRule rule = polynomials.gauss(count);
  double sum = 0.0;
  for (std::size_t q = 0; q < rule.points.size(); ++q) sum += rule.weights[q] * std::pow(rule.points[q], power);
  return sum;
}

TEST(Polynomials, AreOrthonormalUnderTheirOwnRule) {
  EXPECT_LT(largestOrthonormalityError(Polynomials::hermite(), 30), 1e-12);
  EXPECT_LT(largestOrthonormalityError(Polynomials::legendre(), 30), 1e-12);
  // Exponents that add up to 0 and to -1 are the cases in which the general formula is 0/0.
  for (const auto& [alpha, beta] :
       {std::pair{1.0, 2.5}, {0.0, 0.0}, {-0.5, 0.5}, {-0.5, -0.5}, {-0.25, -0.75}, {20.0, 3.0}, {-0.9, 4.0}})
    EXPECT_LT(largestOrthonormalityError(Polynomials::jacobi(alpha, beta), 30), 1e-9) << alpha << " " << beta;
}

TEST(Polynomials, RulesHaveTheMomentsOfTheirGerm) {
  EXPECT_NEAR(moment(Polynomials::hermite(), 5, 8), 105.0, 1e-11);
  EXPECT_NEAR(moment(Polynomials::legendre(), 5, 8), 1.0 / 9.0, 1e-14);
  // The mean of (1 - x)^alpha (1 + x)^beta on [-1, 1] is (beta - alpha) / (alpha + beta + 2).
  EXPECT_NEAR(moment(Polynomials::jacobi(1.0, 2.5), 3, 1), 1.5 / 5.5, 1e-14);
  // The arcsine law: E[x^4] = 3/8.
  EXPECT_NEAR(moment(Polynomials::jacobi(-0.5, -0.5), 3, 4), 3.0 / 8.0, 1e-14);
}

TEST(Polynomials, HermiteValues) {
  const auto p = Polynomials::hermite().evaluate(0.7, 3);
  EXPECT_NEAR(p[2], (0.49 - 1.0) / std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(p[3], (0.343 - 2.1) / std::sqrt(6.0), 1e-15);
}

TEST(Polynomials, OfADiscreteGermReproduceItsMeasure) {
  const std::vector<double> points{0.3, -1.0, 2.0, 0.3, 5.0}, probabilities{0.1, 0.2, 0.3, 0.2, 0.2};
  const Polynomials polynomials = Polynomials::discrete(points, probabilities);
  EXPECT_EQ(polynomials.largestDegree(), 3);
  EXPECT_LT(largestOrthonormalityError(polynomials, 3), 1e-14);
  // More points than values: the values themselves.
  const GaussRule rule = polynomials.gauss(10);
  ASSERT_EQ(rule.points.size(), 4u);
  EXPECT_NEAR(rule.points[1], 0.3, 1e-14);
  EXPECT_NEAR(rule.weights[1], 0.3, 1e-14);
  EXPECT_NEAR(rule.weights[3], 0.2, 1e-14);
}

TEST(Polynomials, OfManyEvenlySpacedValuesStayOrthonormal) {
  std::vector<double> points;
  for (int i = 0; i < 60; ++i) points.push_back(-1.0 + i / 30.0);
  const std::vector<double> probabilities(60, 1.0 / 60.0);
  const Polynomials polynomials = Polynomials::discrete(points, probabilities);
  EXPECT_EQ(polynomials.largestDegree(), 59);
  const GaussRule rule = polynomials.gauss(60);
  for (std::size_t i = 0; i < 60; ++i) {
    EXPECT_NEAR(rule.points[i], points[i], 1e-12);
    EXPECT_NEAR(rule.weights[i], 1.0 / 60.0, 1e-9);
  }
}

TEST(Polynomials, FollowFromTheirRecurrence) {
  const Polynomials jacobi = Polynomials::jacobi(1.5, 0.5);
  const Polynomials again = Polynomials::recurrence(jacobi.a(), jacobi.b());
  EXPECT_EQ(again.largestDegree(), jacobi.largestDegree());
  EXPECT_EQ(again.evaluate(0.3, 7), jacobi.evaluate(0.3, 7));
  EXPECT_THROW(Polynomials::recurrence({}, {}), base::Error);
  EXPECT_THROW(Polynomials::recurrence({0.0, 0.0}, {1.0}), base::Error);
  EXPECT_THROW(Polynomials::recurrence({0.0, 0.0}, {1.0, -1.0}), base::Error);
}

TEST(Polynomials, RefuseWhatTheyDoNotKnow) {
  const Polynomials coin = Polynomials::discrete({0.0, 1.0}, {0.5, 0.5});
  EXPECT_THROW(coin.evaluate(0.5, 2), base::Error);
  EXPECT_THROW(Polynomials::hermite().gauss(0), base::Error);
  EXPECT_THROW(Polynomials::hermite().gauss(1000), base::Error);
  EXPECT_THROW(Polynomials::jacobi(-1.0, 0.0), base::Error);
  EXPECT_THROW(Polynomials::discrete({0.0, 1.0}, {0.5, 0.6}), base::Error);
  EXPECT_THROW(Polynomials::discrete({0.0, 1.0}, {1.5, -0.5}), base::Error);
  EXPECT_THROW(Polynomials::discrete({0.0, 1.0}, {1.0}), base::Error);
}

}  // namespace
}  // namespace harmos::probability
