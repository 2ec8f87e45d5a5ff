#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/CurvedFaces.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/Refinement.hpp>

namespace harmos::mesh {
namespace {

using Kind = CurvedSurface::Kind;
using Map = std::function<base::Vector3(const base::Vector3&)>;

Mesh box(ElementType type, const std::array<int, 3>& cells, const Map& place) {
  Box one;
  one.name = "box";
  one.element = type;
  one.upper = {1.0, 1.0, dimensionOf(type) == 3 ? 1.0 : 0.0};
  for (std::size_t d = 0; d < 3; ++d) one.cells[d] = cells[d];
  Mesh mesh = boxes({one});
  for (base::Vector3& x : mesh.nodes) x = place(x);
  return mesh;
}

constexpr double inner = 2.0, outer = 3.0;
const base::Vector3 origin{5.0, -7.0, 11.0};

/// A third of a tube about an axis that is none of the coordinates'; x is the radius, y the angle.
base::Vector3 tube(const base::Vector3& x) {
  const double r = inner + (outer - inner) * x[0], angle = 2.0 * x[1], c = std::cos(0.7), s = std::sin(0.7);
  const base::Vector3 at{r * std::cos(angle), r * std::sin(angle), 4.0 * x[2]};
  return origin + base::Vector3{at[0], c * at[1] - s * at[2], s * at[1] + c * at[2]};
}

base::Vector3 shell(const base::Vector3& x) {
  const base::Vector3 along{std::tan(0.7 * (2.0 * x[0] - 1.0)), std::tan(0.7 * (2.0 * x[1] - 1.0)), 1.0};
  return origin + ((inner + (outer - inner) * x[2]) / base::norm(along)) * along;
}

std::set<int> nodesOf(const Mesh& mesh, const std::string& sideSet) {
  const Elements elements(mesh);
  std::set<int> nodes;
  for (const SideSet& set : mesh.sideSets) {
    for (std::size_t i = 0; set.name == sideSet && i < set.element.size(); ++i) {
      for (const int node : elements.side(set.element[i], set.side[i])) nodes.insert(node);
    }
  }
  return nodes;
}

void expectOn(const CurvedSurface& surface, double radius, const Mesh& mesh, const std::string& sideSet) {
  EXPECT_NEAR(surface.radius(), radius, 1e-12);
  for (const int node : nodesOf(mesh, sideSet)) EXPECT_LT(surface.distance(mesh.nodes[node]), 1e-11);
}

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    return error.what();
  }
  return "accepted";
}

// Few facets of every shape tell axis and radius; new nodes of both walls lie on them, old ones where they were.
TEST(CurvedFaces, TakeNewNodesOfATube) {
  for (const ElementType type : {ElementType::hex8, ElementType::tet4, ElementType::wedge6}) {
    const Mesh coarse = box(type, {2, 2, 2}, tube);
    const std::vector<CurvedFaces> walls = {curvedFaces(coarse, "in", Kind::cylinder, {"box_xmin"}),
                                            curvedFaces(coarse, "out", Kind::cylinder, {"box_xmax"})};
    Mesh fine = refined(coarse);
    moveOnto(walls, static_cast<int>(coarse.nodes.size()), fine);
    Mesh quadratic = raised(fine);
    moveOnto(walls, static_cast<int>(fine.nodes.size()), quadratic);
    expectOn(walls[0].surface, inner, quadratic, "box_xmin");
    expectOn(walls[1].surface, outer, quadratic, "box_xmax");
    EXPECT_TRUE(std::equal(coarse.nodes.begin(), coarse.nodes.end(), quadratic.nodes.begin()));
    // Nodes beside the walls stay where splitting has put them.
    const Mesh straight = refined(coarse);
    const std::set<int> in = nodesOf(fine, "box_xmin"), out = nodesOf(fine, "box_xmax");
    int moved = 0;
    for (int i = 0; i < static_cast<int>(fine.nodes.size()); ++i) {
      if (base::distance(fine.nodes[i], straight.nodes[i]) < 1e-9) continue;
      ++moved;
      EXPECT_TRUE(in.count(i) + out.count(i) > 0) << i;
    }
    EXPECT_GT(moved, 10);
  }
}

TEST(CurvedFaces, TakeNewNodesOfASphereAndOfACircle) {
  const Mesh ball = box(ElementType::hex8, {2, 2, 1}, shell);
  const CurvedFaces inside = curvedFaces(ball, "in", Kind::sphere, {"box_zmin"});
  Mesh fine = raised(ball);
  moveOnto({inside}, static_cast<int>(ball.nodes.size()), fine);
  expectOn(inside.surface, inner, fine, "box_zmin");
  EXPECT_LT(base::distance(inside.surface.centre(), origin), 1e-12);

  const Mesh ring = box(ElementType::quad4, {1, 3, 0}, [](const base::Vector3& x) {
    const double r = inner + x[0], angle = x[1];
    return base::Vector3{origin[0] + r * std::cos(angle), origin[1] + r * std::sin(angle), 0.0};
  });
  const CurvedFaces hole = curvedFaces(ring, "hole", Kind::cylinder, {"box_xmin"});
  Mesh finer = refined(refined(ring));
  moveOnto({hole}, static_cast<int>(ring.nodes.size()), finer);
  expectOn(hole.surface, inner, finer, "box_xmin");
}

