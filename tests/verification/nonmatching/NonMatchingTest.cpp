#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>

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
                      Case{"Coulomb Friction", "{1, 1, 1}", "{6, 6, 1}", "Tet4", "Tet4", "Side 1"}),
    nameOf);

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

/// METIS may cut the part whose nodes are the points: the interface stays as it is.
TEST(NonMatching, StaysAsItIsWhenThePartWithThePointsIsCut) {
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
    scene.set("Parts/lower/Pieces=4");
    const SolvedScene cut(scene);
    ASSERT_TRUE(whole.isCertified());
    ASSERT_TRUE(cut.isCertified());
    EXPECT_NEAR(cut.value("top"), whole.value("top"), 1e-7 * std::abs(whole.value("top")));
    EXPECT_NEAR(cut.value("side"), whole.value("side"), 1e-7 * std::abs(whole.value("side")));
    EXPECT_EQ(cut.pairs("contact").size(), whole.pairs("contact").size());
    scene.set("Parts/upper/Pieces=4");
    EXPECT_THROW(SolvedScene{scene}, base::Error);
  }
}

}  // namespace
}  // namespace harmos::verification
