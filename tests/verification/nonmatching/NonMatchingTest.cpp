#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/Elements.hpp>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

constexpr double modulus = 1e6, nu = 0.3, pressure = 109.89;
// The accuracy asked for is 1e-10.
constexpr double tolerance = 1e-9;

struct Case {
  const char* law;
  const char* lower;  // cells
  const char* upper;
  const char* lowerElement;
  const char* upperElement;
  const char* pointsOn;
};

std::string nameOf(const ::testing::TestParamInfo<Case>& info) {
  std::string name = std::string(info.param.law) + info.param.lower + "To" + info.param.upper +
                     info.param.lowerElement + info.param.upperElement + info.param.pointsOn;
  std::string letters;
  for (const char letter : name) {
    if (std::isalnum(static_cast<unsigned char>(letter)) != 0) letters += letter;
  }
  return letters;
}

SceneInput sceneOf(const char* file, const Case& chosen) {
  SceneInput scene = SceneInput::fromFile(file);
  scene.set("Solver/Accuracy=1e-10");
  scene.set("Interfaces/contact/Law/Type=" + std::string(chosen.law));
  if (std::string(chosen.law) == "Coulomb Friction") scene.set("Interfaces/contact/Law/Friction Coefficient=0.2");
  scene.set("Interfaces/contact/Points On=" + std::string(chosen.pointsOn));
  scene.set("Mesh/Boxes/lower/Cells=" + std::string(chosen.lower));
  scene.set("Mesh/Boxes/upper/Cells=" + std::string(chosen.upper));
  scene.set("Mesh/Boxes/lower/Element=" + std::string(chosen.lowerElement));
  scene.set("Mesh/Boxes/upper/Element=" + std::string(chosen.upperElement));
  return scene;
}

void expectUniformPressure(const SolvedScene& run, const std::string& interface) {
  for (const PairValue& pair : run.pairs(interface)) {
    EXPECT_NEAR(pair.traction[0], -pressure, tolerance * pressure);
    if (pair.position[0] == 0.0 || pair.position[1] == 0.0) continue;  // held by planes of symmetry as well
    EXPECT_NEAR(pair.traction[1], 0.0, tolerance * pressure);
    EXPECT_NEAR(pair.traction[2], 0.0, tolerance * pressure);
  }
}

class NonMatchingPlane : public ::testing::TestWithParam<Case> {};

TEST_P(NonMatchingPlane, PassesThePatchTest) {
  const SolvedScene run(sceneOf("contact_patch/plane.xml", GetParam()));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double wide = nu * (1.0 + nu) * pressure / modulus;
  const double high = (1.0 - nu * nu) * pressure / modulus;
  EXPECT_NEAR(run.value("side"), wide, tolerance * wide);
  EXPECT_NEAR(run.value("lower_side"), wide, tolerance * wide);
  EXPECT_NEAR(run.value("top"), -high, tolerance * high);
  EXPECT_NEAR(run.value("force"), -pressure, tolerance * pressure);
  expectUniformPressure(run, "contact");
}

INSTANTIATE_TEST_SUITE_P(Cases, NonMatchingPlane,
                         ::testing::Values(Case{"Perfect", "{4, 2}", "{4, 2}", "Quad4", "Quad4", "Side 1"},
                                           Case{"Perfect", "{4, 2}", "{7, 3}", "Quad4", "Tri3", "Automatic"},
                                           Case{"Perfect", "{4, 2}", "{7, 3}", "Quad4", "Quad4", "Side 1"},
                                           Case{"Unilateral Contact", "{4, 2}", "{4, 2}", "Quad4", "Quad4", "Side 2"},
                                           Case{"Unilateral Contact", "{4, 2}", "{7, 3}", "Quad4", "Quad4", "Side 2"},
                                           Case{"Unilateral Contact", "{20, 2}", "{1, 1}", "Quad4", "Quad4", "Side 1"},
                                           Case{"Unilateral Contact", "{20, 2}", "{1, 1}", "Quad4", "Quad4", "Side 2"},
                                           Case{"Coulomb Friction", "{5, 2}", "{8, 3}", "Tri3", "Quad4", "Side 1"},
                                           Case{"Coulomb Friction", "{5, 2}", "{8, 3}", "Tri3", "Quad4", "Side 2"}),
                         nameOf);

class NonMatchingSpace : public ::testing::TestWithParam<Case> {};

