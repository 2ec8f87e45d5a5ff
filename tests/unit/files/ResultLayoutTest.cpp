#include <gtest/gtest.h>

#include <utility>

#include <harmos/files/ResultLayout.hpp>

using namespace harmos;

namespace {

// Two unit cubes along x that share the nodes of the plane x = 1, and the interface there.
struct SharedFace {
  SharedFace() {
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j) mesh.nodes.push_back({1.0 * i, 1.0 * j, 1.0 * k});
    mesh.blocks = {{"left", 1, mesh::ElementType::hex8, {0, 4, 5, 1, 2, 6, 7, 3}},
                   {"right", 2, mesh::ElementType::hex8, {4, 8, 9, 5, 6, 10, 11, 7}}};
    parts = {mesh::makePiece(mesh, "left", {"left"}), mesh::makePiece(mesh, "right", {"right"})};
    surface.name = "joint";
    surface.piece1 = 0;
    surface.piece2 = 1;
    surface.trace1 = mesh::TraceOperator({4, 5, 6, 7});
    surface.trace2 = mesh::TraceOperator({0, 1, 2, 3});
    surface.position = placesOf({4, 5, 6, 7});
    surface.face = {{0, 1, 3, 2}};
  }
  /// Of nodes of the part on the left, which has the first nodes of the mesh.
  std::vector<base::Vector3> placesOf(const std::vector<int>& nodes) const {
    std::vector<base::Vector3> places;
    for (const int node : nodes) places.push_back(mesh.nodes[node]);
    return places;
  }

  mesh::Mesh mesh;
  std::vector<mesh::Piece> parts;
  mesh::InterfaceSurface surface;
};

}  // namespace

TEST(ResultLayout, NodesAreDoubledAtInterfaces) {
  const SharedFace scene;
  const auto layout = files::layOutParts(scene.mesh, scene.parts, {scene.surface});
  EXPECT_EQ(layout.mesh.nodes.size(), 16u);
  EXPECT_EQ(layout.firstNode, (std::vector<int>{0, 8}));
  ASSERT_EQ(layout.mesh.blocks.size(), 2u);
  EXPECT_EQ(layout.mesh.blocks[1].name, "right");
  EXPECT_EQ(layout.mesh.blocks[1].connectivity, (std::vector<int>{8, 12, 13, 9, 10, 14, 15, 11}));
  EXPECT_EQ(layout.element[1], std::vector<int>{1});
}

TEST(ResultLayout, NumbersAreThoseOfTheFileWhereEachIsThereOnce) {
  SharedFace scene;
  EXPECT_TRUE(files::layOutParts(scene.mesh, scene.parts, {}).mesh.elementNumbers.empty()) << "positions";
  std::swap(scene.parts[0], scene.parts[1]);
  EXPECT_EQ(files::layOutParts(scene.mesh, scene.parts, {}).mesh.elementNumbers, (std::vector<std::int64_t>{2, 1}));
  scene.mesh.numbering.element = {1017, 4};
  const auto layout = files::layOutParts(scene.mesh, scene.parts, {});
  EXPECT_EQ(layout.mesh.elementNumbers, (std::vector<std::int64_t>{4, 1017}));
  EXPECT_TRUE(layout.mesh.nodeNumbers.empty()) << "nodes that are doubled";
  const auto right = files::layOutParts(scene.mesh, {scene.parts[0]}, {});
  EXPECT_EQ(right.mesh.nodeNumbers, (std::vector<std::int64_t>{5, 6, 7, 8, 9, 10, 11, 12}));
  scene.mesh.numbering.node = {1, 2, 3, 4, 50, 60, 70, 80, 9, 10};
  EXPECT_TRUE(files::layOutParts(scene.mesh, {scene.parts[0]}, {}).mesh.nodeNumbers.empty()) << "nodes of no file";
  scene.mesh.numbering.isSplit = true;
  EXPECT_TRUE(files::layOutParts(scene.mesh, scene.parts, {}).mesh.elementNumbers.empty()) << "children";
}

