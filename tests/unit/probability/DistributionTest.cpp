#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>

#include <harmos/base/Error.hpp>
#include <harmos/probability/Beta.hpp>
#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/Normal.hpp>
#include <harmos/probability/Sample.hpp>
#include <harmos/probability/TruncatedNormal.hpp>
#include <harmos/probability/Uniform.hpp>
#include <harmos/probability/detail/StandardNormal.hpp>

namespace harmos::probability {
namespace {

std::vector<double> observed() {
  return {1.2, 0.7, 3.1, 0.7, 2.2, 1.9, 5.0, 1.1, 0.9, 1.4};
}

std::vector<std::shared_ptr<const Distribution>> continuous() {
  return {std::make_shared<Normal>(3.0, 0.5),
          std::make_shared<Lognormal>(3.0, 1.5),
          std::make_shared<Uniform>(-1.0, 4.0),
          std::make_shared<Beta>(1.0, 3.0, 2.0, 5.0),
          std::make_shared<TruncatedNormal>(1.0, 0.5, 0.0, std::nullopt),
          std::make_shared<TruncatedNormal>(1.0, 0.5, std::nullopt, 1.1),
          std::make_shared<TruncatedNormal>(1.0, 0.5, 0.4, 1.2),
          std::make_shared<TruncatedNormal>(1.0, 0.5, 5.0, std::nullopt),
          std::make_shared<TruncatedNormal>(1.0, 0.5, std::nullopt, -9.0)};
}

std::vector<std::shared_ptr<const Distribution>> all() {
  auto distributions = continuous();
  distributions.push_back(std::make_shared<Beta>(-1.0, 3.0, 0.5, 0.5));  // infinite density at the bounds
  distributions.push_back(std::make_shared<Sample>(observed()));
  return distributions;
}

std::string labelOf(const Distribution& distribution) {
  return std::string(distribution.name()) + " of mean " + std::to_string(distribution.mean());
}

/// E[f(X)] by the Gauss rule of the germ.
double expectation(const Distribution& distribution, int points, const std::function<double(double)>& f) {
  const GaussRule rule = distribution.polynomials().gauss(points);
  double sum = 0.0;
  for (std::size_t q = 0; q < rule.points.size(); ++q) sum += rule.weights[q] * f(distribution.value(rule.points[q]));
  return sum;
}

double moment(const Distribution& distribution, int power) {
  return expectation(distribution, 30, [&](double x) {
    return std::pow((x - distribution.mean()) / distribution.standardDeviation(), power);
  });
}

TEST(Distribution, RuleOfTheGermHasMeanAndStandardDeviationOfTheParameter) {
  for (const auto& distribution : all()) {
    EXPECT_NEAR(moment(*distribution, 1), 0.0, 1e-11) << labelOf(*distribution);
    EXPECT_NEAR(moment(*distribution, 2), 1.0, 1e-11) << labelOf(*distribution);
  }
}

TEST(Distribution, PolynomialsAreOrthonormal) {
  for (const auto& distribution : all()) {
    const int degree = std::min(20, distribution->polynomials().largestDegree());
    const GaussRule rule = distribution->polynomials().gauss(degree + 1);
    for (std::size_t i = 0; i <= static_cast<std::size_t>(degree); ++i) {
      double norm = 0.0, product = 0.0;
      for (std::size_t q = 0; q < rule.points.size(); ++q) {
        const auto p = distribution->polynomials().evaluate(rule.points[q], degree);
        norm += rule.weights[q] * p[i] * p[i];
        product += rule.weights[q] * p[i] * p[(i + 1) % p.size()];
      }
      EXPECT_NEAR(norm, 1.0, 1e-9) << labelOf(*distribution) << ", degree " << i;
      EXPECT_NEAR(product, 0.0, 1e-9) << labelOf(*distribution) << ", degree " << i;
    }
  }
}

/// The same expectations by two ways that share nothing: the Gauss rule of the germ, and the quantiles at the midpoints
/// of many strata of equal probability.
TEST(Distribution, QuantilesAndRuleDescribeTheSameLaw) {
  constexpr int strata = 20000;
  for (const auto& distribution : all()) {
    const double mean = distribution->mean(), scale = distribution->standardDeviation();
    const auto smooth = [&](double x) { return std::sin((x - mean) / scale) + std::cos((x - mean) / scale); };
    double sum = 0.0;
    for (int i = 0; i < strata; ++i)
      sum += smooth(distribution->value(distribution->germ((i + 0.5) / strata))) / strata;
    EXPECT_NEAR(sum, expectation(*distribution, 40, smooth), 2e-4) << labelOf(*distribution);
  }
}

TEST(Distribution, QuantilesInvertTheCumulativeProbability) {
  for (const auto& distribution : continuous()) {
    for (const double u : {1e-12, 1e-6, 0.01, 0.3, 0.5, 0.9, 0.999}) {
      const double x = distribution->value(distribution->germ(u));
      EXPECT_NEAR(distribution->cumulative(x), u, 1e-13) << labelOf(*distribution);
      const double y = distribution->value(distribution->germExceeded(u));
      EXPECT_NEAR(1.0 - distribution->cumulative(y), u, 1e-13) << labelOf(*distribution);
    }
    EXPECT_LT(distribution->germ(1e-12), distribution->germ(1e-11)) << labelOf(*distribution);
    EXPECT_GT(distribution->germExceeded(1e-12), distribution->germExceeded(1e-11)) << labelOf(*distribution);
    EXPECT_NEAR(distribution->germExceeded(1e-4), distribution->germ(1.0 - 1e-4), 1e-8) << labelOf(*distribution);
  }
}

TEST(Distribution, TailsKeepTheirDigitsWhereTheGermHasThem) {
  const Normal normal(3.0, 0.5);
  const Lognormal lognormal(3.0, 1.5);
  const TruncatedNormal cut(1.0, 0.5, std::nullopt, 1.1);
  for (const double u : {1e-12, 1e-100}) {
    EXPECT_NEAR(normal.cumulative(normal.value(normal.germ(u))) / u, 1.0, 1e-10);
    EXPECT_NEAR(lognormal.cumulative(lognormal.value(lognormal.germ(u))) / u, 1.0, 1e-10);
    EXPECT_NEAR(cut.cumulative(cut.value(cut.germ(u))) / u, 1.0, 1e-10);
    EXPECT_EQ(normal.germExceeded(u), -normal.germ(u));
  }
  // The upper tail of a normal number cut far below is that of the normal number.
  const TruncatedNormal hardlyCut(0.0, 1.0, -30.0, std::nullopt);
  EXPECT_NEAR(hardlyCut.value(hardlyCut.germExceeded(1e-40)), -normalQuantile(1e-40), 1e-12);
}

TEST(Distribution, LawsStayWithinTheirBounds) {
  for (const double u : {1e-300, 1e-17, 0.5}) {
    const Beta beta(1.0, 3.0, 2.0, 5.0);
    const TruncatedNormal cut(1.0, 0.5, 0.4, 1.2);
    for (const double x : {beta.value(beta.germ(u)), beta.value(beta.germExceeded(u))}) {
      EXPECT_GE(x, 1.0);
      EXPECT_LE(x, 3.0);
    }
    for (const double x : {cut.value(cut.germ(u)), cut.value(cut.germExceeded(u))}) {
      EXPECT_GE(x, 0.4 - 1e-15);
      EXPECT_LE(x, 1.2 + 1e-15);
    }
  }
  for (const auto& distribution : all()) {
    EXPECT_EQ(distribution->cumulative(-1e9), 0.0) << labelOf(*distribution);
    EXPECT_EQ(distribution->cumulative(1e9), 1.0) << labelOf(*distribution);
  }
}

TEST(Lognormal, MomentsAndMedian) {
  const Lognormal x(3.0, 1.5);
  EXPECT_NEAR(x.value(0.0), 3.0 / std::sqrt(1.25), 1e-14);
  // Skewness 3 c + c^3 of the coefficient of variation c.
  EXPECT_NEAR(moment(x, 3), 3.0 * 0.5 + 0.125, 1e-10);
  EXPECT_FALSE(x.isAffine());
}

TEST(Beta, MomentsAndCumulativeProbability) {
  const Beta x(0.0, 1.0, 2.0, 5.0);
  EXPECT_NEAR(x.mean(), 2.0 / 7.0, 1e-15);
  EXPECT_NEAR(x.standardDeviation(), std::sqrt(10.0 / (49.0 * 8.0)), 1e-15);
  EXPECT_NEAR(moment(x, 3), 2.0 * 3.0 * std::sqrt(8.0) / (9.0 * std::sqrt(10.0)), 1e-12);
  // 1 - (1 - x)^5 (1 + 5 x) is the cumulative probability of shapes 2 and 5.
  EXPECT_NEAR(x.cumulative(0.3), 1.0 - std::pow(0.7, 5) * 2.5, 1e-14);
}

/// Mean and variance by Johnson, Kotz, Balakrishnan, Continuous Univariate Distributions 1 (1994), sec. 13.10.1.
TEST(TruncatedNormal, MomentsAgreeWithTheClosedForm) {
  const auto density = [](double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::acos(-1.0)); };
  const double bounds[][2] = {{-1.2, 0.4}, {-2.0, 9.0}, {1.0, 2.0}, {-40.0, -0.5}};
  for (const auto& [a, b] : bounds) {
    const double probability = normalCumulative(b) - normalCumulative(a);
    const double shift = (density(a) - density(b)) / probability;
    const double variance = 1.0 + (a * density(a) - b * density(b)) / probability - shift * shift;
    const TruncatedNormal x(10.0, 2.0, 10.0 + 2.0 * a, 10.0 + 2.0 * b);
    EXPECT_NEAR(x.mean(), 10.0 + 2.0 * shift, 1e-12);
    EXPECT_NEAR(x.standardDeviation(), 2.0 * std::sqrt(variance), 1e-12);
  }
  // A bound that cuts nothing off leaves the normal number.
  const TruncatedNormal whole(3.0, 0.5, -100.0, std::nullopt);
  EXPECT_NEAR(whole.mean(), 3.0, 1e-14);
  EXPECT_NEAR(whole.standardDeviation(), 0.5, 1e-14);
  EXPECT_NEAR(whole.polynomials().b()[10], 10.0, 1e-10);
}

TEST(Sample, IsTheEmpiricalLaw) {
  const Sample x(observed());
  EXPECT_NEAR(x.mean(), 1.82, 1e-15);
  EXPECT_NEAR(x.cumulative(0.7), 0.2, 1e-15);
  EXPECT_NEAR(x.cumulative(0.69), 0.0, 1e-15);
  EXPECT_NEAR(x.value(x.germ(0.2)), 0.7, 1e-14);
  EXPECT_NEAR(x.value(x.germ(0.21)), 0.9, 1e-14);
  EXPECT_NEAR(x.value(x.germExceeded(0.05)), 5.0, 1e-14);
  EXPECT_NEAR(x.value(x.germExceeded(0.15)), 3.1, 1e-14);
  EXPECT_NEAR(x.value(x.germExceeded(1.0 - 1e-16)), 0.7, 1e-14);
  EXPECT_EQ(x.polynomials().largestDegree(), 8);
  double third = 0.0;
  for (const double value : observed()) third += std::pow((value - 1.82) / x.standardDeviation(), 3) / 10.0;
  EXPECT_NEAR(moment(x, 3), third, 1e-12);
}

template <class Make>
std::string messageOf(const Make& make) {
  try {
    make();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    return error.what();
  }
  return "accepted";
}

TEST(Distribution, RefusesParametersThatMakeNoSense) {
  const auto says = [](const std::string& message, const std::string& part) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  const double nan = std::nan("");
  says(messageOf([] { Normal(1.0, -0.5); }),
       "Normal distribution: the standard deviation must be at least 0, not -0.5");
  says(messageOf([&] { Normal(nan, 1.0); }), "mean must be a finite number");
  says(messageOf([] { Lognormal(-1.0, 0.5); }), "mean must be above 0, not -1");
  says(messageOf([&] { Lognormal(1.0, nan); }), "standard deviation must be at least 0");
  says(messageOf([] { Uniform(2.0, 2.0); }), "lower bound, 2, must be below the upper bound, 2");
  says(messageOf([] { Beta(3.0, 2.0, 1.0, 1.0); }), "lower bound, 3, must be below");
  says(messageOf([] { Beta(0.0, 1.0, 0.0, 1.0); }), "shape alpha must be above 0, not 0");
  says(messageOf([] { Beta(0.0, 1.0, 1.0, -1.0); }), "shape beta must be above 0, not -1");
  says(messageOf([] { TruncatedNormal(0.0, 1.0, std::nullopt, std::nullopt); }), "give a lower bound");
  says(messageOf([] { TruncatedNormal(0.0, 1.0, 2.0, 1.0); }), "lower bound must be below");
  says(messageOf([] { TruncatedNormal(0.0, 0.0, 2.0, std::nullopt); }), "standard deviation must be above 0");
  says(messageOf([] { TruncatedNormal(0.0, 1.0, 50.0, std::nullopt); }), "bring them nearer to the mean");
  says(messageOf([&] { TruncatedNormal(0.0, 1.0, nan, 1.0); }), "leave it out");
  says(messageOf([] { Sample({2.0, 2.0}); }), "at least two different values");
  says(messageOf([] { Sample({}); }), "at least two different values");
  says(messageOf([&] { Sample({1.0, nan}); }), "finite");
  for (const auto& distribution : all()) {
    for (const double u : {0.0, 1.0, -0.1, nan}) {
      EXPECT_THROW(distribution->germ(u), base::Error) << labelOf(*distribution);
      EXPECT_THROW(distribution->germExceeded(u), base::Error) << labelOf(*distribution);
    }
  }
}

}  // namespace
}  // namespace harmos::probability