TEST_P(NonMatchingSpace, PassesThePatchTest) {
  const SolvedScene run(sceneOf("contact_patch/space.xml", GetParam()));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  expectUniformPressure(run, "contact");
  for (const NodeValue& node : run.displacements()) EXPECT_LE(node.displacement[2], 1e-15);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, NonMatchingSpace,
    ::testing::Values(Case{"Perfect", "{2, 2, 1}", "{3, 3, 1}", "Hex8", "Tet4", "Automatic"},
                      Case{"Unilateral Contact", "{3, 2, 1}", "{2, 5, 1}", "Hex8", "Hex8", "Side 1"},
                      Case{"Unilateral Contact", "{3, 2, 1}", "{2, 5, 1}", "Tet4", "Hex8", "Side 2"},
                      Case{"Coulomb Friction", "{2, 2, 1}", "{3, 3, 1}", "Wedge6", "Pyramid5", "Side 1"},
                      Case{"Coulomb Friction", "{1, 1, 1}", "{6, 6, 1}", "Tet4", "Tet4", "Side 1"},
                      Case{"Perfect", "{3, 2, 1}", "{3, 2, 1}", "Hex8", "Tet4", "Automatic"},
                      Case{"Coulomb Friction", "{3, 2, 1}", "{3, 2, 1}", "Wedge6", "Hex8", "Automatic"}),
    nameOf);

/// Nodes that coincide are not enough: the areas of nodes of triangles are not those of quadrilaterals.
TEST(NonMatching, PassesThePatchTestBetweenPartsOfTheSameNodesAndDifferentFaces) {
  SceneInput scene =
      sceneOf("contact_patch/space.xml", {"Coulomb Friction", "{3, 2, 1}", "{3, 2, 1}", "Wedge6", "Hex8", "Automatic"});
  scene.remove("Interfaces/contact/Side 1");
  scene.remove("Interfaces/contact/Side 2");
  scene.set("Interfaces/contact/Part 1=lower");
  scene.set("Interfaces/contact/Part 2=upper");
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  expectUniformPressure(run, "contact");
}

/// Takes the elements of the block around the inclusion out of its place.
void hollowOut(mesh::Mesh& mesh) {
  const mesh::Elements elements(mesh);
  mesh::ElementBlock& around = mesh.blocks[0];
  const int nodesOfOne = mesh::nodesPerElement(around.type);
  const int count = around.elements();
  std::vector<int> left, number(elements.count(), -1);
  int next = 0;
  for (int e = 0; e < elements.count(); ++e) {
    const int* nodes = elements.nodes(e);
    base::Vector3 centre{};
    if (e < count) {
      for (int n = 0; n < nodesOfOne; ++n) centre = centre + (1.0 / nodesOfOne) * mesh.nodes[nodes[n]];
      const auto isInside = [](double x) { return x > 1.0 && x < 2.0; };
      if (std::all_of(centre.begin(), centre.begin() + mesh.dimension, isInside)) continue;
      left.insert(left.end(), nodes, nodes + nodesOfOne);
    }
    number[e] = next++;
  }
  around.connectivity = left;
  for (mesh::SideSet& set : mesh.sideSets) {
    for (int& element : set.element) element = number[element];
  }
}

struct Inclusion {
  int around;  // cells per length
  int core;
  const char* aroundElement;
  const char* coreElement;
  const char* pointsOn;
  int dimension;
};

class NonMatchingInclusion : public ::testing::TestWithParam<Inclusion> {};

