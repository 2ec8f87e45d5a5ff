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
  joined.report.overlapPlace = {1.0, 2.0, 3.0};
  ASSERT_EQ(joined.warnings().size(), 1u);
  EXPECT_EQ(joined.warnings()[0],
            "interface \"seal\": the parts overlap by up to 0.25 at (1, 2, 3), which presses them apart as an "
            "interference does. "
            "With Gap = Closed it does not count.");
  joined.hasGaps = false;  // glue holds what lies on each other as it is
  EXPECT_TRUE(joined.warnings().empty());
  joined.hasGaps = true;
  joined.report.closed = 3;
  EXPECT_TRUE(joined.warnings().empty());
}

TEST(JoinedMeshes, WarnsOfGapsThatFacetsAloneCanMake) {
  JoinedMeshes joined{"seal", 0, 20, {}, true, true};
  joined.report.spacing = 1.0;
  joined.report.largestGap = 0.02;
  EXPECT_TRUE(joined.warnings().empty());  // flat faces: the gap is meant
  joined.report.sagitta = 0.01;
  EXPECT_TRUE(joined.warnings().empty());  // more than facets can make
  joined.report.sagitta = 0.025;
  ASSERT_EQ(joined.warnings().size(), 1u);
  EXPECT_EQ(
      joined.warnings()[0],
      "interface \"seal\": its faces are facets that lie up to 0.025 off the curved surfaces they stand for; that "
      "alone can make gaps of up to 0.02 and overlaps of up to 0, which the law counts. With Gap = Closed they do "
      "not count, with Closed Within = 0.02 larger ones do.");
  joined.report.sagitta = 10.0;  // they lie on each other all the same
  EXPECT_TRUE(joined.warnings().empty());
}

}  // namespace
}  // namespace harmos::scene
