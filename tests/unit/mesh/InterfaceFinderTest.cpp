#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include <harmos/base/Error.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/BoltedJoint.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/GluedAssembly.hpp>
#include <harmos/mesh/InterfaceFinder.hpp>

namespace harmos::mesh {
namespace {

constexpr double roundOff = 1e-12;

std::vector<Piece> onePartPerBlock(const Mesh& mesh) {
  std::vector<Piece> parts;
  for (const ElementBlock& block : mesh.blocks) parts.push_back(makePiece(mesh, block.name, {block.name}));
  return parts;
}

/// The first part cut in two by a plane, as METIS would do it.
std::vector<Piece> cutFirstPart(const Mesh& mesh, const std::vector<Piece>& parts, std::size_t axis, double at) {
  const Elements elements(mesh);
  std::vector<int> below, above;
  for (const int element : parts[0].elements) {
    double centre = 0.0;
    const int count = nodesPerElement(elements.type(element));
    for (int i = 0; i < count; ++i) {
      centre += mesh.nodes[elements.nodes(element)[i]][axis] / count;
    }
    (centre < at ? below : above).push_back(element);
  }
  std::vector<Piece> result = {makePiece(mesh, parts[0].name + ".1", parts[0].name, below),
                               makePiece(mesh, parts[0].name + ".2", parts[0].name, above)};
  result.insert(result.end(), parts.begin() + 1, parts.end());
  return result;
}

double totalArea(const std::vector<InterfaceSurface>& surfaces) {
  double total = 0.0;
  for (const auto& surface : surfaces) total = std::accumulate(surface.area.begin(), surface.area.end(), total);
  return total;
}

void expectConsistent(const InterfaceSurface& surface, const Mesh& mesh, const std::vector<Piece>& parts) {
  std::vector<double> rowSum(surface.area.size(), 0.0);
  for (const MassEntry& entry : surface.mass) rowSum[entry.row] += entry.value;
  for (std::size_t p = 0; p < surface.area.size(); ++p) {
    if (!surface.mass.empty()) {
      EXPECT_NEAR(rowSum[p], surface.area[p], roundOff * surface.area[p]);
    }
    const base::Frame& frame = surface.frame[p];
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(dot(frame[i], frame[j]), i == j ? 1.0 : 0.0, roundOff);
    }
    EXPECT_NEAR(dot(cross(frame[0], frame[1]), frame[2]), 1.0, roundOff);
    if (surface.piece2 < 0) continue;
    const auto place = [&](int part, int node) { return mesh.nodes[parts[part].nodes[node]]; };
    const base::Vector3 apart =
        place(surface.piece2, surface.trace2.node(p)) - place(surface.piece1, surface.trace1.node(p));
    EXPECT_NEAR(distance(apart, surface.gap[p] * frame[0]), 0.0, 1e-9);
    EXPECT_EQ(surface.position[p], place(surface.piece1, surface.trace1.node(p)));
  }
}

std::vector<int> nodesOf(const TraceOperator& trace) {
  std::vector<int> nodes;
  for (int p = 0; p < trace.points(); ++p) nodes.push_back(trace.node(p));
  return nodes;
}

TEST(InterfaceFinder, FindsTheInterfacesOfTheBoltedJoint) {
  const Mesh mesh = boltedJoint();
  const auto parts = onePartPerBlock(mesh);
  const InterfaceFinder finder(mesh, parts);
  const auto polygon = [](double radius) { return 12.0 * radius * radius * std::sin(std::acos(-1.0) / 12.0); };
  struct Expected {
    const char* name;
    int pairs;
    double area;
  };
  for (const Expected& e :
       {Expected{"plates_bottom", 377, 3200.0 - 2.0 * polygon(6.0)},
        Expected{"plates_top", 377, 3200.0 - 2.0 * polygon(6.0)},
        Expected{"head_1_cover", 96, polygon(10.0) - polygon(6.0)},
        Expected{"nut_2_cover", 96, polygon(10.0) - polygon(6.0)}, Expected{"preload_1", 73, polygon(5.0)}}) {
    const std::string name = e.name;
    const auto surfaces = finder.betweenSideSets(name, name + "_1", name + "_2");
    ASSERT_EQ(surfaces.size(), 1u) << name;
    const InterfaceSurface& surface = surfaces[0];
    EXPECT_EQ(surface.pairs(), e.pairs) << name;
    EXPECT_EQ(surface.trace2.points(), e.pairs) << name;
    EXPECT_NEAR(totalArea(surfaces), e.area, roundOff * e.area) << name;
    for (const base::Frame& frame : surface.frame) EXPECT_NEAR(frame[0][2], 1.0, roundOff) << name;
    expectConsistent(surface, mesh, parts);
  }
  const auto loaded = finder.onSideSet("loaded", "loaded");
  EXPECT_NEAR(totalArea(loaded), 400.0, 400.0 * roundOff);
  EXPECT_NEAR(loaded[0].frame[0][0][0], 1.0, roundOff);
  EXPECT_EQ(loaded[0].trace2.points(), 0);
}

TEST(InterfaceFinder, SwappedSidesHaveTheSameAreasAndOppositeNormals) {
  const Mesh mesh = boltedJoint(0.5);
  const auto parts = onePartPerBlock(mesh);
  const InterfaceFinder finder(mesh, parts);
  const auto a = finder.betweenSideSets("seal", "plates_top_1", "plates_top_2")[0];
  const auto b = finder.betweenSideSets("seal", "plates_top_2", "plates_top_1")[0];
  std::map<int, std::pair<double, base::Vector3>> byNode;
  for (std::size_t p = 0; p < a.area.size(); ++p) byNode[a.trace1.node(p)] = {a.area[p], a.frame[p][0]};
  ASSERT_EQ(a.piece1, b.piece2);
  for (std::size_t p = 0; p < b.area.size(); ++p) {
    EXPECT_NEAR(byNode.at(b.trace2.node(p)).first, b.area[p], roundOff * b.area[p]);
    EXPECT_NEAR(dot(byNode.at(b.trace2.node(p)).second, b.frame[p][0]), -1.0, roundOff);
  }
}

TEST(InterfaceFinder, FindsTheSameSurfaceFromBodiesAsFromSideSets) {
  const Mesh mesh = boltedJoint(0.5);
  const auto parts = onePartPerBlock(mesh);
  const InterfaceFinder finder(mesh, parts);
  const auto a = finder.betweenParts("seal", "centre", "cover_top");
  const auto b = finder.betweenSideSets("seal", "plates_top_1", "plates_top_2");
  ASSERT_EQ(a.size(), 1u);
  EXPECT_EQ(nodesOf(a[0].trace1), nodesOf(b[0].trace1));
  EXPECT_EQ(nodesOf(a[0].trace2), nodesOf(b[0].trace2));
  EXPECT_EQ(a[0].area, b[0].area);
  // Shank and head meet in a disc, cover and head in an annulus: two interfaces of the same head.
  EXPECT_EQ(totalArea(finder.betweenParts("preload", "bolt_1", "head_1")),
            totalArea(finder.betweenSideSets("preload", "preload_1_1", "preload_1_2")));
}

TEST(InterfaceFinder, MultipliesByThicknessInThePlane) {
  const Mesh mesh = gluedAssembly(1.0);
  const auto parts = onePartPerBlock(mesh);
  const auto surface = InterfaceFinder(mesh, parts, 3.0).betweenSideSets("glue", "glue_1_1", "glue_1_2").at(0);
  EXPECT_EQ(surface.pairs(), 51);
  EXPECT_NEAR(std::accumulate(surface.area.begin(), surface.area.end(), 0.0), 150.0, 150.0 * roundOff);
  EXPECT_NEAR(surface.frame[0][0][0], 1.0, roundOff);
  EXPECT_NEAR(surface.frame[0][1][1], 1.0, roundOff);
  expectConsistent(surface, mesh, parts);
}

class PieceAreas : public ::testing::TestWithParam<ElementType> {};

TEST_P(PieceAreas, AddUpToTheUncutInterface) {
  Mesh mesh = boxes({{"lower", {}, {4.0, 3.0, 2.0}, {4, 3, 2}, GetParam()},
                     {"upper", {0.0, 0.0, 2.0}, {4.0, 3.0, 3.0}, {4, 3, 1}, GetParam()}});
  for (base::Vector3& point : mesh.nodes) point[2] += 0.1 * point[0] * point[1];  // warped quadrilaterals
  const auto whole = onePartPerBlock(mesh);
  const auto pieces = cutFirstPart(mesh, whole, 0, 2.0);
  const InterfaceFinder uncut(mesh, whole);
  const InterfaceFinder finder(mesh, pieces);
  const auto one = uncut.betweenSideSets("seal", "lower_zmax", "upper_zmin");
  const auto two = finder.betweenSideSets("seal", "lower_zmax", "upper_zmin");
  ASSERT_EQ(one.size(), 1u);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_NEAR(totalArea(one), totalArea(two), roundOff * totalArea(one));
  EXPECT_EQ(two[0].pairs() + two[1].pairs(), one[0].pairs() + 4);
  for (const auto& surface : two) expectConsistent(surface, mesh, pieces);

  const auto bottom = finder.onSideSet("fixed", "lower_zmin");
  EXPECT_EQ(bottom.size(), 2u);
  EXPECT_NEAR(totalArea(bottom), totalArea(uncut.onSideSet("fixed", "lower_zmin")), 1e-11);

  const auto cuts = finder.cuts();
  ASSERT_EQ(cuts.size(), 1u);
  EXPECT_EQ(cuts[0].name, "lower cut");
  EXPECT_EQ(cuts[0].pairs(), 4 * 3);
  EXPECT_TRUE(uncut.cuts().empty());
}

INSTANTIATE_TEST_SUITE_P(All, PieceAreas, ::testing::Values(ElementType::hex8, ElementType::tet4, ElementType::wedge6));

TEST(InterfaceFinder, TiesPiecesThatTouchInAnEdgeOnly) {
  // Of 2 x 2 x 1 cubes, one piece holds two diagonal cubes, the others one each: at the middle edge no chain of faces
  // is missing. Without the two single cubes, the diagonal ones touch in the edge alone.
  const Mesh mesh = boxes({{"block", {}, {2.0, 2.0, 1.0}, {2, 2, 1}}});
  const std::vector<Piece> all = {makePiece(mesh, "a", "block", {0}), makePiece(mesh, "b", "block", {1, 2}),
                                  makePiece(mesh, "c", "block", {3})};
  for (const auto& surface : InterfaceFinder(mesh, all).cuts()) EXPECT_FALSE(surface.face.empty());
  const std::vector<Piece> diagonal = {all[0], all[2]};
  const auto surfaces = InterfaceFinder(mesh, diagonal).cuts();
  ASSERT_EQ(surfaces.size(), 1u);
  EXPECT_EQ(surfaces[0].pairs(), 2);
  EXPECT_TRUE(surfaces[0].face.empty());
  for (const double area : surfaces[0].area) EXPECT_NEAR(area, 0.75, roundOff);  // three quarters at a cube's corner
}

/// A uniform pressure makes other nodal forces of triangles than of quadrilaterals: no area of a node suits both.
TEST(InterfaceFinder, LeavesSameNodesWithDifferentFacesToTheJoiner) {
  const Mesh mesh = boxes({{"lower", {}, {2.0, 1.0, 1.0}, {4, 3, 2}, ElementType::hex8},
                           {"upper", {0.0, 0.0, 1.0}, {2.0, 1.0, 2.0}, {4, 3, 1}, ElementType::tet4}});
  const auto parts = onePartPerBlock(mesh);
  const InterfaceFinder finder(mesh, parts);
  std::vector<std::pair<std::size_t, std::size_t>> joined;
  const auto join = [&](const std::string&, const std::vector<Face>& side1, const std::string&,
                        const std::vector<Face>& side2) {
    joined.emplace_back(side1.size(), side2.size());
    return std::vector<InterfaceSurface>{};
  };
  finder.betweenSideSets("seal", "lower_zmax", "upper_zmin", std::nullopt, InterfaceFinder::oneNormal, join);
  finder.betweenParts("seal", "upper", "lower", InterfaceFinder::oneNormal, join);
  const std::vector<std::pair<std::size_t, std::size_t>> expected = {{12, 24}, {24, 12}};
  EXPECT_EQ(joined, expected);
  EXPECT_THROW(finder.betweenParts("seal", "lower", "upper"), base::Error);
}

TEST(InterfaceFinder, ProjectsSurfacesThatAreOpen) {
  Mesh mesh = boxes({{"ground", {-1.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, {8, 2, 0}, ElementType::quad4},
                     {"roller", {-1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {8, 2, 0}, ElementType::quad4}});
  const auto parts = onePartPerBlock(mesh);
  for (const int node : parts[1].nodes) {
    base::Vector3& p = mesh.nodes[node];
    p[1] += 0.1 + 0.2 * p[0] * p[0];
  }
  const InterfaceFinder finder(mesh, parts);
  EXPECT_THROW(finder.betweenSideSets("roll", "ground_ymax", "roller_ymin"), base::Error);
  for (const double sign : {1.0, -1.0}) {
    const auto surface =
        finder.betweenSideSets("roll", "ground_ymax", "roller_ymin", base::Vector3{0.0, 2.0 * sign, 0.0}).at(0);
    ASSERT_EQ(surface.pairs(), 9);
    EXPECT_NEAR(totalArea({surface}), 2.0, roundOff);
    for (std::size_t p = 0; p < 9; ++p) {
      const base::Vector3& place = mesh.nodes[parts[0].nodes[surface.trace1.node(p)]];
      EXPECT_NEAR(surface.gap[p], 0.1 + 0.2 * place[0] * place[0], roundOff);
      EXPECT_NEAR(surface.frame[p][0][1], 1.0, roundOff);
    }
    expectConsistent(surface, mesh, parts);
  }
  const auto swapped = finder.betweenSideSets("roll", "roller_ymin", "ground_ymax", base::Vector3{0.0, 1.0, 0.0}).at(0);
  EXPECT_NEAR(totalArea({swapped}), 2.0, roundOff);
  EXPECT_NEAR(swapped.frame[0][0][1], -1.0, roundOff);
  EXPECT_NEAR(*std::min_element(swapped.gap.begin(), swapped.gap.end()), 0.1, roundOff);
}

TEST(InterfaceFinder, TakesNodeSetsByFacesOrByNodes) {
  Mesh mesh = boxes({{"block", {}, {2.0, 2.0, 2.0}, {2, 2, 2}}});
  const auto parts = onePartPerBlock(mesh);
  const auto where = [&](const auto& region) {
    std::vector<int> nodes;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      if (region(mesh.nodes[n])) nodes.push_back(static_cast<int>(n));
    }
    return nodes;
  };
  mesh.nodeSets = {{"face", 1, where([](const base::Vector3& p) { return p[0] == 0.0; })},
                   {"edge", 2, where([](const base::Vector3& p) { return p[0] == 0.0 && p[1] == 0.0; })},
                   {"inside", 3, where([](const base::Vector3& p) {
                      return p == base::Vector3{1.0, 1.0, 1.0};
                    })}};
  const InterfaceFinder finder(mesh, parts);
  const auto face = finder.onNodeSet("fixed", "face");
  EXPECT_EQ(face[0].face.size(), 4u);
  EXPECT_NEAR(totalArea(face), 4.0, roundOff);
  EXPECT_NEAR(face[0].frame[0][0][0], -1.0, roundOff);
  const auto edge = finder.onNodeSet("fixed", "edge");
  EXPECT_TRUE(edge[0].face.empty());
  EXPECT_NEAR(totalArea(edge), 0.75 + 1.0 + 0.75, roundOff);  // three, four and three quarters of a face
  EXPECT_NEAR(totalArea(finder.onNodeSet("held", "inside")), 1.0, roundOff);  // one cube of volume around the node
  const auto pieces = cutFirstPart(mesh, parts, 2, 1.0);
  const InterfaceFinder cut(mesh, pieces);
  for (const char* set : {"face", "edge", "inside"}) {
    EXPECT_EQ(cut.onNodeSet("held", set).size(), 2u) << set;
    EXPECT_NEAR(totalArea(cut.onNodeSet("held", set)), totalArea(finder.onNodeSet("held", set)), roundOff) << set;
  }
}

TEST(InterfaceFinder, SharedNodesCountOnceOnTheOuterBoundary) {
  // Two blocks of one grid share the nodes between them, as meshes from other programs do.
  Mesh mesh = boxes({{"block", {}, {2.0, 1.0, 1.0}, {2, 1, 1}}});
  const std::vector<int> connectivity = mesh.blocks[0].connectivity;
  mesh.blocks[0].connectivity.resize(8);
  mesh.blocks.push_back({"right", 2, ElementType::hex8, {connectivity.begin() + 8, connectivity.end()}});
  mesh.nodeSets = {{"all", 1, std::vector<int>(12)}};
  std::iota(mesh.nodeSets[0].node.begin(), mesh.nodeSets[0].node.end(), 0);
  const auto parts = onePartPerBlock(mesh);
  const InterfaceFinder finder(mesh, parts);
  EXPECT_NEAR(totalArea(finder.onNodeSet("held", "all")), 10.0, roundOff);
  EXPECT_NEAR(totalArea(finder.onNodeSet("held", "all", "right")), 6.0, roundOff);
  const auto joint = finder.betweenParts("joint", "block", "right");
  ASSERT_EQ(joint.size(), 1u);
  EXPECT_EQ(joint[0].pairs(), 4);
  EXPECT_NEAR(totalArea(joint), 1.0, roundOff);
}

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    return error.what();
  }
  return "no error";
}