/// Around a corner a stress has another traction on every face: one point for all of them cannot hold these, and with
/// one for each of them hardly anything would tell these apart.
TEST_P(NonMatchingInclusion, PassesThePatchTest) {
  const Inclusion& given = GetParam();
  SceneInput scene =
      SceneInput::fromFile(given.dimension == 3 ? "nonmatching/inclusion.xml" : "nonmatching/plane_inclusion.xml");
  const auto cells = [&](int count) {
    std::string text = "{";
    for (int d = 0; d < given.dimension; ++d) text += (d > 0 ? ", " : "") + std::to_string(count);
    return text + "}";
  };
  scene.set("Mesh/Boxes/around/Cells=" + cells(3 * given.around));
  scene.set("Mesh/Boxes/core/Cells=" + cells(given.core));
  scene.set("Mesh/Boxes/around/Element=" + std::string(given.aroundElement));
  scene.set("Mesh/Boxes/core/Element=" + std::string(given.coreElement));
  scene.set("Interfaces/glue/Points On=" + std::string(given.pointsOn));
  scene.changeMesh(hollowOut);
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_NEAR(run.value("top"), 3e-3, tolerance * 3e-3);
  EXPECT_NEAR(run.value("end"), 2e-3, tolerance * 3e-3);
  for (const PairValue& pair : run.pairs("glue")) {
    EXPECT_NEAR(norm(pair.traction), std::abs(std::round(pair.traction[0])), 10.0 * tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Cases, NonMatchingInclusion,
    ::testing::Values(Inclusion{1, 1, "Hex8", "Tet4", "Automatic", 3}, Inclusion{2, 3, "Hex8", "Tet4", "Side 1", 3},
                      Inclusion{2, 3, "Tet4", "Hex8", "Side 2", 3}, Inclusion{1, 5, "Hex8", "Hex8", "Automatic", 3},
                      Inclusion{1, 2, "Hex20", "Tet10", "Automatic", 3},
                      Inclusion{1, 2, "Wedge15", "Pyramid5", "Automatic", 3},
                      Inclusion{2, 3, "Quad4", "Tri3", "Side 1", 2}, Inclusion{3, 1, "Tri6", "Quad8", "Automatic", 2}));

TEST(NonMatching, CarriesAPressureUniformlyOverPartlyCoveredFaces) {
  for (const char* pointsOn : {"Automatic", "Side 1", "Side 2"}) {
    SceneInput scene = SceneInput::fromFile("nonmatching/partial_cover.xml");
    for (const char* interface : {"left_seat", "right_seat"}) {
      scene.set("Interfaces/" + std::string(interface) + "/Points On=" + pointsOn);
    }
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    const double high = (1.0 - nu * nu) * pressure / modulus;
    const double wide = 2.0 * nu * (1.0 + nu) * pressure / modulus;
    EXPECT_NEAR(run.value("left_top"), -high, tolerance * high);
    EXPECT_NEAR(run.value("right_top"), -high, tolerance * high);
    EXPECT_NEAR(run.value("lower_side"), wide, tolerance * wide);
    expectUniformPressure(run, "left_seat");
    expectUniformPressure(run, "right_seat");
  }
}

/// Corners of a face that a block covers in part only would hold it up beside itself; with half of the shear it stands.
TEST(NonMatching, HoldsABlockUpNowhereButBelowIt) {
  SceneInput scene = SceneInput::fromFile("nonmatching/tipping.xml");
  EXPECT_EQ(SolvedScene(scene).result.outcome, latin::Outcome::noEquilibrium);
  EXPECT_TRUE(SolvedScene(scene.set("Boundaries/top/Law/X=0.35")).isCertified());
}

/// A matching mesh that is joined on the points of one side is the same interface.
TEST(NonMatching, GivesTheResultsOfPairsWhereMeshesMatch) {
  SceneInput scene = SceneInput::fromFile("contact_patch/plane.xml");
  scene.set("Interfaces/contact/Law/Type=Coulomb Friction");
  scene.set("Interfaces/contact/Law/Friction Coefficient=0.1");
  scene.set("Boundaries/left_upper/Law/Type=Prescribed Displacement");
  scene.set("Boundaries/left_upper/Law/X=3e-5");
  scene.set("Solver/Accuracy=1e-9");
  const SolvedScene pairs(scene);
  scene.set("Interfaces/contact/Points On=Side 2");
  const SolvedScene points(scene);
  ASSERT_TRUE(pairs.isCertified());
  ASSERT_TRUE(points.isCertified());
  EXPECT_EQ(points.result.iterations, pairs.result.iterations);
  EXPECT_LT(displacementDifference(points, pairs), 1e-8);
}

/// METIS may cut the part whose nodes are the points, and the other one as well, whose elements there it leaves
/// together: the interface stays as it is.
TEST(NonMatching, StaysAsItIsWhenItsPartsAreCut) {
  for (const char* file : {"contact_patch/plane.xml", "contact_patch/space.xml"}) {
    const bool isPlane = std::string(file) == "contact_patch/plane.xml";
    SceneInput scene = SceneInput::fromFile(file);
    scene.set("Interfaces/contact/Law/Type=Coulomb Friction");
    scene.set("Interfaces/contact/Law/Friction Coefficient=0.1");
    scene.set("Mesh/Boxes/lower/Cells=" + std::string(isPlane ? "{8, 4}" : "{4, 4, 2}"));
    scene.set("Mesh/Boxes/upper/Cells=" + std::string(isPlane ? "{5, 2}" : "{3, 3, 2}"));
    scene.add("Materials",
              "<ParameterList name='soft'>"
              "<Parameter name='Type' type='string' value='Isotropic'/>"
              "<Parameter name=\"Young's Modulus\" type='double' value='1e5'/>"
              "<Parameter name=\"Poisson's Ratio\" type='double' value='0.4'/></ParameterList>");
    scene.set("Parts/upper/Material=soft");
    scene.set("Solver/Accuracy=1e-8");
    const SolvedScene whole(scene);
    ASSERT_TRUE(whole.isCertified());
    for (const char* also : {"lower", "upper"}) {
      scene.set("Parts/" + std::string(also) + "/Pieces=4");
      const SolvedScene cut(scene);
      ASSERT_TRUE(cut.isCertified());
      EXPECT_NEAR(cut.value("top"), whole.value("top"), 1e-7 * std::abs(whole.value("top")));
      EXPECT_NEAR(cut.value("side"), whole.value("side"), 1e-7 * std::abs(whole.value("side")));
      EXPECT_EQ(cut.pairs("contact").size(), whole.pairs("contact").size());
    }
  }
}

/// The same wherever the bodies are in space.
TEST(NonMatching, PassesThePatchTestInAnyOrientation) {
  SceneInput scene =
      sceneOf("contact_patch/space.xml", {"Unilateral Contact", "{3, 2, 1}", "{2, 5, 1}", "Tet4", "Hex8", "Automatic"});
  scene.changeMesh([](mesh::Mesh& mesh) {
    const base::Vector3 axis = (1.0 / std::sqrt(14.0)) * base::Vector3{1.0, 2.0, 3.0};
    for (base::Vector3& x : mesh.nodes) {
      const double c = std::cos(0.7), s = std::sin(0.7);
      x = c * x + s * cross(axis, x) + (1.0 - c) * dot(axis, x) * axis + base::Vector3{0.3, -1.1, 2.0};
    }
  });
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  for (const PairValue& pair : run.pairs("contact")) EXPECT_NEAR(pair.traction[0], -pressure, tolerance * pressure);
}

/// Lame's rings of radii 1, 2 and 3 with an interference of 0.002, by facets that deviate by up to 0.0015: with Gap =
/// Closed these do not count.
TEST(NonMatching, PressesARingOntoAnother) {
  const double plane = modulus / (1.0 - nu * nu);
  const double exact = plane * 0.002 / 2.0 * 5.0 * 3.0 / (2.0 * 4.0 * 8.0);
  for (const char* pointsOn : {"Side 1", "Side 2"}) {
    SceneInput scene = SceneInput::fromFile("nonmatching/press_fit.xml");
    scene.set("Interfaces/contact/Points On=" + std::string(pointsOn));
    scene.changeMesh([](mesh::Mesh& mesh) {
      for (base::Vector3& x : mesh.nodes) {
        const double angle = 0.5 * std::acos(-1.0) * x[1];
        x = {x[0] * std::cos(angle), x[0] * std::sin(angle), 0.0};
      }
    });
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    EXPECT_NEAR(run.value("force"), -exact * 2.0, 0.01 * exact * 2.0);
    for (const PairValue& pair : run.pairs("contact")) EXPECT_NEAR(pair.traction[0], -exact, 0.03 * exact);
  }
}

/// A scene of the cylinders, in which the mesh of one body is another one.
TEST(NonMatching, GivesTheContactOfHertz) {
  constexpr double radius = 50.0, length = 15.0, force = 500.0, halfWidth = 0.371395, peak = 857.07;
  // Points of the rigid plane only where its mesh is the coarser one: it does not give way.
  for (const auto& [cells, pointsOn] :
       {std::pair("{45, 4}", "Side 1"), std::pair("{45, 4}", "Automatic"), std::pair("{77, 4}", "Automatic")}) {
    SceneInput scene = SceneInput::fromFile("cylinders/hertz.xml");
    scene.remove("Interfaces/contact/Projection Direction");
    scene.set("Interfaces/contact/Points On=" + std::string(pointsOn));
    scene.set("Mesh/Boxes/plane/Cells=" + std::string(cells));
    scene.set("Values/pressure=" + std::to_string(0.5 * force / length));
    scene.changeMesh([&](mesh::Mesh& mesh) {
      // Graded towards the contact; the upper body with its radius below.
      const auto graded = [&](double s) { return length * std::sinh(4.0 * s) / std::sinh(4.0); };
      const std::vector<int>& lower = mesh.blocks[0].connectivity;
      const int last = *std::max_element(lower.begin(), lower.end());
      for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node) {
        base::Vector3& at = mesh.nodes[node];
        const double x = graded(at[0]), y = graded(at[1]);
        const double depth = node <= last ? 0.0 : x * x / (radius + std::sqrt(radius * radius - x * x));
        at = {x, y + depth * (1.0 - std::abs(y) / length), 0.0};
      }
    });
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    EXPECT_NEAR(run.value("P"), 0.5 * force, 1e-3 * force);
    EXPECT_NEAR(run.value("p0"), peak, 0.03 * peak);
    double widest = 0.0;
    for (const PairValue& pair : run.pairs("contact")) {
      if (pair.status != laws::Status::open) widest = std::max(widest, std::abs(pair.position[0]));
    }
    EXPECT_NEAR(widest, halfWidth, 0.12 * halfWidth);
  }
}

}  // namespace
}  // namespace harmos::verification
