#include <cmath>

#include <gtest/gtest.h>

#include <harmos/laws/AffineComponent.hpp>

#include "MakeLaw.hpp"

namespace harmos::laws {
namespace {

// Lines much stiffer and much softer than the laws, which are not rigid beside them.
constexpr double compliances[] = {1e-12, 1e-5, 1.0, 1e4};

TEST(AffineComponent, OfSpringsIsExactOnAnyLine) {
  const auto law = makeLaw("Elastic Foundation", {{"Normal Stiffness", 3e7}, {"Tangential Stiffness", 2e-3}});
  for (const double compliance : compliances) {
    const auto components = affineComponents(*law, 0, compliance);
    EXPECT_NEAR(components[0].stiffness, 3e7, 1e-12 * 3e7) << compliance;
    EXPECT_NEAR(components[1].stiffness, 2e-3, (compliance < 1e-6 ? 1e-3 : 1e-9) * 2e-3) << compliance;
    EXPECT_EQ(components[0].offset, 0.0);
  }
}

// Springs of 10 MPa/mm are 1e13 in SI units, and stiffer in smaller ones; what is rigid is so in all.
TEST(AffineComponent, OfSpringsDoesNotDependOnUnits) {
  for (const double stiffness : {1e-20, 1.0, 1e11, 1e13, 1e25, 1e45}) {
    const auto springs =
        makeLaw("Elastic Foundation", {{"Normal Stiffness", stiffness}, {"Tangential Stiffness", 0.0}});
    const auto components = affineComponents(*springs, 0);
    EXPECT_NEAR(components[0].stiffness, stiffness, 1e-9 * stiffness);
    EXPECT_EQ(components[1].stiffness, 0.0);
  }
  const auto held = affineComponents(*makeLaw("Prescribed Displacement", {{"X", 2e-7}}), 0);
  EXPECT_TRUE(std::isinf(held[0].stiffness));
  EXPECT_EQ(held[0].offset, -2e-7);
}

// A way that is huge beside the compliance of the line hides neither that the law is rigid nor its own digits.
TEST(AffineComponent, OfAPrescribedDisplacementIsRigidHoweverFarItIs) {
  for (const double way : {0.0, 1e-9, 1.0, 5e3, -1e8}) {
    const auto law = makeLaw("Prescribed Displacement", {{"X", way}});
    for (const double compliance : compliances) {
      const auto components = affineComponents(*law, 0, compliance);
      EXPECT_TRUE(std::isinf(components[0].stiffness)) << way << " " << compliance;
      EXPECT_NEAR(components[0].offset, -way, 1e-14 * std::abs(way));
      EXPECT_EQ(components[1].stiffness, 0.0);
      EXPECT_EQ(components[1].offset, 0.0);
    }
  }
}

}  // namespace
}  // namespace harmos::laws
