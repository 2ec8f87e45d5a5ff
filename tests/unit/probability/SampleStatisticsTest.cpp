#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <harmos/base/Error.hpp>
#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/SampleStatistics.hpp>

namespace harmos::probability {
namespace {

std::vector<double> drawn(const Distribution& distribution, int count, int seed) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double u = (static_cast<double>(random() >> 11) + 0.5) / 9007199254740992.0;
    values.push_back(distribution.value(distribution.germ(u)));
  }
  return values;
}

TEST(SampleStatistics, MomentsByHand) {
  const SampleStatistics sample({4.0, 1.0, 2.0, 9.0});
  EXPECT_EQ(sample.count(), 4);
  EXPECT_DOUBLE_EQ(sample.mean(), 4.0);
  EXPECT_DOUBLE_EQ(sample.standardDeviation(), std::sqrt(38.0 / 3.0));
  EXPECT_DOUBLE_EQ(sample.meanError(), std::sqrt(38.0 / 12.0));
  EXPECT_NEAR(sample.skewness(), 22.5 / std::pow(9.5, 1.5), 1e-14);
  EXPECT_NEAR(sample.kurtosis(), 180.5 / 90.25, 1e-14);
  EXPECT_DOUBLE_EQ(sample.quantile(0.0), 1.0);
  EXPECT_DOUBLE_EQ(sample.quantile(0.5), 3.0);
  EXPECT_DOUBLE_EQ(sample.quantile(1.0), 9.0);
  EXPECT_DOUBLE_EQ(sample.cumulative(2.0), 0.5);
  EXPECT_DOUBLE_EQ(sample.cumulative(0.9), 0.0);
}

/// The scatter of many samples' means and standard deviations is what each sample says its errors are.
TEST(SampleStatistics, StandardErrorsAreTheScatterOfRepetitions) {
  const Lognormal law(2.0, 0.4);
  std::vector<double> means, deviations;
  double meanError = 0.0, deviationError = 0.0;
  constexpr int repetitions = 1000;
  for (int seed = 0; seed < repetitions; ++seed) {
    const SampleStatistics sample(drawn(law, 400, seed));
    means.push_back(sample.mean());
    deviations.push_back(sample.standardDeviation());
    meanError += sample.meanError() / repetitions;
    deviationError += sample.standardDeviationError() / repetitions;
  }
  EXPECT_NEAR(SampleStatistics(means).standardDeviation() / meanError, 1.0, 0.08);
  EXPECT_NEAR(SampleStatistics(deviations).standardDeviation() / deviationError, 1.0, 0.08);
}

TEST(SampleStatistics, DensityIsThatOfTheLawAndIntegratesToOne) {
  const SampleStatistics sample(drawn(Lognormal(2.0, 0.4), 20000, 1));
  const DensityCurve curve = sample.density(400);
  ASSERT_EQ(curve.points.size(), 400u);
  const double s2 = std::log(1.04), m = std::log(2.0) - 0.5 * s2;
  double sum = 0.0;
  for (std::size_t i = 0; i < 400; ++i) {
    const double x = curve.points[i];
    sum += curve.values[i] * (curve.points[1] - curve.points[0]);
    if (x > 0.0) {
      const double exact =
          std::exp(-0.5 * std::pow(std::log(x) - m, 2) / s2) / (x * std::sqrt(2.0 * std::acos(-1.0) * s2));
      EXPECT_NEAR(curve.values[i], exact, 0.08);
    }
  }
  EXPECT_NEAR(sum, 1.0, 1e-3);
}

TEST(SampleStatistics, DensityOfValuesThatAreMostlyEqual) {
  std::vector<double> values(50, 1.0);
  values.push_back(2.0);
  const DensityCurve curve = SampleStatistics(values).density(50);
  for (const double value : curve.values) EXPECT_TRUE(std::isfinite(value));
}

TEST(SampleStatistics, KolmogorovSmirnovDistance) {
  const SampleStatistics a({1.0, 2.0, 3.0, 4.0}), b({2.5, 3.5, 4.5, 5.5});
  EXPECT_DOUBLE_EQ(largestDifference(a, b), 0.5);
  EXPECT_DOUBLE_EQ(largestDifference(b, a), 0.5);
  EXPECT_DOUBLE_EQ(largestDifference(a, a), 0.0);
  EXPECT_DOUBLE_EQ(largestDifference(a, SampleStatistics({7.0})), 1.0);
  const Lognormal law(2.0, 0.4);
  // 1.63 sqrt(2 / n) is exceeded once in a hundred times.
  EXPECT_LT(largestDifference(SampleStatistics(drawn(law, 5000, 1)), SampleStatistics(drawn(law, 5000, 2))), 0.0326);
}

TEST(SampleStatistics, WithoutVarianceWhatIsDividedByItIsNotANumber) {
  const SampleStatistics equal({0.1, 0.1, 0.1});
  EXPECT_EQ(equal.mean(), 0.1);
  EXPECT_EQ(equal.standardDeviation(), 0.0);
  EXPECT_EQ(equal.meanError(), 0.0);
  EXPECT_TRUE(std::isnan(equal.skewness()));
  EXPECT_TRUE(std::isnan(equal.kurtosis()));
  EXPECT_TRUE(std::isnan(equal.standardDeviationError()));
  EXPECT_EQ(equal.quantile(0.3), 0.1);
  EXPECT_TRUE(equal.density(10).points.empty());
  const SampleStatistics one({3.0});
  EXPECT_EQ(one.mean(), 3.0);
  EXPECT_TRUE(std::isnan(one.standardDeviation()));
  EXPECT_TRUE(one.density(10).points.empty());
}

TEST(SampleStatistics, RefusesWhatIsNoSample) {
  EXPECT_THROW(SampleStatistics({}), base::Error);
  EXPECT_THROW(SampleStatistics({1.0, std::nan("")}), base::Error);
  EXPECT_THROW(SampleStatistics({1.0, 2.0}).quantile(1.5), base::Error);
  EXPECT_THROW(SampleStatistics({1.0, 2.0}).density(1), base::Error);
}

}  // namespace
}  // namespace harmos::probability
