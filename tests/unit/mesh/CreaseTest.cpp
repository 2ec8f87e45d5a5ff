#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/InterfaceFinder.hpp>
#include <harmos/mesh/RedundantPairs.hpp>
#include <harmos/mesh/SmoothPatches.hpp>

namespace harmos::mesh {
namespace {

constexpr double usual = 50.0;  // degrees
constexpr double roundOff = 1e-12;
const double pi = std::acos(-1.0);

/// All faces of side sets `<box>_<side>`, as the set "all".
void unite(Mesh& mesh, const std::vector<std::string>& names) {
  SideSet all;
  all.name = "all";
  all.id = 1000;
  for (const SideSet& set : mesh.sideSets) {
    if (std::find(names.begin(), names.end(), set.name) == names.end()) continue;
    all.element.insert(all.element.end(), set.element.begin(), set.element.end());
    all.side.insert(all.side.end(), set.side.begin(), set.side.end());
  }
  mesh.sideSets.push_back(all);
}

InterfaceSurface onAll(const Mesh& mesh, double creaseAngle) {
  const std::vector<Piece> parts = {makePiece(mesh, mesh.blocks[0].name, {mesh.blocks[0].name})};
  return InterfaceFinder(mesh, parts).onSideSet("all", "all", creaseAngle).at(0);
}

double total(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

base::Vector3 total(const std::vector<base::Vector3>& values) {
  base::Vector3 sum{};
  for (const base::Vector3& value : values) sum = sum + value;
  return sum;
}

TEST(Crease, DividesTheNodesOfABoxByItsFaces) {
  for (const ElementType type : {ElementType::hex8, ElementType::tet4, ElementType::wedge6, ElementType::pyramid5}) {
    Mesh mesh = boxes({{"box", {}, {1.0, 1.0, 1.0}, {2, 2, 2}, type}});
    unite(mesh, {"box_xmax", "box_ymax", "box_zmax"});
    EXPECT_EQ(onAll(mesh, InterfaceFinder::oneNormal).pairs(), 19);
    EXPECT_EQ(onAll(mesh, 90.0).pairs(), 19) << "an angle of 90 degrees is not above 90";
    const InterfaceSurface surface = onAll(mesh, usual);
    ASSERT_EQ(surface.pairs(), 27);
    EXPECT_EQ(std::count(surface.patch.begin(), surface.patch.end(), 1), 7);
    EXPECT_EQ(std::count(surface.patch.begin(), surface.patch.end(), 2), 1) << "three faces meet at one corner";
    std::map<int, double> area;  // by the axis of the normal
    for (std::size_t p = 0; p < surface.area.size(); ++p) {
      for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(surface.frame[p][0][axis] - 1.0) < roundOff) area[axis] += surface.area[p];
      }
    }
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(area[axis], 1.0, roundOff);
    std::vector<double> rowSum(surface.area.size(), 0.0);
    for (const MassEntry& entry : surface.mass) rowSum[entry.row] += entry.value;
    for (std::size_t p = 0; p < surface.area.size(); ++p) EXPECT_NEAR(rowSum[p], surface.area[p], roundOff);
  }
}

/// A strip of so many cells bent into an arc of `angle` degrees each, with radii 1 and 2.
Mesh arc(int cells, double angle) {
  Mesh mesh = boxes({{"ring", {}, {1.0, 1.0, 0.0}, {1, cells, 0}, ElementType::quad4}});
  for (base::Vector3& point : mesh.nodes) {
    const double turned = point[1] * cells * angle * pi / 180.0;
    point = {(1.0 + point[0]) * std::cos(turned), (1.0 + point[0]) * std::sin(turned), 0.0};
  }
  unite(mesh, {"ring_xmin"});
  return mesh;
}

TEST(Crease, LeavesCoarseCirclesSmooth) {
  EXPECT_EQ(onAll(arc(6, 15.0), usual).pairs(), 7);
  EXPECT_EQ(onAll(arc(3, 30.0), usual).pairs(), 4);
  EXPECT_EQ(onAll(arc(2, 45.0), usual).pairs(), 3) << "an octagon";
  EXPECT_EQ(onAll(arc(2, 50.0), usual).pairs(), 3) << "the angle itself, up to round-off";
  EXPECT_EQ(onAll(arc(2, 45.0), 40.0).pairs(), 4) << "a chamfer, when it is asked for";
  EXPECT_EQ(onAll(arc(3, 60.0), usual).pairs(), 6) << "a hexagon";
  const InterfaceSurface quarter = onAll(arc(3, 30.0), usual);
  EXPECT_NEAR(distance(total(quarter.normal), {-1.0, -1.0, 0.0}), 0.0, roundOff);
}

TEST(Crease, DividesConvexAndHollowCornersAlike) {
  Mesh mesh = boxes({{"strip", {}, {4.0, 1.0, 0.0}, {4, 1, 0}, ElementType::quad4}});
  unite(mesh, {"strip_ymin", "strip_ymax", "strip_xmax"});
  const InterfaceSurface strip = onAll(mesh, usual);
  EXPECT_EQ(strip.pairs(), 12) << "two nodes in two patches";
  for (std::size_t p = 0; p < strip.area.size(); ++p) EXPECT_NEAR(norm(strip.normal[p]), strip.area[p], roundOff);
  // The middle of the lower side raised: hollow there, on both sides of it convex.
  for (base::Vector3& point : mesh.nodes) {
    if (point[0] == 2.0 && point[1] == 0.0) point[1] = 0.8;
  }
  EXPECT_EQ(onAll(mesh, usual).pairs(), 13);
}

/// A plate with a point raised in its middle.
Mesh tip(double height) {
  Mesh mesh = boxes({{"plate", {-1.0, -1.0, -1.0}, {1.0, 1.0, 0.0}, {2, 2, 1}, ElementType::tet4}});
  for (base::Vector3& point : mesh.nodes) {
    if (norm(point) == 0.0) point[2] = height;
  }
  unite(mesh, {"plate_zmax"});
  return mesh;
}

TEST(Crease, KeepsBluntTipsAndDividesSteepOnes) {
  EXPECT_EQ(onAll(tip(0.2), usual).pairs(), 9);
  EXPECT_GT(onAll(tip(4.0), usual).pairs(), 9 + 2);
  for (const double height : {0.2, 4.0}) {
    EXPECT_NEAR(distance(total(onAll(tip(height), usual).normal), {0.0, 0.0, 4.0}), 0.0, roundOff);
  }
}

TEST(Crease, MayEndWithinASurface) {
  // A roof whose ridge falls to the level of the eaves.
  Mesh mesh = boxes({{"house", {-1.0, 0.0, -1.0}, {1.0, 4.0, 0.0}, {2, 4, 1}}});
  for (base::Vector3& point : mesh.nodes) {
    if (point[0] == 0.0 && point[2] == 0.0) point[2] = 0.25 * (4.0 - point[1]);
  }
  unite(mesh, {"house_zmax"});
  const InterfaceSurface roof = onAll(mesh, 40.0);
  std::map<double, int> points;  // on the ridge
  for (const base::Vector3& place : roof.position) {
    if (place[0] == 0.0) ++points[place[1]];
  }
  EXPECT_EQ(points, (std::map<double, int>{{0.0, 2}, {1.0, 2}, {2.0, 2}, {3.0, 1}, {4.0, 1}}));
}

TEST(Crease, IsTheSameOnSidesThatAreDividedDifferently) {
  // Around node 0, on two planes, the faces of both sides; those of one side share no edge with those of the other.
  const auto pairs = [](std::vector<int> nodes) {
    std::vector<NodePair> result;
    for (const int node : nodes) result.emplace_back(node, node + 100);
    return result;
  };
  const base::Vector3 up{0.0, 0.0, 1.0}, along{1.0, 0.0, 0.0};
  const auto patch = smoothPatches(
      {{pairs({0, 1, 2}), up}, {pairs({0, 3, 4}), along}, {pairs({0, 5, 6}), up}, {pairs({0, 7, 8}), along}}, usual);
  EXPECT_EQ(patch[0][0], 0);
  EXPECT_EQ(patch[1][0], 1);
  EXPECT_EQ(patch[2][0], 0) << "faces with one normal";
  EXPECT_EQ(patch[3][0], 1);
}

TEST(Crease, IsDividedBetweenTwoParts) {
  Mesh mesh = boxes({{"body", {}, {1.0, 1.0, 1.0}, {3, 3, 3}}});
  // The cells with all coordinates above 1/3 are a block in a corner of the others, with which it shares its nodes.
  ElementBlock block = mesh.blocks[0], rest = mesh.blocks[0];
  block.name = "block";
  block.id = 2;
  block.connectivity.clear();
  rest.connectivity.clear();
  for (int e = 0; e < mesh.blocks[0].elements(); ++e) {
    const auto first = mesh.blocks[0].connectivity.begin() + e * 8;
    bool isInner = true;
    for (int c = 0; c < 3; ++c) {
      double centre = 0.0;
      for (int i = 0; i < 8; ++i) centre += mesh.nodes[first[i]][c] / 8.0;
      isInner = isInner && centre > 1.0 / 3.0;
    }
    auto& to = isInner ? block.connectivity : rest.connectivity;
    to.insert(to.end(), first, first + 8);
  }
  mesh.blocks = {rest, block};
  mesh.sideSets.clear();
  const std::vector<Piece> parts = {makePiece(mesh, "body", {"body"}), makePiece(mesh, "block", {"block"})};
  const InterfaceFinder finder(mesh, parts);
  const auto whole = finder.betweenParts("seal", "block", "body", usual);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].pairs(), 27);
  EXPECT_NEAR(total(whole[0].area), 3.0 * 4.0 / 9.0, roundOff);
  EXPECT_EQ(finder.betweenParts("seal", "block", "body").at(0).pairs(), 19);

  // Cut into pieces the joint is the same: as many unknowns, with the same areas and normals.
  std::vector<int> lower, upper;
  for (const int element : parts[0].elements) (element % 2 == 0 ? lower : upper).push_back(element);
  const std::vector<Piece> pieces = {makePiece(mesh, "body.1", "body", lower), makePiece(mesh, "body.2", "body", upper),
                                     parts[1]};
  auto cut = InterfaceFinder(mesh, pieces).betweenParts("seal", "block", "body", usual);
  const auto carriers = mergeRedundantPairs(pieces, mesh.dimension, cut);
  std::map<std::pair<int, int>, std::pair<double, base::Vector3>> points;  // by mesh node and patch
  for (std::size_t s = 0; s < cut.size(); ++s) {
    for (int p = 0; p < cut[s].pairs(); ++p) {
      if (carriers[s][p].surface != static_cast<int>(s)) continue;
      const int node = pieces[cut[s].piece1].nodes[cut[s].trace1.node(p)];
      EXPECT_TRUE(points.try_emplace({node, cut[s].patch[p]}, cut[s].area[p], cut[s].frame[p][0]).second);
    }
  }
  ASSERT_EQ(static_cast<int>(points.size()), whole[0].pairs());
  for (int p = 0; p < whole[0].pairs(); ++p) {
    const auto& [area, normal] = points.at({parts[1].nodes[whole[0].trace1.node(p)], whole[0].patch[p]});
    EXPECT_NEAR(area, whole[0].area[p], roundOff);
    EXPECT_NEAR(distance(normal, whole[0].frame[p][0]), 0.0, roundOff);
  }
}

