#include <gtest/gtest.h>

#include <harmos/scene/JoinedMeshes.hpp>

namespace harmos::scene {
namespace {

TEST(JoinedMeshes, WarnsOfFacesThatAreLeftOut) {
  JoinedMeshes joined{"seal", 0, 20, {}, true, true};
  EXPECT_TRUE(joined.warnings().empty());
  joined.report.given = {12, 16};
  joined.report.beyondReach = {3, 4};
  joined.report.nearestBeyond = 0.3125;
  ASSERT_EQ(joined.warnings().size(), 1u);
  EXPECT_EQ(joined.warnings()[0],
            "interface \"seal\": 3 of 12 faces of side 1 and 4 of 16 of side 2 lie opposite each other too far apart, "
            "from a distance of 0.312 on, and are left out. Raise Search Distance to join them, or take them out of "
            "the side sets.");
  joined.isOfSideSets = false;  // all faces of two parts: nobody has asked for these
  EXPECT_TRUE(joined.warnings().empty());
}

TEST(JoinedMeshes, WarnsOfPartsThatOverlap) {
  JoinedMeshes joined{"seal", 0, 20, {}, true, true};
  joined.report.spacing = 1.0;
  joined.report.largestOverlap = 0.05;  // facets
  EXPECT_TRUE(joined.warnings().empty());
  joined.report.largestOverlap = 0.25;
  ASSERT_EQ(joined.warnings().size(), 1u);
  EXPECT_EQ(joined.warnings()[0],
            "interface \"seal\": the parts overlap by up to 0.25, which presses them apart as an interference does. "
            "With Gap = Closed it does not count.");
  joined.hasGaps = false;  // glue holds what lies on each other as it is
  EXPECT_TRUE(joined.warnings().empty());
  joined.hasGaps = true;
  joined.report.closed = 3;
  EXPECT_TRUE(joined.warnings().empty());
}

}  // namespace
}  // namespace harmos::scene
