#include <cmath>

#include <gtest/gtest.h>

#include <harmos/parametric/ParametricStudy.hpp>
#include <harmos/parametric/StudySolver.hpp>
#include <harmos/study/StudyCost.hpp>

namespace harmos::study {
namespace {

/// Of a scene whose solved states have 1 MiB each.
scene::CostEstimate sample() {
  scene::CostEstimate cost;
  cost.interfaceUnknowns = 16384;
  cost.steps = 8;
  cost.stages = 10.0;
  cost.stageSeconds = 0.1;
  return cost;
}

/// What a study of so many configurations would take.
StudyCost costOf(int configurations, const scene::CostEstimate& cost = sample(), double accuracy = 1e-3,
                 int sideBySide = 8) {
  Study study;
  study.sideBySide = sideBySide;
  study.scene.solver.accuracy = accuracy;
  for (int i = 0; i < configurations; ++i) study.configurations.push_back({i + 1, {}});
  return estimateStudy(study, cost, static_cast<int>(study.configurations.size()));
}

// Eight of 1000 configurations march side by side, two of 20; each beyond the first has 5 fields of all load steps and
// 60 columns of one.
TEST(StudyCost, CountsSolvedStatesUntilTheirMemoryIsFullAndConfigurationsSideBySide) {
  const double place = 8.0 * 16384.0 * (5.0 * 8.0 + 60.0);
  EXPECT_DOUBLE_EQ(costOf(5).bytes, 5.0 * 1048576.0);
  EXPECT_DOUBLE_EQ(costOf(20).bytes, 20.0 * 1048576.0 + place);
  EXPECT_DOUBLE_EQ(costOf(1000).bytes, parametric::StudySolver::memoryForStates + 7.0 * place);
  EXPECT_DOUBLE_EQ(costOf(20, sample(), 1e-3, 1).bytes, 20.0 * 1048576.0);
  EXPECT_EQ(costOf(1000, sample(), 1e-3, 5).sideBySide, 5);
}

// Calibrations are paid once, and a configuration among others is cheaper than one alone.
TEST(StudyCost, FallsWithTheNumberOfConfigurations) {
  const StudyCost few = costOf(5), some = costOf(50), many = costOf(1000);
  EXPECT_GT(few.stages, some.stages);
  EXPECT_GT(some.stages, many.stages);
  EXPECT_GT(some.seconds, few.seconds);
  EXPECT_GT(many.seconds, some.seconds);
}

// Of as many values of more parameters each is farther from the next; what does not vary keeps none apart.
TEST(StudyCost, GrowsWithTheDistanceOfNeighbours) {
  const auto stages = [](int parameters, bool vary) {
    Study study;
    study.parameters.resize(3);
    for (int i = 0; i < 64; ++i) {
      design::Configuration one{i + 1, std::vector<double>(3, 1.0)};
      for (int p = 0; p < parameters && vary; ++p) one.values[p] = i;
      study.configurations.push_back(one);
    }
    return estimateStudy(study, sample(), static_cast<int>(study.configurations.size())).stages;
  };
  EXPECT_GT(stages(3, true), stages(2, true));
  EXPECT_GT(stages(2, true), stages(1, true));
  EXPECT_EQ(stages(2, false), stages(3, false));
}

// While each is certified by itself, while few march from others, and from where on traces are inverted.
TEST(StudyCost, GrowsWithEveryConfiguration) {
  for (int count = 2; count < 9; ++count) EXPECT_GT(costOf(count + 1).seconds, costOf(count).seconds) << count;
  for (int count = 10; count < 49; ++count) EXPECT_GT(costOf(count + 1).seconds, costOf(count).seconds) << count;
  for (int count = 50; count < 200; ++count) EXPECT_GT(costOf(count + 1).seconds, costOf(count).seconds) << count;
}

// How many an adaptive design adds, its results tell; its limit is known before.
TEST(StudyCost, KnowsHowManyConfigurationsAnAdaptiveDesignMayAdd) {
  Study study;
  study.configurations.assign(5, {});
  EXPECT_EQ(mostConfigurations(study), 5);
  AdaptiveOptions adaptive;
  adaptive.refinement.maximumCount = 200;
  study.design.options = adaptive;
  EXPECT_EQ(mostConfigurations(study), 200);
  InterpolationOptions interpolation;
  interpolation.largestCount = 500;
  interpolation.holdOuts.count = 7;
  study.design.options = interpolation;
  EXPECT_EQ(mostConfigurations(study), 507);
  EXPECT_GT(estimateStudy(study, sample(), 507).seconds, estimateStudy(study, sample(), 5).seconds);
}

// Marches from neighbours read factors in double precision where the accuracy is fine.
TEST(StudyCost, ReadsTwiceAsMuchInDoublePrecision) {
  constexpr double fine = 1e-6;
  const auto difference = [](int configurations, double accuracy) {
    scene::CostEstimate without = sample(), with = sample();
    with.readSeconds = 0.05;
    with.exactSolves = {0.1 / with.steps, 0.1 / with.steps, 0.0};
    return costOf(configurations, with, accuracy).seconds - costOf(configurations, without, accuracy).seconds;
  };
  EXPECT_EQ(difference(9, fine), 0.0);
  EXPECT_NEAR(difference(20, fine), 20.0 * costOf(20, sample(), fine).stages * 0.05, 1e-9);
  EXPECT_EQ(difference(20, 1e-3), 0.0);
}

// Stages that solve for traces leave the rest of a part to be found where something is asked of it.
TEST(StudyCost, CountsLooksAtWholeParts) {
  Study study;
  for (int i = 0; i < 20; ++i) study.configurations.push_back({i + 1, {}});
  scene::CostEstimate looking = sample();
  study.scene.times.assign(static_cast<std::size_t>(looking.steps), 1.0);
  const double without = estimateStudy(study, looking, static_cast<int>(study.configurations.size())).seconds;
  looking.lookSeconds = 1.0;
  EXPECT_GE(estimateStudy(study, looking, static_cast<int>(study.configurations.size())).seconds, without + 20.0);
}

// Every configuration of a few is certified, with 1.8 times the stages of the first one and the square of that in least
// squares; of many those that calibrate.
TEST(StudyCost, CountsStaticsAndLeastSquaresWhereItCertifies) {
  const auto difference = [](int configurations) {
    scene::CostEstimate cost = sample();
    cost.staticsSeconds = 1.0;
    cost.correctionSeconds = 2.0;
    return costOf(configurations, cost).seconds - costOf(configurations).seconds;
  };
  EXPECT_NEAR(difference(5), 5.0 + 2.0 * (1.0 + 4.0 * 1.8 * 1.8), 1e-9);
  EXPECT_NEAR(difference(100), difference(1000), 1e-9);
  EXPECT_LT(difference(100), 30.0);
}

// All responses are asked for three times of a configuration that marches, ten times of one that calibrates, and five
// times of one that is certified.
TEST(StudyCost, CountsEvaluationsOfResponses) {
  const auto evaluations = [](int configurations) {
    scene::CostEstimate cost = sample();
    cost.responseSeconds = 1.0;
    return costOf(configurations, cost).seconds - costOf(configurations).seconds;
  };
  EXPECT_NEAR(evaluations(6), 30.0, 1e-9);
  EXPECT_NEAR(evaluations(50), 50.0 * 3.0 + 5.0 * 7.0, 1e-9);
}

// Curves are in the files, and there are a few copies of their numbers.
TEST(StudyCost, CountsCurves) {
  scene::CostEstimate cost = sample();
  cost.responses = 100.0;
  EXPECT_GT(costOf(20, cost).bytes - costOf(20).bytes, 100.0 * 20.0 * 8.0 * 3.0 * 8.0);
  EXPECT_GT(costOf(20, cost).seconds, costOf(20).seconds);
}

// Where tractions are varied every configuration has loads of its own, and those side by side twice.
TEST(StudyCost, CountsLoadsThatConfigurationsHave) {
  const auto difference = [](int configurations, Effect::Kind kind) {
    Study study;
    study.sideBySide = 8;
    StudyParameter& parameter = study.parameters.emplace_back();
    parameter.effects.emplace_back().kind = kind;
    for (int i = 0; i < configurations; ++i) study.configurations.push_back({i + 1, {1.0 * i}});
    scene::CostEstimate cost = sample();
    const double before = estimateStudy(study, cost, static_cast<int>(study.configurations.size())).seconds;
    cost.loadSeconds = 1.0;
    return estimateStudy(study, cost, static_cast<int>(study.configurations.size())).seconds - before;
  };
  EXPECT_NEAR(difference(6, Effect::Kind::loads), 6.0, 1e-9);
  EXPECT_NEAR(difference(50, Effect::Kind::loads), 100.0, 1e-9);
  EXPECT_EQ(difference(50, Effect::Kind::localStage), 0.0);
}

// The rule by which studies are solved is the one that costs are counted with.
TEST(StudyCost, MarchesWhereTheStudyDoes) {
  for (const latin::Formulation formulation : {latin::Formulation::displacement, latin::Formulation::velocity}) {
    for (const int count : {1, 9, 10, 50}) {
      Study study;
      study.sideBySide = 8;
      study.scene.solver.stages.formulation = formulation;
      for (int i = 0; i < count; ++i) study.configurations.push_back({i + 1, {}});
      scene::CostEstimate cost = sample();
      const double before = estimateStudy(study, cost, static_cast<int>(study.configurations.size())).seconds;
      cost.responseSeconds = 1.0;
      const double evaluations =
          estimateStudy(study, cost, static_cast<int>(study.configurations.size())).seconds - before;
      const bool each = parametric::certifiesEach(study.scene.solver, study.configurations.size());
      EXPECT_EQ(each, count < 10 || formulation == latin::Formulation::velocity);
      EXPECT_EQ(std::abs(evaluations - 5.0 * count) < 1e-9, each) << count;
    }
  }
}

// Finer accuracies take more stages, none beyond those of a certificate by more than calibrations are.
TEST(StudyCost, GrowsWithTheAccuracy) {
  scene::CostEstimate cost = sample();
  cost.stages = 50.0;
  double before = 0.0;
  for (const double accuracy : {1e-2, 1e-3, 1e-5, 1e-8}) {
    const double stages = costOf(200, cost, accuracy).stages;
    EXPECT_GT(stages, before);
    before = stages;
  }
  EXPECT_LT(before, 2.0 * cost.stages);
}

// Marches that take more stages than they may are given up for certificates, which look at all responses more often.
TEST(StudyCost, CertifiesWhatDoesNotComeThrough) {
  const auto evaluations = [](double stages) {
    scene::CostEstimate cost = sample();
    cost.stages = stages;
    const double before = costOf(50, cost, 1e-6).seconds;
    cost.responseSeconds = 1.0;
    return costOf(50, cost, 1e-6).seconds - before;
  };
  EXPECT_NEAR(evaluations(10.0), 50.0 * 3.0 + 5.0 * 7.0, 1e-9);
  EXPECT_NEAR(evaluations(1000.0), 50.0 * 3.0 + 5.0 * 7.0 + 45.0 * 5.0, 1e-9);
}

}  // namespace
}  // namespace harmos::study
