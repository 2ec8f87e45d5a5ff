#include <gtest/gtest.h>

#include <algorithm>

#include <harmos/mesh/ElementType.hpp>

namespace harmos::mesh {
namespace {

using Sides = std::vector<std::vector<int>>;

// Table "side set node ordering" of the Exodus II manual, local nodes counted from 1.
const std::vector<std::pair<ElementType, Sides>> exodusSides = {
    {ElementType::tri3, {{1, 2}, {2, 3}, {3, 1}}},
    {ElementType::quad4, {{1, 2}, {2, 3}, {3, 4}, {4, 1}}},
    {ElementType::tet4, {{1, 2, 4}, {2, 3, 4}, {1, 4, 3}, {1, 3, 2}}},
    {ElementType::pyramid5, {{1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {1, 5, 4}, {1, 4, 3, 2}}},
    {ElementType::wedge6, {{1, 2, 5, 4}, {2, 3, 6, 5}, {1, 4, 6, 3}, {1, 3, 2}, {4, 5, 6}}},
    {ElementType::hex8, {{1, 2, 6, 5}, {2, 3, 7, 6}, {3, 4, 8, 7}, {1, 5, 8, 4}, {1, 4, 3, 2}, {5, 6, 7, 8}}},
};

TEST(ElementType, SidesAreThoseOfExodus) {
  for (const auto& [type, sides] : exodusSides) {
    ASSERT_EQ(sidesPerElement(type), static_cast<int>(sides.size())) << exodusName(type);
    for (std::size_t side = 0; side < sides.size(); ++side) {
      std::vector<int> cycle = sideNodes(type, static_cast<int>(side));
      for (int& node : cycle) ++node;
      // The orientation counts, not where the cycle starts.
      bool equal = false;
      for (std::size_t turn = 0; turn < cycle.size(); ++turn) {
        equal = equal || cycle == sides[side];
        std::rotate(cycle.begin(), cycle.begin() + 1, cycle.end());
      }
      EXPECT_TRUE(equal) << exodusName(type) << " side " << side + 1;
    }
  }
}

TEST(ElementType, ReadsExodusNamesInAnyCase) {
  EXPECT_EQ(elementTypeFromExodus("hex", 3, 8), ElementType::hex8);
  EXPECT_EQ(elementTypeFromExodus("TETRA", 3, 4), ElementType::tet4);
  EXPECT_EQ(elementTypeFromExodus("Tetra4", 3, 4), ElementType::tet4);
  EXPECT_EQ(elementTypeFromExodus("WEDGE", 3, 6), ElementType::wedge6);
  EXPECT_EQ(elementTypeFromExodus("PYRAMID", 3, 5), ElementType::pyramid5);
  EXPECT_EQ(elementTypeFromExodus("SHELL4", 2, 4), ElementType::quad4);
  EXPECT_EQ(elementTypeFromExodus("quad", 2, 4), ElementType::quad4);
  EXPECT_EQ(elementTypeFromExodus("TRI", 2, 3), ElementType::tri3);
  EXPECT_FALSE(elementTypeFromExodus("SHELL4", 3, 4));
  EXPECT_FALSE(elementTypeFromExodus("TETRA", 3, 10));
  EXPECT_FALSE(elementTypeFromExodus("tetra10", 3, 10));
  EXPECT_FALSE(elementTypeFromExodus("SPHERE", 3, 1));
}

}  // namespace
}  // namespace harmos::mesh
