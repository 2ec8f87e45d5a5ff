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
    {ElementType::tri6, {{1, 2, 4}, {2, 3, 5}, {3, 1, 6}}},
    {ElementType::quad8, {{1, 2, 5}, {2, 3, 6}, {3, 4, 7}, {4, 1, 8}}},
    {ElementType::quad9, {{1, 2, 5}, {2, 3, 6}, {3, 4, 7}, {4, 1, 8}}},
    {ElementType::tet10, {{1, 2, 4, 5, 9, 8}, {2, 3, 4, 6, 10, 9}, {1, 4, 3, 8, 10, 7}, {1, 3, 2, 7, 6, 5}}},
    {ElementType::wedge15,
     {{1, 2, 5, 4, 7, 11, 13, 10},
      {2, 3, 6, 5, 8, 12, 14, 11},
      {1, 4, 6, 3, 10, 15, 12, 9},
      {1, 3, 2, 9, 8, 7},
      {4, 5, 6, 13, 14, 15}}},
    {ElementType::hex20,
     {{1, 2, 6, 5, 9, 14, 17, 13},
      {2, 3, 7, 6, 10, 15, 18, 14},
      {3, 4, 8, 7, 11, 16, 19, 15},
      {1, 5, 8, 4, 13, 20, 16, 12},
      {1, 4, 3, 2, 12, 11, 10, 9},
      {5, 6, 7, 8, 17, 18, 19, 20}}},
    {ElementType::hex27,
     {{1, 2, 6, 5, 9, 14, 17, 13, 26},
      {2, 3, 7, 6, 10, 15, 18, 14, 25},
      {3, 4, 8, 7, 11, 16, 19, 15, 27},
      {1, 5, 8, 4, 13, 20, 16, 12, 24},
      {1, 4, 3, 2, 12, 11, 10, 9, 22},
      {5, 6, 7, 8, 17, 18, 19, 20, 23}}},
};

/// Turns corners and middles of edges of a side by one edge; its middle stays.
void turn(std::vector<int>& nodes, std::size_t corners) {
  const auto begin = nodes.begin(), middle = begin + static_cast<std::ptrdiff_t>(corners);
  std::rotate(begin, begin + 1, middle);
  if (nodes.size() >= 2 * corners) {
    std::rotate(middle, middle + 1, middle + static_cast<std::ptrdiff_t>(corners));
  }
}

TEST(ElementType, SidesAreThoseOfExodus) {
  for (const auto& [type, sides] : exodusSides) {
    ASSERT_EQ(sidesPerElement(type), static_cast<int>(sides.size())) << exodusName(type);
    for (std::size_t side = 0; side < sides.size(); ++side) {
      std::vector<int> cycle = sideNodes(type, static_cast<int>(side));
      for (int& node : cycle) ++node;
      // The orientation counts, not where the cycle starts.
      bool equal = false;
      const std::size_t corners = sideNodes(linearType(type), static_cast<int>(side)).size();
      for (std::size_t start = 0; start < corners; ++start) {
        equal = equal || cycle == sides[side];
        turn(cycle, corners);
      }
      EXPECT_TRUE(equal) << exodusName(type) << " side " << side + 1;
    }
  }
}

TEST(ElementType, MiddlesOfEdgesFollowTheCorners) {
  // Table "node ordering" of the Exodus II manual: hexahedra and wedges below, upright, above; unlike Abaqus and VTK.
  const std::vector<std::pair<ElementType, Sides>> middles = {
      {ElementType::tet10, {{1, 2, 5}, {2, 3, 6}, {3, 1, 7}, {1, 4, 8}, {2, 4, 9}, {3, 4, 10}}},
      {ElementType::wedge15,
       {{1, 2, 7}, {2, 3, 8}, {3, 1, 9}, {1, 4, 10}, {2, 5, 11}, {3, 6, 12}, {4, 5, 13}, {5, 6, 14}, {6, 4, 15}}},
      {ElementType::hex20,
       {{1, 2, 9},
        {2, 3, 10},
        {3, 4, 11},
        {4, 1, 12},
        {1, 5, 13},
        {2, 6, 14},
        {3, 7, 15},
        {4, 8, 16},
        {5, 6, 17},
        {6, 7, 18},
        {7, 8, 19},
        {8, 5, 20}}}};
  for (const auto& [type, expected] : middles) {
    Sides found = edgesOf(type);
    for (auto& edge : found) {
      for (int& node : edge) ++node;
    }
    const auto byMiddle = [](const auto& a, const auto& b) { return a[2] < b[2]; };
    std::sort(found.begin(), found.end(), byMiddle);
    EXPECT_EQ(found, expected) << exodusName(type);
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
  EXPECT_EQ(elementTypeFromExodus("TETRA", 3, 10), ElementType::tet10);
  EXPECT_EQ(elementTypeFromExodus("tetra10", 3, 10), ElementType::tet10);
  EXPECT_EQ(elementTypeFromExodus("HEX", 3, 20), ElementType::hex20);
  EXPECT_EQ(elementTypeFromExodus("hex27", 3, 27), ElementType::hex27);
  EXPECT_EQ(elementTypeFromExodus("Wedge15", 3, 15), ElementType::wedge15);
  EXPECT_EQ(elementTypeFromExodus("QUAD", 2, 8), ElementType::quad8);
  EXPECT_EQ(elementTypeFromExodus("QUAD9", 2, 9), ElementType::quad9);
  EXPECT_EQ(elementTypeFromExodus("TRI6", 2, 6), ElementType::tri6);
  EXPECT_FALSE(elementTypeFromExodus("PYRAMID13", 3, 13));
  EXPECT_FALSE(elementTypeFromExodus("SPHERE", 3, 1));
}

}  // namespace
}  // namespace harmos::mesh
