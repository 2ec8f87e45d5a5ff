#include <cmath>

#include <gtest/gtest.h>

#include <harmos/recovery/Resummation.hpp>

namespace harmos::recovery {
namespace {

/// A part whose elements are too stiff by 1 + b and which adds w to a response on its mesh.
PartShare stiff(double w, double b) {
  return {w * b / (1 + b), w, std::abs(w)};
}

// Springs in series under a force: each grows by its own factor, however much it locks.
TEST(Resummation, IsExactForPartsInSeriesUnderAForce) {
  const ResummedChange found = resummed(1.0, {stiff(0.5, 3.0), stiff(0.3, 0.5), stiff(0.2, 0.0)});
  EXPECT_NEAR(found.change, 0.5 * 3.0 + 0.3 * 0.5, 1e-14);
  EXPECT_FALSE(found.isBeyond);
}

// The same springs, their ends moved by a given amount: the force falls as the compliances add up.
TEST(Resummation, IsExactForTheForceBetweenPartsThatAreMoved) {
  const double force = 8.0;
  const ResummedChange found = resummed(force, {stiff(-0.5 * force, 3.0), stiff(-0.5 * force, 0.5)});
  EXPECT_NEAR(force + found.change, force / (0.5 * 4.0 + 0.5 * 1.5), 1e-13);
}

// The sign of the response does not matter, and a part alone is the case of one mode.
TEST(Resummation, DoesNotDependOnSigns) {
  EXPECT_NEAR(resummed(1.0, {stiff(1.0, 2.0)}).change, 2.0, 1e-14);
  EXPECT_NEAR(resummed(-1.0, {stiff(-1.0, 2.0)}).change, -2.0, 1e-14);
}

// Parts that are too soft, and those whose work cancels, keep their first order.
TEST(Resummation, LeavesTheRestAtFirstOrder) {
  EXPECT_NEAR(resummed(1.0, {{0.1, -0.2, 0.2}}).change, 0.1, 1e-15);
  EXPECT_NEAR(resummed(1.0, {{0.1, 1e-9, 1e9}}).change, 0.1, 1e-9);
  EXPECT_EQ(resummed(0.0, {{0.0, 0.0, 0.0}}).change, 0.0);
}

// A change as large as what a part adds shows no converged value; unless it is small beside the response.
TEST(Resummation, TellsWhereTheConvergedValueIsOutOfSight) {
  EXPECT_TRUE(resummed(1.0, {{0.5, 0.4, 0.4}}).isBeyond);
  EXPECT_TRUE(resummed(-1.0, {{-1.2, -1.3, 1.3}}).isBeyond);
  EXPECT_FALSE(resummed(1.0, {{0.01, 0.005, 0.005}}).isBeyond);
}

}  // namespace
}  // namespace harmos::recovery
