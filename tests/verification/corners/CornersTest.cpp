#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/scene/MeshSource.hpp>
#include <harmos/scene/Problem.hpp>

#include "SolvedScene.hpp"

// Sets that turn corners: the stress is uniform, as with one boundary or interface per face.

namespace harmos::verification {
namespace {

constexpr double modulus = 1000.0, nu = 0.3;
// Ten times the accuracy asked for.
constexpr double tolerance = 1e-7;

/// One set of all sides `body_<axis><end>`.
void unite(mesh::Mesh& mesh, const std::string& name, const std::string& end) {
  mesh::SideSet all;
  for (const mesh::SideSet& set : mesh.sideSets) {
    all.id = std::max(all.id, set.id + 1);
    if (set.name.size() < end.size() || set.name.substr(set.name.size() - end.size()) != end) continue;
    all.element.insert(all.element.end(), set.element.begin(), set.element.end());
    all.side.insert(all.side.end(), set.side.begin(), set.side.end());
  }
  all.name = name;
  mesh.sideSets.push_back(all);
}

/// Makes the elements whose centre has all coordinates above 1/3 a block of their own, "inner", which shares nodes with
/// the rest. Side sets follow their elements.
void divide(mesh::Mesh& mesh) {
  const mesh::ElementBlock whole = mesh.blocks.at(0);
  const int nodes = mesh::nodesPerElement(whole.type);
  mesh::ElementBlock outer = whole, inner = whole;
  outer.connectivity.clear();
  inner.connectivity.clear();
  inner.name = "inner";
  inner.id = whole.id + 1;
  std::vector<std::pair<bool, int>> place;  // is inner, position there
  for (int e = 0; e < whole.elements(); ++e) {
    const auto first = whole.connectivity.begin() + e * nodes;
    bool isInner = true;
    for (int c = 0; c < mesh.dimension; ++c) {
      double centre = 0.0;
      for (int i = 0; i < nodes; ++i) centre += mesh.nodes[first[i]][c] / nodes;
      isInner = isInner && centre > 1.0 / 3.0;
    }
    mesh::ElementBlock& to = isInner ? inner : outer;
    place.emplace_back(isInner, to.elements());
    to.connectivity.insert(to.connectivity.end(), first, first + nodes);
  }
  for (mesh::SideSet& set : mesh.sideSets) {
    for (int& element : set.element) element = place[element].second + (place[element].first ? outer.elements() : 0);
  }
  mesh.blocks = {outer, inner};
}

mesh::Mesh meshOf(const SceneInput& input) {
  const scene::Scene scene = input.scene();
  return scene::makeMesh(scene.input.list("Mesh"), scene.path);
}

/// The strains of stresses -1, -2 (and -3) along the axes.
base::Vector3 strains(int dimension) {
  if (dimension == 2) {
    const double factor = (1.0 + nu) / modulus;
    return {factor * (-1.0 + 3.0 * nu), factor * (-2.0 + 3.0 * nu), 0.0};
  }
  return {(-1.0 + 5.0 * nu) / modulus, (-2.0 + 4.0 * nu) / modulus, (-3.0 + 3.0 * nu) / modulus};
}

struct Case {
  const char* name;
  int dimension;
  const char* law;                   // of the set that turns
  std::vector<const char*> changes;  // as --set
};

SceneInput sceneOf(const Case& chosen) {
  SceneInput scene = SceneInput::fromFile(chosen.dimension == 2 ? "corners/plane.xml" : "corners/space.xml");
  for (const char* change : chosen.changes) scene.set(change);
  return scene;
}

void expectUniformStrain(const SolvedScene& run, const SceneInput& scene, int dimension) {
  const base::Vector3 strain = strains(dimension);
  const mesh::Mesh mesh = meshOf(scene);
  for (const NodeValue& node : run.displacements()) {
    const base::Vector3& x = mesh.nodes[node.meshNode];
    for (int c = 0; c < dimension; ++c) {
      EXPECT_NEAR(node.displacement[c], strain[c] * x[c], tolerance * std::abs(strain[dimension - 1]));
    }
  }
}

/// Every pair presses with the pressure of its face and carries nothing along it; the faces have these areas.
void expectPressures(const std::vector<PairValue>& pairs, int dimension, double areaOfFace) {
  std::map<int, double> area;  // by pressure
  for (const PairValue& pair : pairs) {
    const int pressure = static_cast<int>(std::lround(-pair.traction[0]));
    EXPECT_NEAR(-pair.traction[0], pressure, tolerance * dimension);
    area[pressure] += pair.area;
  }
  ASSERT_EQ(area.size(), static_cast<std::size_t>(dimension));
  for (int pressure = 1; pressure <= dimension; ++pressure) EXPECT_NEAR(area[pressure], areaOfFace, 1e-12);
}

class Corner : public ::testing::TestWithParam<Case> {};

TEST_P(Corner, IsHeldAsFaceByFace) {
  SceneInput scene = sceneOf(GetParam());
  scene.set("Boundaries/held/Law/Type=" + std::string(GetParam().law));
  scene.changeMesh([](mesh::Mesh& mesh) { unite(mesh, "corner", "min"); });
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  expectUniformStrain(run, scene, GetParam().dimension);
  expectPressures(run.pairs("held"), GetParam().dimension, 1.0);
}

/// A block in the corner of the other elements, with this law between them.
SceneInput nested(const Case& chosen, const std::string& law) {
  SceneInput scene = sceneOf(chosen);
  scene.changeMesh([](mesh::Mesh& mesh) {
    unite(mesh, "corner", "min");
    divide(mesh);
  });
  scene.add("Parts", xmlList("inner", xmlText("Material", "solid")));
  return scene.add("Interfaces", xmlList("seal", xmlText("Part 1", "inner") + xmlText("Part 2", "body") +
                                                     xmlList("Law", xmlText("Type", law))));
}

TEST_P(Corner, IsPressedBetweenPartsAsFaceByFace) {
  const SceneInput scene = nested(GetParam(), "Unilateral Contact");
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  expectUniformStrain(run, scene, GetParam().dimension);
  expectPressures(run.pairs("seal"), GetParam().dimension, std::pow(2.0 / 3.0, GetParam().dimension - 1));
}

TEST_P(Corner, CarriesTheLoadsByFriction) {
  // What a node at the crease carries by the pressure of one face and by the friction of the other is not determined;
  // their sum is.
  const int dimension = GetParam().dimension;
  SceneInput scene = nested(GetParam(), "Coulomb Friction").set("Interfaces/seal/Law/Friction Coefficient=0.2");
  for (int c = 0; c < dimension; ++c) {
    std::vector<double> direction(dimension, 0.0);
    direction[c] = 1.0;
    scene.add("Responses", forceResponse(std::string(1, "xyz"[c]), "seal", direction));
  }
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  expectUniformStrain(run, scene, dimension);
  for (int c = 0; c < dimension; ++c) {
    const double force = (c + 1) * std::pow(2.0 / 3.0, dimension - 1);
    EXPECT_NEAR(run.value(std::string(1, "xyz"[c])), force, tolerance * force);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Corner,
    ::testing::Values(Case{"SymmetryInThePlane", 2, "Symmetry", {}},
                      Case{"ContactInThePlane", 2, "Unilateral Contact", {}},
                      Case{"Triangles", 2, "Unilateral Contact", {"Mesh/Boxes/body/Element=Tri3"}},
                      Case{"CutInThePlane", 2, "Unilateral Contact", {"Parts/body/Pieces=3"}},
                      Case{"ConsistentInThePlane", 2, "Symmetry", {"Solver/Interface Mass=Consistent"}},
                      Case{"SymmetryInSpace", 3, "Symmetry", {}}, Case{"ContactInSpace", 3, "Unilateral Contact", {}},
                      Case{"Tetrahedra", 3, "Unilateral Contact", {"Mesh/Boxes/body/Element=Tet4"}},
                      Case{"CutInSpace", 3, "Unilateral Contact", {"Parts/body/Pieces=3"}},
                      Case{"ConsistentInSpace", 3, "Symmetry", {"Solver/Interface Mass=Consistent"}}),
    [](const auto& test) { return test.param.name; });

TEST(RanksCorner, IsHeldAsFaceByFace) {
  const Case chosen{"", 3, "", {"Parts/body/Pieces=4"}};
  SceneInput scene = sceneOf(chosen);
  scene.changeMesh([](mesh::Mesh& mesh) { unite(mesh, "corner", "min"); });
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  expectUniformStrain(run, scene, 3);
  expectPressures(run.pairs("held"), 3, 1.0);
}

std::string messageOf(const SceneInput& input) {
  base::Timers timers;
  try {
    scene::makeProblem(input.scene(), *Tpetra::getDefaultComm(), timers);
  } catch (const base::Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(CornersTest, RefusesNodesWithoutNormal) {
  SceneInput scene = SceneInput::fromFile("corners/space.xml").set("Mesh/Boxes/body/Cells={2, 2, 2}");
  scene.changeMesh([](mesh::Mesh& mesh) {
    unite(mesh, "corner", "min");
    mesh.nodeSets.push_back({"inside", 1, {13}});  // the middle of 3 x 3 x 3
  });
  scene.add("Boundaries",
            xmlList("point", xmlText("Node Set", "inside") + xmlList("Law", xmlText("Type", "Symmetry"))));
  const std::string message = messageOf(scene);
  EXPECT_NE(message.find("\"Symmetry\" depends on the normal, which 1 node at (0.5, 0.5, 0.5) does not have"),
            std::string::npos)
      << message;
  scene.set("Boundaries/point/Law/Type=Prescribed Traction");
  EXPECT_EQ(messageOf(scene), "no error");
}

TEST(CornersTest, RefusesAPreloadAroundACorner) {
  SceneInput scene = SceneInput::fromFile("corners/space.xml");
  scene.changeMesh([](mesh::Mesh& mesh) {
    unite(mesh, "corner", "min");
    divide(mesh);
  });
  scene.add("Parts", xmlList("inner", xmlText("Material", "solid")));
  scene.add("Interfaces",
            xmlList("seal", xmlText("Part 1", "inner") + xmlText("Part 2", "body") +
                                xmlList("Law", xmlText("Type", "Preload Jump") + xmlNumber("Jump", 1e-3))));
  const std::string message = messageOf(scene);
  EXPECT_NE(message.find("\"Preload Jump\" has no meaning at a crease, where the normal is not unique: 7 nodes"),
            std::string::npos)
      << message;
  EXPECT_EQ(messageOf(scene.set("Interfaces/seal/Crease Angle=100")), "no error");
}

TEST(CornersTest, RefusesALawInsideAPart) {
  SceneInput scene = SceneInput::fromFile("corners/space.xml");
  scene.changeMesh([](mesh::Mesh& mesh) {
    unite(mesh, "corner", "min");
    mesh::SideSet inside{"inside", 100, {0, 0, 0}, {}};
    for (int side = 0; side < 6; ++side) {  // the three sides of the first element that are not outside
      const auto corners = mesh::pointsOf(mesh, mesh::Elements(mesh).side(0, side));
      double least = 1.0;
      for (int c = 0; c < 3; ++c) {
        double largest = 0.0;
        for (const auto& corner : corners) largest = std::max(largest, corner[c]);
        least = std::min(least, largest);
      }
      if (least > 0.0) inside.side.push_back(side);
    }
    mesh.sideSets.push_back(inside);
  });
  scene.add("Responses", xmlList("mean", xmlText("Type", "Mean Displacement") + xmlText("Side Set", "inside") +
                                             xmlNumbers("Direction", {1.0, 0.0, 0.0})));
  EXPECT_EQ(messageOf(scene), "no error") << "a response may look inside";
  scene.add("Boundaries",
            xmlList("inner", xmlText("Side Set", "inside") + xmlList("Law", xmlText("Type", "Symmetry"))));
  const std::string message = messageOf(scene);
  EXPECT_NE(message.find("3 of the 3 faces of side set \"inside\" lie inside of part \"body\""), std::string::npos)
      << message;
}

TEST(CornersTest, HoldsASteepTip) {
  // A pyramid of four steep faces, pushed up from below into a pyramid that does not give way: at its tip more normals
  // meet than there are directions.
  for (const char* law : {"Symmetry", "Unilateral Contact"}) {
    SceneInput scene = SceneInput::fromFile("corners/space.xml");
    scene.set("Mesh/Boxes/body/Cells={2, 2, 1}").set("Mesh/Boxes/body/Element=Tet4");
    scene.changeMesh([](mesh::Mesh& mesh) {
      for (base::Vector3& point : mesh.nodes) {
        if (point[0] == 0.5 && point[1] == 0.5 && point[2] == 1.0) point[2] = 3.0;
      }
    });
    scene.set("Boundaries/held/Side Set=body_zmax").set("Boundaries/held/Law/Type=" + std::string(law));
    scene.set("Boundaries/pressed_z/Side Set=body_zmin").remove("Boundaries/pressed_x").remove("Boundaries/pressed_y");
    scene.add("Responses",
              forceResponse("z", "held", {0.0, 0.0, 1.0}) +
                  xmlList("tip", xmlText("Type", "Point Displacement") + xmlNumbers("Point", {0.5, 0.5, 3.0}) +
                                     xmlNumbers("Direction", {0.0, 0.0, 1.0})));
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << law << ": " << run.result.reason;
    EXPECT_NEAR(run.value("z"), -3.0, 3.0 * tolerance) << law;
    if (std::string(law) == "Symmetry") {
      EXPECT_NEAR(run.value("tip"), 0.0, tolerance * 3.0 / modulus);
    }
  }
}

/// A pressure on the whole skin of a body in balance with itself, and on a polygon that stands for a circle.
class PressureOnCorners : public ::testing::TestWithParam<const char*> {};

TEST_P(PressureOnCorners, IsHydrostatic) {
  SceneInput scene = SceneInput::fromFile("corners/space.xml").set(GetParam());
  scene.changeMesh([](mesh::Mesh& mesh) {
    unite(mesh, "corner", "min");
    unite(mesh, "outside", "max");
  });
  for (const char* axis : {"x", "y", "z"}) scene.remove("Boundaries/pressed_" + std::string(axis));
  scene.add("Boundaries",
            xmlList("pressed", xmlText("Side Set", "outside") +
                                   xmlList("Law", xmlText("Type", "Pressure") + xmlNumber("Pressure", 2.0))));
  scene.add("Responses", forceResponse("x", "pressed", {1.0, 0.0, 0.0}) + forceResponse("z", "held", {0.0, 0.0, 1.0}));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_NEAR(run.value("x"), -2.0, 1e-12);
  EXPECT_NEAR(run.value("z"), 2.0, tolerance);
  const double strain = -2.0 * (1.0 - 2.0 * nu) / modulus;
  const mesh::Mesh mesh = meshOf(scene);
  for (const NodeValue& node : run.displacements()) {
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(node.displacement[c], strain * mesh.nodes[node.meshNode][c], tolerance * std::abs(strain));
    }
  }
}

TEST_P(PressureOnCorners, HasTheResultantOfThePolygon) {
  SceneInput scene = SceneInput::fromFile("corners/plane.xml").set(GetParam());
  // A quarter of a ring of three facets, with radii 1 and 2.
  scene.changeMesh([](mesh::Mesh& mesh) {
    for (base::Vector3& point : mesh.nodes) {
      const double angle = 0.5 * std::acos(-1.0) * point[1];
      point = {(1.0 + point[0]) * std::cos(angle), (1.0 + point[0]) * std::sin(angle), 0.0};
    }
  });
  scene.set("Boundaries/held/Side Set=body_ymin").set("Boundaries/pressed_x/Side Set=body_xmin");
  scene.set("Boundaries/pressed_y/Side Set=body_ymax").set("Boundaries/pressed_y/Law/Type=Symmetry");
  scene.remove("Boundaries/pressed_y/Law/Pressure");
  scene.add("Responses", forceResponse("x", "pressed_x", {1.0, 0.0}) + forceResponse("y", "pressed_x", {0.0, 1.0}) +
                             forceResponse("held", "held", {0.0, 1.0}));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_NEAR(run.value("x"), 1.0, 1e-12);
  EXPECT_NEAR(run.value("y"), 1.0, 1e-12);
  EXPECT_NEAR(run.value("held"), -1.0, tolerance);
}

INSTANTIATE_TEST_SUITE_P(Cases, PressureOnCorners,
                         ::testing::Values("Parts/body/Pieces=1", "Parts/body/Pieces=3",
                                           "Solver/Interface Mass=Consistent"),
                         [](const auto& test) {
                           return std::string(test.index == 0 ? "Whole" : test.index == 1 ? "Cut" : "Consistent");
                         });

}  // namespace
}  // namespace harmos::verification
