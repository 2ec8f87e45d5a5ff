#include <harmos/latin/CorrectionTargets.hpp>

#include <gtest/gtest.h>

namespace harmos::latin {
namespace {

// Of the residual of each load step by itself, but for those that no load step is brought below.
TEST(CorrectionTargets, CountWhatEachLoadStepKeeps) {
  CorrectionTargets targets(4);
  const double before[] = {1.0, 0.2, 0.01, 1e-12}, left[] = {0.2, 0.19, 0.01, 1e-12};
  for (int t = 0; t < 4; ++t) targets.start(t, before[t]);
  CorrectionTargets::Goal goal{0.3};
  goal.isLater = true;
  targets.aimAt(goal);
  for (int t = 0; t < 4; ++t) targets[t].residual = left[t];
  const std::vector<double> shares = targets.sharesLeft(1e-10);
  EXPECT_DOUBLE_EQ(shares[0], 0.2);
  EXPECT_DOUBLE_EQ(shares[1], 0.95);
  EXPECT_DOUBLE_EQ(shares[2], 0.3);
  EXPECT_EQ(shares[3], 0.0);
  EXPECT_DOUBLE_EQ(targets.reduction(1e-10), 0.2);
}

// Only later corrections ask something of every load step, until many directions have not been enough.
TEST(CorrectionTargets, AskEveryLoadStepToMove) {
  CorrectionTargets targets(2);
  targets.start(0, 1.0);
  targets.start(1, 0.2);
  CorrectionTargets::Goal goal{0.3};
  targets.aimAt(goal);
  EXPECT_DOUBLE_EQ(targets.of(1), 0.3);
  goal.isLater = true;
  targets.aimAt(goal);
  EXPECT_DOUBLE_EQ(targets.of(0), 0.3);
  EXPECT_DOUBLE_EQ(targets.of(1), 0.06);
  targets[1].directions = 19;
  EXPECT_DOUBLE_EQ(targets.of(1), 0.06);
  targets[1].directions = 20;
  EXPECT_DOUBLE_EQ(targets.of(1), 0.3);
}

}  // namespace
}  // namespace harmos::latin