/// What joining the boxes "a" and "b" by their names ends with.
std::string joined(const std::vector<Box>& list, const std::function<void(Mesh&)>& change = {}) {
  Mesh mesh = boxes(list);
  if (change) change(mesh);
  const auto parts = onePartPerBlock(mesh);
  const InterfaceFinder finder(mesh, parts);
  return messageOf([&] { finder.betweenParts("seal", "a", "b"); });
}

TEST(InterfaceFinder, RefusesPartsThatLieOnEachOtherWithOtherNodes) {
  const auto expect = [](const std::string& message, const std::vector<std::string>& fragments) {
    for (const auto& fragment : fragments)
      EXPECT_NE(message.find(fragment), std::string::npos) << fragment << ": " << message;
  };
  const Box a{"a", {}, {1.0, 1.0, 1.0}, {2, 2, 2}};
  expect(joined({a, {"b", {0.0, 0.0, 1.0}, {1.0, 1.0, 2.0}, {3, 3, 3}}}),
         {"Interface \"seal\"", "4 faces of part \"a\" and 9 faces of part \"b\" lie on each other",
          "of the others 0 of each"});
  expect(joined({a, {"b", {0.0, 0.0, 1.0}, {1.0, 1.0, 2.0}, {1, 1, 1}}}),
         {"4 faces of part \"a\" and 1 face of part \"b\" lie"});
  // b overlaps half of a, and what is beyond.
  expect(joined({a, {"b", {0.5, 0.0, 1.0}, {1.5, 1.0, 2.0}, {1, 2, 1}}}), {"2 faces of part \"a\" and 2 faces"});
  // In the plane, and by any motion of both.
  expect(joined({{"a", {}, {1.0, 1.0, 0.0}, {2, 2, 0}, ElementType::quad4},
                 {"b", {0.0, 1.0, 0.0}, {1.0, 2.0, 0.0}, {3, 3, 0}, ElementType::quad4}}),
         {"2 faces of part \"a\" and 3 faces"});
  expect(joined({a, {"b", {0.0, 0.0, 1.0}, {1.0, 1.0, 2.0}, {3, 3, 3}}},
                [](Mesh& mesh) {
                  for (base::Vector3& x : mesh.nodes) {
                    x = {0.6 * x[0] - 0.8 * x[2] + 7.0, 1.3 * x[1] - 2.0, 0.8 * x[0] + 0.6 * x[2]};
                  }
                }),
         {"4 faces of part \"a\" and 9 faces"});
}

