#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/BoltedJoint.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/GluedAssembly.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {
namespace {

std::map<std::string, std::size_t> sideSetSizes(const Mesh& mesh) {
  std::map<std::string, std::size_t> sizes;
  for (const SideSet& set : mesh.sideSets) sizes[set.name] = set.element.size();
  return sizes;
}

TEST(BoltedJoint, HasTheElementsAndSetsOfTheReferenceMesh) {
  const Mesh mesh = boltedJoint();
  EXPECT_EQ(mesh.nodes.size(), 8516u);
  std::vector<std::pair<std::string, int>> blocks;
  for (const ElementBlock& block : mesh.blocks) blocks.emplace_back(block.name, block.elements());
  const std::vector<std::pair<std::string, int>> expected = {
      {"cover_bottom", 1116}, {"centre", 1116}, {"cover_top", 1116}, {"bolt_1", 912},
      {"head_1", 312},        {"bolt_2", 912},  {"head_2", 312}};
  EXPECT_EQ(blocks, expected);
  auto sizes = sideSetSizes(mesh);
  EXPECT_EQ(sizes.size(), 19u);
  for (const std::string side : {"_1", "_2"}) {
    for (const std::string name : {"plates_bottom", "plates_top"}) EXPECT_EQ(sizes[name + side], 336u) << name;
    for (const std::string name : {"head_1_cover", "nut_1_cover", "head_2_cover", "nut_2_cover"}) {
      EXPECT_EQ(sizes[name + side], 72u) << name;
    }
    for (const std::string name : {"preload_1", "preload_2"}) EXPECT_EQ(sizes[name + side], 60u) << name;
  }
  for (const std::string name : {"fixed_bottom", "fixed_top", "loaded"}) EXPECT_EQ(sizes[name], 18u) << name;
}

TEST(BoltedJoint, RefinementMultipliesTheElements) {
  EXPECT_EQ(boltedJoint(2.0).blocks[0].elements(), 8 * 1116);
  const Mesh coarse = boltedJoint(0.5);
  EXPECT_LT(coarse.nodes.size(), 8516u / 3u);
  // An odd number of cells per quarter turn must not leave gaps at the corners: the skin encloses one connected plate.
  const Elements elements(coarse);
  std::vector<int> plate(coarse.blocks[0].elements());
  std::iota(plate.begin(), plate.end(), 0);
  std::size_t sides = 0;
  for (const Face& face : skin(elements, plate)) {
    const bool isSide = std::all_of(face.nodes.begin(), face.nodes.end(),
                                    [&](int node) { return std::abs(coarse.nodes[node][1]) == 20.0; });
    if (isSide) ++sides;
  }
  EXPECT_EQ(sides, 2u * 3u * 3u * 2u);  // two sides, three cells of 40 mm, three elements each, two layers
}

TEST(GluedAssembly, HasTheElementsOfTheSource) {
  const Mesh mesh = gluedAssembly();
  ASSERT_EQ(mesh.blocks.size(), 3u);
  EXPECT_EQ(mesh.blocks[0].elements() + mesh.blocks[1].elements() + mesh.blocks[2].elements(), 17820);
  EXPECT_EQ(2 * mesh.nodes.size(), 37174u);
  auto sizes = sideSetSizes(mesh);
  for (const char* glue : {"glue_1_1", "glue_1_2", "glue_2_1", "glue_2_2"}) EXPECT_EQ(sizes[glue], 100u) << glue;
  EXPECT_EQ(sizes["clamped"], 42u);
  EXPECT_EQ(sizes["loaded"], 16u);
  ASSERT_EQ(mesh.nodeSets.at(0).node.size(), 1u);
  EXPECT_EQ(mesh.nodes[mesh.nodeSets[0].node[0]], (base::Vector3{38.0, 240.0, 0.0}));
}

TEST(GluedAssembly, RefusesCellsThatDoNotFit) {
  EXPECT_THROW(gluedAssembly(0.3), base::Error);
  EXPECT_THROW(gluedAssembly(-1.0), base::Error);
  EXPECT_EQ(gluedAssembly(0.25).blocks[0].elements(), 4 * 42 * 190);
}

class BoxElements : public ::testing::TestWithParam<std::tuple<ElementType, int, int>> {};

TEST_P(BoxElements, FillTheBoxWithoutInnerSurfaces) {
  const auto [type, perCell, facesPerCellSide] = GetParam();
  const Box box{"block", {1.0, 2.0, 3.0}, {2.0, 4.0, 6.0}, {2, 3, 4}, type};
  const Mesh mesh = boxes({box, {"other", {2.0, 2.0, 3.0}, {3.0, 4.0, 6.0}, {1, 1, 1}, type}});
  const bool plane = dimensionOf(type) == 2;
  EXPECT_EQ(mesh.blocks[0].elements(), perCell * (plane ? 6 : 24));
  const Elements elements(mesh);
  std::vector<int> all(mesh.blocks[0].elements());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  const int cellSides = plane ? 2 * (2 + 3) : 2 * (2 * 3 + 3 * 4 + 4 * 2);
  EXPECT_EQ(static_cast<int>(skin(elements, all).size()), facesPerCellSide * cellSides);
  auto sizes = sideSetSizes(mesh);
  EXPECT_EQ(static_cast<int>(sizes["block_xmax"]), facesPerCellSide * 3 * (plane ? 1 : 4));
  EXPECT_EQ(static_cast<int>(sizes["other_xmin"]), facesPerCellSide);
}

INSTANTIATE_TEST_SUITE_P(All, BoxElements,
                         ::testing::Values(std::tuple(ElementType::hex8, 1, 1), std::tuple(ElementType::tet4, 6, 2),
                                           std::tuple(ElementType::pyramid5, 6, 1),
                                           std::tuple(ElementType::quad4, 1, 1), std::tuple(ElementType::tri3, 2, 1)));

TEST(Boxes, CutCellsIntoWedges) {
  const Mesh mesh = boxes({{"block", {}, {1.0, 1.0, 1.0}, {2, 3, 4}, ElementType::wedge6}});
  EXPECT_EQ(mesh.blocks[0].elements(), 48);
  auto sizes = sideSetSizes(mesh);
  EXPECT_EQ(sizes["block_zmin"], 12u);
  EXPECT_EQ(sizes["block_xmin"], 12u);
}

TEST(Boxes, RefusesWhatIsNoBox) {
  EXPECT_THROW(boxes({{"flat", {}, {1.0, 0.0, 1.0}, {1, 1, 1}}}), base::Error);
  EXPECT_THROW(boxes({{"empty", {}, {1.0, 1.0, 1.0}, {1, 0, 1}}}), base::Error);
  EXPECT_THROW(boxes({{"twin", {}, {1.0, 1.0, 1.0}, {1, 1, 1}}, {"twin", {}, {1.0, 1.0, 1.0}, {1, 1, 1}}}),
               base::Error);
}

// Before it is made: the elements of a mesh, and with them its nodes and the entries of a stiffness matrix in the limit
// of many cells, from which surfaces keep small meshes away.
TEST(MeshSize, IsKnownOfEveryElement) {
  for (const ElementType type :
       {ElementType::tri3, ElementType::quad4, ElementType::tet4, ElementType::pyramid5, ElementType::wedge6,
        ElementType::hex8, ElementType::tri6, ElementType::quad8, ElementType::quad9, ElementType::tet10,
        ElementType::wedge15, ElementType::hex20, ElementType::hex27}) {
    SCOPED_TRACE(exodusName(type));
    Box box{"box", {0, 0, 0}, {1, 1, 1}, {12, 12, 12}, type};
    if (dimensionOf(type) == 2) box.cells = {40, 40, 0};
    const Mesh mesh = boxes({box});
    const double nodes = nodesForElement(type) * mesh.blocks[0].elements();
    EXPECT_GT(static_cast<double>(mesh.nodes.size()), nodes);
    EXPECT_LT(static_cast<double>(mesh.nodes.size()), 1.3 * nodes);
    std::vector<std::set<int>> near(mesh.nodes.size());
    const int count = nodesPerElement(type);
    for (int e = 0; e < mesh.blocks[0].elements(); ++e) {
      const int* of = mesh.blocks[0].connectivity.data() + static_cast<std::ptrdiff_t>(e) * count;
      for (int a = 0; a < count; ++a) near[of[a]].insert(of, of + count);
    }
    double pairs = 0.0;
    for (const std::set<int>& one : near) pairs += static_cast<double>(one.size());
    const double mean = pairs / static_cast<double>(near.size());
    EXPECT_LT(mean, meanNeighbours(type));
    EXPECT_GT(mean, 0.85 * meanNeighbours(type));
  }
}

}  // namespace
}  // namespace harmos::mesh
