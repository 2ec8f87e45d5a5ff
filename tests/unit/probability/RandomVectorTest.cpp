#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <harmos/base/Error.hpp>
#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/Normal.hpp>
#include <harmos/probability/RandomVector.hpp>
#include <harmos/probability/Uniform.hpp>
#include <harmos/probability/detail/StandardNormal.hpp>

namespace harmos::probability {
namespace {

std::vector<Variable> threeVariables() {
  return {{"k", std::make_shared<Lognormal>(2.0, 0.4)},
          {"mu", std::make_shared<Uniform>(0.1, 0.3)},
          {"gap", std::make_shared<Normal>(1.0, 0.5)}};
}

base::Matrix correlation(double a, double b, double c) {
  base::Matrix matrix(3, 3);
  for (int i = 0; i < 3; ++i) matrix(i, i) = 1.0;
  matrix(0, 1) = matrix(1, 0) = a;
  matrix(0, 2) = matrix(2, 0) = b;
  matrix(1, 2) = matrix(2, 1) = c;
  return matrix;
}

std::string messageOf(const base::Matrix& matrix) {
  try {
    RandomVector(threeVariables(), matrix);
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    return error.what();
  }
  return "";
}

TEST(StandardNormal, IsAccurateFarInTheTails) {
  EXPECT_NEAR(normalCumulative(-8.0) / 6.220960574271784e-16, 1.0, 1e-13);
  EXPECT_NEAR(normalQuantile(1e-12), -7.034483825301131, 1e-12);
  for (const double u : {1e-300, 1e-100, 1e-12, 1e-3, 0.5})
    EXPECT_NEAR(normalCumulative(normalQuantile(u)) / u, 1.0, 1e-12);
  EXPECT_THROW(normalQuantile(0.0), base::Error);
  EXPECT_THROW(normalQuantile(1.0), base::Error);
}

TEST(RandomVector, IndependentParametersHaveTheirOwnGerms) {
  const RandomVector vector(threeVariables());
  EXPECT_TRUE(vector.isIndependent());
  const auto germs = vector.germs({0.5, 0.75, 0.5});
  EXPECT_NEAR(germs[0], 0.0, 1e-15);
  EXPECT_NEAR(germs[1], 0.5, 1e-15);
  const auto values = vector.values(germs);
  EXPECT_NEAR(values[0], 2.0 / std::sqrt(1.04), 1e-14);
  EXPECT_NEAR(values[1], 0.25, 1e-15);
  EXPECT_NEAR(values[2], 1.0, 1e-15);
}

/// z = L xi and X_i = F_i^-1(Phi(z_i)), seen from the outside: sampled germs give the correlations of z and leave every
/// parameter its own law.
TEST(RandomVector, CorrelatedParametersKeepTheirLawsAndHaveTheCorrelationAskedFor) {
  const RandomVector vector(threeVariables(), correlation(0.7, -0.3, 0.2));
  EXPECT_FALSE(vector.isIndependent());
  std::mt19937_64 random(5);
  constexpr int count = 200000;
  double mean[3] = {}, square[3] = {}, products[3] = {};
  for (int s = 0; s < count; ++s) {
    std::vector<double> uniform;
    for (int i = 0; i < 3; ++i) uniform.push_back((static_cast<double>(random() >> 11) + 0.5) / 9007199254740992.0);
    const auto x = vector.values(vector.germs(uniform));
    double z[3];
    for (std::size_t i = 0; i < 3; ++i) {
      mean[i] += x[i] / count;
      square[i] += x[i] * x[i] / count;
      z[i] = normalQuantile(vector.variables()[i].distribution->cumulative(x[i]));
    }
    products[0] += z[0] * z[1] / count;
    products[1] += z[0] * z[2] / count;
    products[2] += z[1] * z[2] / count;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Distribution& distribution = *vector.variables()[i].distribution;
    const double deviation = distribution.standardDeviation();
    EXPECT_NEAR(mean[i], distribution.mean(), 0.01 * deviation);
    EXPECT_NEAR(std::sqrt(square[i] - mean[i] * mean[i]), deviation, 0.01 * deviation);
  }
  EXPECT_NEAR(products[0], 0.7, 0.01);
  EXPECT_NEAR(products[1], -0.3, 0.01);
  EXPECT_NEAR(products[2], 0.2, 0.01);
}

TEST(RandomVector, CorrelatedGermsAreStandardNormalAndReachFarIntoBothTails) {
  const RandomVector vector(threeVariables(), correlation(0.0, 0.0, 0.0));
  EXPECT_DOUBLE_EQ(vector.polynomials(1).b()[3], 3.0);
  const double s = std::sqrt(std::log(1.04));
  for (const double z : {-20.0, -9.0, -1.0, 0.0, 1.0, 9.0, 20.0}) {
    const auto x = vector.values({z, z, z});
    EXPECT_NEAR(x[0] / (2.0 * std::exp(s * z - 0.5 * s * s)), 1.0, 1e-13);
    EXPECT_NEAR(x[1], 0.1 + 0.2 * normalCumulative(z), 1e-15);
    EXPECT_NEAR(x[2], 1.0 + 0.5 * z, 1e-13);
  }
}

TEST(RandomVector, RefusesImpossibleCorrelations) {
  EXPECT_NE(messageOf(correlation(0.9, 0.9, -0.9)).find("not positive definite"), std::string::npos);
  EXPECT_NE(messageOf(correlation(1.0, 0.0, 0.0)).find("\"k\" and \"mu\" must lie between -1 and 1"),
            std::string::npos);
  base::Matrix oneSided = correlation(0.1, 0.2, 0.3);
  oneSided(0, 2) = 0.5;
  EXPECT_NE(messageOf(oneSided).find("\"k\" and \"gap\" must be the same"), std::string::npos);
  base::Matrix scaled = correlation(0.1, 0.2, 0.3);
  scaled(1, 1) = 2.0;
  EXPECT_NE(messageOf(scaled).find("\"mu\" with itself must be 1"), std::string::npos);
  EXPECT_NE(messageOf(base::Matrix(2, 2)).find("3 random parameters"), std::string::npos);
  EXPECT_THROW(RandomVector({}), base::Error);
}

}  // namespace
}  // namespace harmos::probability