// Part of a countersink about an axis that is none of the coordinates'; its ends stay in their planes.
TEST(CurvedFaces, TakeNewNodesOfACone) {
  constexpr double slope = 0.8;
  for (const ElementType type : {ElementType::hex8, ElementType::tet4}) {
    for (const int levels : {1, 3}) {
      const Mesh coarse = box(type, {2, 3, levels}, [](const base::Vector3& x) {
        const double r = inner + x[0] + slope * x[2], angle = 2.0 * x[1], c = std::cos(0.7), s = std::sin(0.7);
        const base::Vector3 at{r * std::cos(angle), r * std::sin(angle), x[2]};
        return origin + base::Vector3{at[0], c * at[1] - s * at[2], s * at[1] + c * at[2]};
      });
      const CurvedFaces wall = curvedFaces(coarse, "sink", Kind::cone, {"box_xmin"});
      Mesh fine = refined(coarse);
      moveOnto({wall}, static_cast<int>(coarse.nodes.size()), fine);
      const base::Vector3 axis{0.0, -std::sin(0.7), std::cos(0.7)};
      const std::set<int> below = nodesOf(fine, "box_zmin");
      for (const int node : nodesOf(fine, "box_xmin")) {
        const base::Vector3 x = fine.nodes[node] - origin;
        const double along = base::dot(x, axis);
        EXPECT_NEAR(base::norm(x - along * axis), inner + slope * along, 1e-11);
        if (below.count(node) == 0) continue;
        EXPECT_NEAR(along, 0.0, 1e-12);
      }
    }
  }
  const Mesh ring = box(ElementType::quad4, {1, 3, 0}, tube);
  EXPECT_NE(refusal([&] { curvedFaces(ring, "sink", Kind::cone, {"box_xmin"}); }).find("straight in the plane"),
            std::string::npos);
}

// On the rim of a ball that a bore cuts, nodes belong to both.
TEST(CurvedFaces, MeetAtARim) {
  constexpr double ball = 3.0, bore = 1.0;
  const Mesh mesh = box(ElementType::hex8, {2, 4, 2}, [](const base::Vector3& x) {
    const double r = bore + x[0], angle = x[1];
    return base::Vector3{r * std::cos(angle), r * std::sin(angle), x[2] * std::sqrt(ball * ball - r * r)};
  });
  const CurvedFaces outside = curvedFaces(mesh, "ball", Kind::sphere, {"box_zmax"});
  const CurvedFaces hole = curvedFaces(mesh, "bore", Kind::cylinder, {"box_xmin"});
  Mesh fine = raised(mesh);
  moveOnto({outside, hole}, static_cast<int>(mesh.nodes.size()), fine);
  expectOn(outside.surface, ball, fine, "box_zmax");
  expectOn(hole.surface, bore, fine, "box_xmin");
}

// A bush in the tube, meshed otherwise: of its faces those that touch the tube's are told of where only the tube's are
// named, and none of the others.
TEST(CurvedFaces, TellOfFacesThatStayStraight) {
  Box outside, inside;
  outside.name = "tube";
  inside.name = "bush";
  outside.element = inside.element = ElementType::hex8;
  inside.lower = {-1.0, 0.0, 0.0};
  inside.upper = {0.0, 1.0, 1.0};
  outside.upper = {1.0, 1.0, 1.0};
  outside.cells = {1, 4, 2};
  inside.cells = {2, 3, 1};
  Mesh mesh = boxes({outside, inside});
  for (base::Vector3& x : mesh.nodes) x = tube(x);
  EXPECT_EQ(straightBeside(mesh, {curvedFaces(mesh, "in", Kind::cylinder, {"tube_xmin"})}), 3);
  EXPECT_GT(straightBeside(mesh, {curvedFaces(mesh, "in", Kind::cylinder, {"bush_xmax"})}), 0);
  EXPECT_EQ(straightBeside(mesh, {curvedFaces(mesh, "in", Kind::cylinder, {"tube_xmin", "bush_xmax"})}), 0);
  EXPECT_EQ(straightBeside(mesh, {curvedFaces(mesh, "out", Kind::cylinder, {"tube_xmax"})}), 0);
}

TEST(CurvedFaces, AreRefusedByName) {
  const Mesh mesh = box(ElementType::hex8, {2, 2, 2}, tube);
  const auto with = [&](const std::vector<std::string>& sets, Kind kind = Kind::cylinder) {
    return refusal([&] { curvedFaces(mesh, "wall", kind, sets); });
  };
  EXPECT_NE(with({"box_xmni"}).find("there is no side set \"box_xmni\".\n  Did you mean \"box_xmin\""),
            std::string::npos);
  EXPECT_NE(with({"box_ymin"}).find("\"wall\": its nodes do not determine a curved surface"), std::string::npos);
  EXPECT_NE(with({"box_xmin", "box_xmax"}).find("off the surface that fits best"), std::string::npos);
  EXPECT_NE(with({"box_xmin"}, Kind::sphere).find("off the surface that fits best"), std::string::npos);
  EXPECT_NE(with({}).find("no side set is named"), std::string::npos);
}

}  // namespace
}  // namespace harmos::mesh