TEST(ResultLayout, SidesOfInterfacesBecomeSideSets) {
  const SharedFace scene;
  const auto layout = files::layOutParts(scene.mesh, scene.parts, {scene.surface});
  ASSERT_EQ(layout.mesh.sideSets.size(), 2u);
  EXPECT_EQ(layout.mesh.sideSets[0].name, "joint_1");
  EXPECT_EQ(layout.mesh.sideSets[0].element, std::vector<int>{0});
  EXPECT_EQ(layout.mesh.sideSets[0].side, std::vector<int>{1});  // +x of an Exodus hexahedron, from 0
  EXPECT_EQ(layout.mesh.sideSets[1].element, std::vector<int>{1});
  EXPECT_EQ(layout.mesh.sideSets[1].side, std::vector<int>{3});  // -x
}

TEST(ResultLayout, SidesWhoseNodesAreNoPointsBecomeNodeSets) {
  SharedFace scene;
  scene.surface.trace2 = {};
  for (int p = 0; p < 4; ++p) scene.surface.trace2.append({{p, 0.75}, {(p + 1) % 4, 0.25}});
  const auto layout = files::layOutParts(scene.mesh, scene.parts, {scene.surface});
  ASSERT_EQ(layout.mesh.sideSets.size(), 1u);
  EXPECT_EQ(layout.mesh.sideSets[0].name, "joint_1");
  ASSERT_EQ(layout.mesh.nodeSets.size(), 1u);
  EXPECT_EQ(layout.mesh.nodeSets[0].name, "joint_2");
  EXPECT_EQ(layout.mesh.nodeSets[0].node, (std::vector<int>{8, 9, 10, 11}));
}

TEST(ResultLayout, BoundariesWithoutFacesBecomeNodeSetsAndPoints) {
  SharedFace scene;
  mesh::InterfaceSurface fixed;
  fixed.name = "left";  // as the part: sets and blocks must not share a name
  fixed.piece1 = 0;
  fixed.trace1 = mesh::TraceOperator({0, 1});
  fixed.position = scene.placesOf({0, 1});
  const auto parts = files::layOutParts(scene.mesh, scene.parts, {fixed});
  ASSERT_EQ(parts.mesh.nodeSets.size(), 1u);
  EXPECT_EQ(parts.mesh.nodeSets[0].name, "left_set");
  EXPECT_EQ(parts.mesh.nodeSets[0].node, (std::vector<int>{0, 1}));
  const auto interfaces = files::layOutInterfaces(3, {fixed});
  ASSERT_EQ(interfaces.mesh.blocks.size(), 1u);
  EXPECT_EQ(interfaces.mesh.blocks[0].type, "SPHERE");
  EXPECT_EQ(interfaces.mesh.blocks[0].elements(), 2);
}

TEST(ResultLayout, InterfacesAreSurfacesOfPairs) {
  const SharedFace scene;
  auto second = scene.surface;
  second.name = "other";
  const auto layout = files::layOutInterfaces(3, {scene.surface, second});
  EXPECT_EQ(layout.firstPair, (std::vector<int>{0, 4}));
  ASSERT_EQ(layout.mesh.blocks.size(), 2u);
  EXPECT_EQ(layout.mesh.blocks[0].type, "SHELL4");
  EXPECT_EQ(layout.mesh.blocks[1].name, "other");
  EXPECT_EQ(layout.mesh.blocks[1].connectivity, (std::vector<int>{4, 5, 7, 6}));
  EXPECT_EQ(layout.mesh.nodes[0], (base::Vector3{1.0, 0.0, 0.0}));
}

TEST(ResultLayout, PatchesOfACreaseKeepTheirNodes) {
  const SharedFace scene;
  mesh::InterfaceSurface corner;  // the side x = 0 and the bottom of the first cube
  corner.name = "corner";
  corner.piece1 = 0;
  corner.trace1 = mesh::TraceOperator({0, 0, 1, 1, 2, 3, 4, 5});
  corner.position = scene.placesOf({0, 0, 1, 1, 2, 3, 4, 5});
  corner.patch = {0, 1, 0, 1, 0, 0, 0, 0};
  corner.face = {{0, 4, 5, 2}, {1, 3, 7, 6}};
  const auto layout = files::layOutInterfaces(3, {corner});
  ASSERT_EQ(layout.mesh.nodes.size(), 8u);
  EXPECT_EQ(layout.mesh.nodes[0], layout.mesh.nodes[1]);
  EXPECT_EQ(layout.mesh.blocks.at(0).connectivity, (std::vector<int>{0, 4, 5, 2, 1, 3, 7, 6}));
  const auto parts = files::layOutParts(scene.mesh, scene.parts, {corner});
  EXPECT_EQ(parts.mesh.sideSets.at(0).element, (std::vector<int>{0, 0}));
}
