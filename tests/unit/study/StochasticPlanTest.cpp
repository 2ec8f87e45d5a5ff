#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include <harmos/base/Error.hpp>
#include <harmos/study/StochasticPlan.hpp>
#include <harmos/study/StochasticTails.hpp>

#include "RandomStudy.hpp"

namespace harmos::study {
namespace {

using StochasticPlanTest = RandomStudy;

TEST_F(StochasticPlanTest, CollocationSolvesTheQuadratureAndWhatIsHeldOut) {
  const Study found = study({"Design/Order=2", "Design/Hold-Out Count=3"});
  const StochasticPlan& plan = *found.stochastic;
  EXPECT_EQ(plan.method, StochasticPlan::Method::collocation);
  ASSERT_EQ(plan.quadrature.size(), 9);
  ASSERT_EQ(found.configurations.size(), 12u);
  EXPECT_EQ(plan.holdOuts, 3);
  for (std::size_t i = 0; i < found.configurations.size(); ++i) {
    const std::vector<double> values = plan.variables->values(plan.germs[i]);
    const std::vector<double>& all = found.configurations[i].values;
    EXPECT_DOUBLE_EQ(all[plan.places[0]], values[0]);
    EXPECT_DOUBLE_EQ(all[plan.places[1]], values[1]);
    EXPECT_DOUBLE_EQ(all[1], 2.0 * values[0]) << "a derived parameter follows";
  }
}

TEST_F(StochasticPlanTest, SobolSequenceHasFiniteValuesOfTheRightMoments) {
  const Study found = study({"Design/Type=Sobol", "Design/Count=512"});
  double mean = 0.0, square = 0.0;
  for (const design::Configuration& configuration : found.configurations) {
    const double pressure = configuration.values[2];
    ASSERT_TRUE(std::isfinite(pressure));
    mean += pressure / 512.0;
    square += pressure * pressure / 512.0;
  }
  // The rarest of 512 points is at 3 standard deviations: what lies beyond is missing.
  EXPECT_NEAR(mean, 5.0, 0.01);
  EXPECT_NEAR(std::sqrt(square - mean * mean), 1.0, 0.02);
}

TEST_F(StochasticPlanTest, ChaosSolvesOnlyWhatIsHeldOut) {
  const Study found = study({"Design/Type=Chaos", "Design/Hold-Out Count=2"});
  EXPECT_TRUE(found.isChaos());
  EXPECT_EQ(found.configurations.size(), 2u);
  EXPECT_TRUE(study({"Design/Type=Chaos", "Design/Hold-Out Count=0"}).configurations.empty());
}

TEST_F(StochasticPlanTest, ListedPointsNeedNoDistribution) {
  std::ofstream(directory + "/points.csv") << "mu,pressure\n0.1,4\n0.2,5\n";
  const Study found = study({}, directory + "/points.csv");
  EXPECT_EQ(found.stochastic, nullptr);
  ASSERT_EQ(found.configurations.size(), 2u);
  EXPECT_DOUBLE_EQ(found.configurations[1].values[1], 0.4);
}

TEST_F(StochasticPlanTest, SaysHowProbableValuesAreThatAreNotPositive) {
  const auto sentences = describeTails(study({"Parameters/pressure/Distribution/Standard Deviation=2"}));
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_NE(sentences[0].find("P(mu <= 0) = 0"), std::string::npos) << sentences[0];
  // Phi(-2.5), and 1 - 0.4 * 2.334 is left at the outermost of four Gauss points.
  EXPECT_NE(sentences[1].find("P(pressure <= 0) = 0.00621"), std::string::npos) << sentences[1];
  EXPECT_NE(sentences[1].find("WARNING: at the outermost of 4 Gauss points only 6.62"), std::string::npos)
      << sentences[1];
}

TEST_F(StochasticPlanTest, SweepKeepsMeansAndChangesSpread) {
  StochasticPlan plan = *study().stochastic;
  plan.sweeps = {{"d", 0, {0.1, 0.4}, ""}};
  const auto variables = withSpread(plan, {0.4});
  EXPECT_NEAR(variables->variables()[0].distribution->mean(), 0.3, 1e-15);
  EXPECT_NEAR(variables->variables()[0].distribution->standardDeviation(), 0.12, 1e-15);
  EXPECT_NEAR(variables->variables()[1].distribution->standardDeviation(), 1.0, 1e-15);
}

TEST_F(StochasticPlanTest, GalerkinOfParametersThatAreNotAffineTakesMorePoints) {
  const StochasticPlan plan = *study().stochastic;
  EXPECT_EQ(gaussPoints(*plan.variables, 3, 0, false), (std::vector<int>{4, 4}));
  // A normal parameter beside it keeps its own: further out there are only more values that make no sense.
  EXPECT_EQ(gaussPoints(*plan.variables, 3, 0, true), (std::vector<int>{10, 4}));
  EXPECT_EQ(gaussPoints(*plan.variables, 3, 7, true), (std::vector<int>{7, 7}));
}

}  // namespace
}  // namespace harmos::study
