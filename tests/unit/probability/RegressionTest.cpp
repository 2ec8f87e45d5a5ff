#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <harmos/base/Error.hpp>
#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/Regression.hpp>
#include <harmos/probability/Uniform.hpp>

namespace harmos::probability {
namespace {

using Points = std::vector<std::vector<double>>;

std::shared_ptr<const Basis> basisOf(int order) {
  return std::make_shared<Basis>(
      std::make_shared<RandomVector>(std::vector<Variable>{{"k", std::make_shared<Lognormal>(2.0, 0.4)},
                                                           {"mu", std::make_shared<Uniform>(0.1, 0.3)}}),
      order);
}

Points samples(const Basis& basis, int count) {
  std::mt19937_64 random(3);
  const auto uniform = [&random] { return (static_cast<double>(random() >> 11) + 0.5) / 9007199254740992.0; };
  Points points;
  for (int s = 0; s < count; ++s) {
    const double first = uniform();
    points.push_back(basis.variables().germs({first, uniform()}));
  }
  return points;
}

double response(const std::vector<double>& germs) {
  return std::exp(0.3 * germs[0]) * (1.0 + 0.5 * germs[1]);
}

std::vector<double> responses(const Points& points) {
  std::vector<double> values;
  for (const auto& point : points) values.push_back(response(point));
  return values;
}

TEST(Regression, FindsTheCoefficientsOfAnExpansion) {
  const auto basis = basisOf(3);
  const Points points = samples(*basis, 40);
  std::vector<double> coefficients;
  for (int a = 0; a < basis->size(); ++a) coefficients.push_back(1.0 / (1.0 + a));
  const Expansion exact(basis, coefficients);
  std::vector<double> values;
  for (const auto& point : points) values.push_back(exact.evaluate(point));
  const auto fit = Regression(basis, points).fit(values);
  for (std::size_t a = 0; a < coefficients.size(); ++a)
    EXPECT_NEAR(fit.expansion.coefficients()[a], coefficients[a], 1e-11);
  EXPECT_LT(fit.leaveOneOutError, 1e-11);
}

TEST(Regression, ApproachesTheMomentsOfASmoothResponse) {
  const auto basis = basisOf(4);
  const Points points = samples(*basis, 100);
  const auto fit = Regression(basis, points).fit(responses(points));
  const double square = std::exp(0.18) * (1.0 + 0.25 / 3.0);
  EXPECT_NEAR(fit.expansion.mean(), std::exp(0.045), 1e-4);
  EXPECT_NEAR(fit.expansion.standardDeviation(), std::sqrt(square - std::exp(0.09)), 1e-3);
}

TEST(Regression, LeaveOneOutErrorIsThatOfFitsWithoutOneSample) {
  const auto basis = basisOf(2);
  const Points points = samples(*basis, 15);
  const std::vector<double> values = responses(points);
  double sum = 0.0, mean = 0.0, variance = 0.0;
  for (std::size_t s = 0; s < points.size(); ++s) {
    Points others = points;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(s));
    const double difference =
        Regression(basis, others).fit(responses(others)).expansion.evaluate(points[s]) - values[s];
    sum += difference * difference / 15.0;
    mean += values[s] / 15.0;
  }
  for (const double value : values) variance += (value - mean) * (value - mean) / 14.0;
  EXPECT_NEAR(Regression(basis, points).fit(values).leaveOneOutError / std::sqrt(sum / variance), 1.0, 1e-10);
}

TEST(Regression, LeaveOneOutErrorIsNotKnownWithoutVarianceOrWithoutSpareSamples) {
  const auto basis = basisOf(2);
  const Points points = samples(*basis, 6);
  EXPECT_TRUE(std::isnan(Regression(basis, points).fit(responses(points)).leaveOneOutError));
  const Regression many(basis, samples(*basis, 20));
  const auto constant = many.fit(std::vector<double>(20, 0.1));
  EXPECT_TRUE(std::isnan(constant.leaveOneOutError));
  EXPECT_NEAR(constant.expansion.mean(), 0.1, 1e-14);
}

TEST(Regression, RefusesSamplesThatDoNotDetermineTheFit) {
  const auto basis = basisOf(2);
  EXPECT_THROW(Regression(basis, samples(*basis, 5)), base::Error);
  EXPECT_THROW(Regression(basis, Points(20, {0.1, 0.2})), base::Error);
  EXPECT_THROW(Regression(basis, samples(*basis, 10)).fit({1.0, 2.0}), base::Error);
}

}  // namespace
}  // namespace harmos::probability