TEST(InterfaceFinder, RefusesTwoMeshesOfOneCurvedSurface) {
  // A ring in a ring: 12 facets in 16.
  const auto wind = [](Mesh& mesh) {
    for (base::Vector3& x : mesh.nodes) x = {x[1] * std::cos(x[0]), x[1] * std::sin(x[0]), x[2]};
  };
  const double turn = 1.5;
  EXPECT_NE(joined({{"a", {0.0, 1.0, 0.0}, {turn, 2.0, 1.0}, {8, 2, 1}},
                    {"b", {0.0, 2.0, 0.0}, {turn, 3.0, 1.0}, {12, 2, 1}}},
                   wind)
                .find("lie on each other"),
            std::string::npos);
  EXPECT_EQ(
      joined({{"a", {0.0, 1.0, 0.0}, {turn, 2.0, 1.0}, {8, 2, 1}}, {"b", {0.0, 2.0, 0.0}, {turn, 3.0, 1.0}, {8, 2, 1}}},
             wind),
      "no error");
}

TEST(InterfaceFinder, AcceptsPartsThatPartFromEachOther) {
  // Joined at x < 1, and from there on apart by a gap or by an opening angle.
  const auto apart = [](double gap, double slope) {
    return [gap, slope](Mesh& mesh) {
      for (base::Vector3& x : mesh.nodes) {
        const bool isUpper = &x - mesh.nodes.data() >= static_cast<std::ptrdiff_t>(mesh.nodes.size() / 2);
        if (isUpper && x[0] > 1.0) x[2] += gap + slope * (x[0] - 1.0);
      }
    };
  };
  const std::vector<Box> list = {{"a", {}, {3.0, 1.0, 1.0}, {6, 2, 2}},
                                 {"b", {0.0, 0.0, 1.0}, {3.0, 1.0, 2.0}, {6, 2, 2}}};
  EXPECT_EQ(joined(list), "no error");
  EXPECT_EQ(joined(list, apart(0.02, 0.0)), "no error");
  EXPECT_EQ(joined(list, apart(0.0, 0.2)), "no error");
  // They touch in an edge only.
  EXPECT_EQ(joined({{"a", {}, {1.0, 1.0, 1.0}, {1, 1, 1}}, {"b", {1.0, 0.0, 1.0}, {2.0, 1.0, 2.0}, {2, 1, 1}}}),
            "no error");
}