TEST(RedundantPairs, KeepTheNormalOfTheUncutSurface) {
  const Mesh mesh = arc(4, 30.0);
  const std::vector<Piece> whole = {makePiece(mesh, "ring", {"ring"})};
  const std::vector<Piece> pieces = {makePiece(mesh, "ring.1", "ring", {0, 1}),
                                     makePiece(mesh, "ring.2", "ring", {2, 3})};
  const InterfaceSurface uncut = InterfaceFinder(mesh, whole).onSideSet("all", "all", usual).at(0);
  auto cut = InterfaceFinder(mesh, pieces).onSideSet("all", "all", usual);
  const auto carriers = mergeRedundantPairs(pieces, mesh.dimension, cut);
  std::set<int> seen;
  for (std::size_t s = 0; s < cut.size(); ++s) {
    for (int p = 0; p < cut[s].pairs(); ++p) {
      if (carriers[s][p].surface != static_cast<int>(s)) continue;
      const int node = pieces[cut[s].piece1].nodes[cut[s].trace1.node(p)];
      int at = 0;
      while (uncut.trace1.node(at) != localNode(whole[0], node)) ++at;
      EXPECT_NEAR(distance(cut[s].frame[p][0], uncut.frame[at][0]), 0.0, roundOff);
      EXPECT_NEAR(distance(cut[s].normal[p], uncut.normal[at]), 0.0, roundOff);
      seen.insert(node);
    }
  }
  EXPECT_EQ(static_cast<int>(seen.size()), uncut.pairs());
}

}  // namespace
}  // namespace harmos::mesh
