#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <harmos/probability/SampledSobolIndices.hpp>

namespace harmos::probability {
namespace {

using Points = std::vector<std::vector<double>>;

constexpr double pi = 3.14159265358979323846;

Points uniformPoints(int count, std::mt19937_64& engine) {
  std::uniform_real_distribution<double> uniform(-pi, pi);
  Points points(static_cast<std::size_t>(count), std::vector<double>(3));
  for (auto& point : points) {
    for (double& x : point) x = uniform(engine);
  }
  return points;
}

/// Ishigami's function, and a constant.
Points responses(const Points& points) {
  Points values(2);
  for (const auto& x : points) {
    values[0].push_back(std::sin(x[0]) * (1.0 + 0.1 * std::pow(x[2], 4)) + 7.0 * std::pow(std::sin(x[1]), 2));
    values[1].push_back(2.0);
  }
  return values;
}

/// The standard errors of 40 000 points are about 0.01; three of them are allowed.
TEST(SampledSobolIndices, Ishigami) {
  std::mt19937_64 engine(1);
  const Points a = uniformPoints(40000, engine), b = uniformPoints(40000, engine);
  const auto indices = sobolIndices(responses, a, b);
  ASSERT_EQ(indices.size(), 2u);
  const double main[] = {0.3139051911, 0.4424111448, 0.0}, total[] = {0.5575888552, 0.4424111448, 0.2436836641};
  ASSERT_EQ(indices[0].size(), 3u);
  for (int germ = 0; germ < 3; ++germ) {
    const SobolIndex& index = indices[0][germ];
    EXPECT_EQ(index.germs, std::vector<int>{germ});
    EXPECT_NEAR(index.main, main[germ], 0.03) << germ;
    EXPECT_NEAR(index.total, total[germ], 0.03) << germ;
    EXPECT_TRUE(std::isnan(indices[1][germ].main)) << "a constant has no shares of variance";
  }
}

}  // namespace
}  // namespace harmos::probability