TEST(InterfaceFinder, SaysWhatIsWrong) {
  const Mesh mesh = boxes({{"a", {}, {1.0, 1.0, 1.0}, {2, 2, 2}},
                           {"b", {1.0, 0.0, 0.0}, {2.0, 1.0, 1.0}, {2, 3, 2}},
                           {"c", {5.0, 0.0, 0.0}, {6.0, 1.0, 1.0}, {1, 1, 1}}});
  const auto parts = onePartPerBlock(mesh);
  const InterfaceFinder finder(mesh, parts);
  const auto expect = [](const std::string& message, const std::vector<std::string>& fragments) {
    for (const auto& fragment : fragments) EXPECT_NE(message.find(fragment), std::string::npos) << message;
  };
  expect(messageOf([&] { finder.betweenSideSets("seal", "a_xmax", "b_xmin"); }),
         {"Interface \"seal\"", "\"a_xmax\" (4 faces, 9 nodes)", "\"b_xmin\" (6 faces, 12 nodes)", "do not conform",
          "Projection Direction"});
  expect(messageOf([&] { finder.betweenSideSets("seal", "a_xmax", "a_xmax"); }), {"do not conform"});
  expect(messageOf([&] { finder.betweenSideSets("seal", "a_xmx", "b_xmin"); }),
         {"no side set \"a_xmx\"", "\"a_xmax\""});
  expect(messageOf([&] { finder.betweenParts("seal", "a", "c"); }), {"no coincident faces", "4 apart"});
  expect(messageOf([&] { finder.betweenParts("seal", "a", "a"); }), {"Part 1 and Part 2 are both \"a\""});
  expect(messageOf([&] { finder.betweenParts("seal", "a", "d"); }), {"no part \"d\""});
  expect(messageOf([&] { finder.onSideSet("fix", "nothing"); }), {"Boundary \"fix\"", "no side set \"nothing\""});
  const std::vector<Piece> onlyA = {parts[0]};
  expect(messageOf([&] { InterfaceFinder(mesh, onlyA).onSideSet("fix", "b_xmin"); }),
         {"block \"b\"", "belongs to no part"});
  expect(messageOf([&] { InterfaceFinder(mesh, {parts[0], parts[0]}); }), {"both have elements of block \"a\""});
}

