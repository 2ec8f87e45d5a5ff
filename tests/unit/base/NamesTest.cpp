#include <gtest/gtest.h>

#include <harmos/base/Names.hpp>

namespace harmos::base {
namespace {

TEST(Names, NearestGrowsWithTheLength) {
  EXPECT_EQ(nearestName("mi", {"mu", "nu"}), "mu");
  EXPECT_EQ(nearestName("ab", {"xy"}), "");
  EXPECT_EQ(nearestName("Materail", {"Pieces", "Material"}), "Material");
  EXPECT_EQ(nearestName("friction coeficent", {"Friction Coefficient", "Gap"}), "Friction Coefficient");
  EXPECT_EQ(nearestName("ACCURACY", {"Accuracy"}), "Accuracy");
  EXPECT_EQ(nearestName("Accuracy", {"Formulation"}), "");
  EXPECT_EQ(nearestName("x", {}), "");
  EXPECT_EQ(nearestName("coulomb", {"Coulomb Friction", "Perfect"}), "Coulomb Friction");
  EXPECT_EQ(nearestName("upper", {"upper_zmin", "upper_zmax"}), "");
  EXPECT_EQ(nearestName("abcdefgh", {"abcdefghxyz", "abcdefghx"}), "abcdefghx");
}

TEST(Names, LongListsAreCut) {
  EXPECT_EQ(joinNames({"a", "b"}), "a, b");
  EXPECT_EQ(joinNames({"a", "b", "c", "d"}, 2), "a, b and 2 more");
}

TEST(Names, Suggestion) {
  EXPECT_EQ(suggestName("plat", {"plate", "bolt"}, "Blocks"), "Did you mean \"plate\"? Blocks: plate, bolt.");
  EXPECT_EQ(suggestName("x", {}, "Blocks"), "Blocks: none.");
}

}  // namespace
}  // namespace harmos::base
