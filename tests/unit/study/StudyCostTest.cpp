#include <gtest/gtest.h>

#include <harmos/parametric/StudySolver.hpp>
#include <harmos/study/StudyCost.hpp>

namespace harmos::study {
namespace {

/// What a study of so many configurations would take, of a scene whose solved states have 1 MiB each.
StudyCost costOf(int configurations) {
  Study study;
  for (int i = 0; i < configurations; ++i) study.configurations.push_back({i + 1, {}});
  scene::CostEstimate cost;
  cost.interfaceUnknowns = 16384;
  cost.steps = 8;
  cost.stages = 10.0;
  cost.stageSeconds = 0.1;
  return estimateStudy(study, cost, nullptr);
}

// Eight of 1000 configurations march side by side, two of 20; each beyond the first has 5 fields of all load steps and
// 60 columns of one.
TEST(StudyCost, CountsSolvedStatesUntilTheirMemoryIsFullAndConfigurationsSideBySide) {
  const double place = 8.0 * 16384.0 * (5.0 * 8.0 + 60.0);
  EXPECT_DOUBLE_EQ(costOf(5).bytes, 5.0 * 1048576.0);
  EXPECT_DOUBLE_EQ(costOf(20).bytes, 20.0 * 1048576.0 + place);
  EXPECT_DOUBLE_EQ(costOf(1000).bytes, parametric::StudySolver::memoryForStates + 7.0 * place);
}

// Calibrations are paid once, and a configuration among others is cheaper than one alone.
TEST(StudyCost, FallsWithTheNumberOfConfigurations) {
  const StudyCost few = costOf(5), some = costOf(50), many = costOf(1000);
  EXPECT_GT(few.stages, some.stages);
  EXPECT_GT(some.stages, many.stages);
  EXPECT_GT(some.seconds, few.seconds);
  EXPECT_GT(many.seconds, some.seconds);
}

}  // namespace
}  // namespace harmos::study