TEST(InterfaceFinder, RefusesFacesInsideOfAPart) {
  Mesh mesh = boxes({{"box", {}, {2.0, 1.0, 1.0}, {2, 1, 1}}});
  const Elements elements(mesh);
  const auto sideAt = [&](int element, double x) {
    for (int side = 0; side < 6; ++side) {
      const auto corners = pointsOf(mesh, elements.side(element, side));
      if (std::all_of(corners.begin(), corners.end(), [x](const base::Vector3& corner) { return corner[0] == x; }))
        return side;
    }
    return -1;
  };
  mesh.sideSets.push_back({"inside", 100, {0, 0}, {sideAt(0, 0.0), sideAt(0, 1.0)}});
  const std::vector<Piece> whole = {makePiece(mesh, "box", {"box"})};
  try {
    InterfaceFinder(mesh, whole).demandSurface("Boundary \"b\"", "inside");
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    EXPECT_NE(std::string(error.what()).find("1 of the 2 faces of side set \"inside\" lie inside of part \"box\""),
              std::string::npos)
        << error.what();
  }
  EXPECT_NO_THROW(InterfaceFinder(mesh, whole).demandSurface("", "box_xmin"));
  // Cut there by METIS the face is still inside; where two parts share the nodes it is the surface of both.
  const std::vector<Piece> pieces = {makePiece(mesh, "box.1", "box", {0}), makePiece(mesh, "box.2", "box", {1})};
  EXPECT_THROW(InterfaceFinder(mesh, pieces).demandSurface("", "inside"), base::Error);
  const std::vector<Piece> parts = {makePiece(mesh, "left", "left", {0}), makePiece(mesh, "right", "right", {1})};
  EXPECT_NO_THROW(InterfaceFinder(mesh, parts).demandSurface("", "inside"));
}

TEST(Piece, TellsElementsApartWhoseNodesAddUpToTheSame) {
  Mesh mesh = boxes({{"plate", {0, 0, 0}, {3, 1, 0}, {3, 1, 0}, ElementType::quad4}});
  ASSERT_EQ(mesh.nodes.size(), 8U);
  mesh.blocks[0].connectivity = {0, 1, 6, 5, 0, 2, 7, 3, 0, 3, 7, 2, 0, 1, 4, 7};  // the second and third are one
  try {
    makePiece(mesh, "plate", {"plate"});
    FAIL() << "accepted";
  } catch (const base::Error& error) {
    EXPECT_NE(std::string(error.what()).find("element 2 of the mesh (block \"plate\") and element 3"),
              std::string::npos)
        << error.what();
  }
  mesh.blocks[0].connectivity = {0, 1, 6, 5, 0, 2, 7, 3, 0, 1, 4, 7};
  EXPECT_EQ(makePiece(mesh, "plate", {"plate"}).elements.size(), 3U);
}

TEST(Piece, refusesAnElementThatIsThereTwice) {
  Mesh mesh = boxes({{"box", {0, 0, 0}, {2, 1, 1}, {2, 1, 1}}});
  std::vector<int>& nodes = mesh.blocks[0].connectivity;
  const std::vector<int> first(nodes.begin(), nodes.begin() + 8);
  nodes.insert(nodes.end(), first.begin(), first.end());
  try {
    makePiece(mesh, "box", {"box"});
    FAIL() << "accepted";
  } catch (const base::Error& error) {
    EXPECT_STREQ(error.what(),
                 "Part \"box\": element 1 of the mesh (block \"box\") and element 3 of the mesh (block \"box\") have "
                 "the same nodes; remove one of them.");
  }
}

}  // namespace
}  // namespace harmos::mesh
