#include <gtest/gtest.h>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

constexpr double modulus = 1e6, nu = 0.3, pressure = 109.89;
// Ten times the accuracy asked for.
constexpr double tolerance = 1e-6;

struct Case {
  const char* name;
  const char* law;
  const char* element;  // empty: the default
};

void chooseCase(SceneInput& scene, const Case& chosen) {
  const std::string law = chosen.law;
  scene.set("Interfaces/contact/Law/Type=" + law);
  if (law == "Coulomb Friction") scene.set("Interfaces/contact/Law/Friction Coefficient=0.2");
  if (*chosen.element == '\0') return;
  for (const char* box : {"lower", "upper"}) {
    scene.set("Mesh/Boxes/" + std::string(box) + "/Element=" + chosen.element);
  }
}

/// The tractions are uniform: pressure, and nothing along the interface.
void expectUniformPressure(const SolvedScene& run) {
  for (const PairValue& pair : run.pairs("contact")) {
    EXPECT_NEAR(pair.traction[0], -pressure, tolerance * pressure);
    // Both sides of a node on a plane of symmetry are held there, so that what the interface carries along itself and
    // what the plane does cannot be told apart.
    if (pair.position[0] == 0.0 || pair.position[1] == 0.0) continue;
    EXPECT_NEAR(pair.traction[1], 0.0, tolerance * pressure);
    EXPECT_NEAR(pair.traction[2], 0.0, tolerance * pressure);
  }
}

class ContactPatch : public ::testing::TestWithParam<Case> {};
class ContactPatchPlane : public ContactPatch {};
class ContactPatchSpace : public ContactPatch {};

TEST_P(ContactPatchPlane, IsExact) {
  SceneInput scene = SceneInput::fromFile("contact_patch/plane.xml");
  chooseCase(scene, GetParam());
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  // Plane strain, sigma_y = -p, sigma_x = 0, unit cube: eps_x = nu (1 + nu) p / E, eps_y = -(1 - nu^2) p / E.
  const double wide = nu * (1.0 + nu) * pressure / modulus;
  const double high = (1.0 - nu * nu) * pressure / modulus;
  EXPECT_NEAR(wide, 4.28571e-5, 1e-10);
  EXPECT_NEAR(run.value("side"), wide, tolerance * wide);
  EXPECT_NEAR(run.value("lower_side"), wide, tolerance * wide);
  EXPECT_NEAR(run.value("top"), -high, tolerance * high);
  EXPECT_NEAR(run.value("force"), -pressure, tolerance * pressure);
  expectUniformPressure(run);
}

INSTANTIATE_TEST_SUITE_P(Cases, ContactPatchPlane,
                         ::testing::Values(Case{"Frictionless", "Unilateral Contact", ""},
                                           Case{"Friction", "Coulomb Friction", ""}, Case{"Bonded", "Perfect", ""},
                                           Case{"Triangles", "Coulomb Friction", "Tri3"},
                                           Case{"QuadraticQuadrilaterals", "Coulomb Friction", "Quad8"},
                                           Case{"QuadraticTriangles", "Unilateral Contact", "Tri6"}),
                         [](const auto& test) { return test.param.name; });

TEST_P(ContactPatchSpace, IsExact) {
  SceneInput scene = SceneInput::fromFile("contact_patch/space.xml");
  chooseCase(scene, GetParam());
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  // Uniaxial stress: eps_x = nu p / E, eps_z = -p / E.
  const double wide = nu * pressure / modulus;
  const double high = pressure / modulus;
  EXPECT_NEAR(run.value("side"), wide, tolerance * wide);
  EXPECT_NEAR(run.value("lower_side"), wide, tolerance * wide);
  EXPECT_NEAR(run.value("top"), -high, tolerance * high);
  EXPECT_NEAR(run.value("force"), -pressure, tolerance * pressure);
  expectUniformPressure(run);
}

INSTANTIATE_TEST_SUITE_P(Cases, ContactPatchSpace,
                         ::testing::Values(Case{"Frictionless", "Unilateral Contact", ""},
                                           Case{"Friction", "Coulomb Friction", ""}, Case{"Bonded", "Perfect", ""},
                                           Case{"Tetrahedra", "Coulomb Friction", "Tet4"},
                                           Case{"Wedges", "Coulomb Friction", "Wedge6"},
                                           Case{"Pyramids", "Coulomb Friction", "Pyramid5"},
                                           Case{"QuadraticHexahedra", "Coulomb Friction", "Hex20"},
                                           Case{"FullHexahedra", "Unilateral Contact", "Hex27"},
                                           Case{"QuadraticTetrahedra", "Coulomb Friction", "Tet10"},
                                           Case{"QuadraticWedges", "Unilateral Contact", "Wedge15"}),
                         [](const auto& test) { return test.param.name; });

/// The lower block on the ground, on which laws act that need tractions between nodes. With two pieces, it is glued to
/// the upper one.
void expectPatchOnGround(const char* file, const char* element, const char* law, int pieces) {
  constexpr double stiffness = 1e7;
  SceneInput scene = SceneInput::fromFile(file);
  chooseCase(scene, {"", pieces > 1 ? "Perfect" : "Unilateral Contact", element});
  scene.set("Boundaries/bottom/Law/Type=" + std::string(law));
  const bool hasSprings = std::string(law) == "Elastic Foundation";
  if (hasSprings) scene.set("Boundaries/bottom/Law/Normal Stiffness=" + std::to_string(stiffness));
  scene.set("Parts/lower/Pieces=" + std::to_string(pieces));
  const SolvedScene run(scene);
  const std::string what = std::string(element) + ", " + law + ", " + std::to_string(pieces);
  ASSERT_TRUE(run.isCertified()) << what << ": " << run.result.reason;
  const bool isPlane = std::string(file).find("plane") != std::string::npos;
  const double high = (isPlane ? 1.0 - nu * nu : 1.0) * pressure / modulus + (hasSprings ? pressure / stiffness : 0.0);
  EXPECT_NEAR(run.value("top"), -high, tolerance * high) << what;
  double area = 0.0;
  for (const PairValue& pair : run.pairs("bottom")) {
    EXPECT_NEAR(pair.traction[0], -pressure, tolerance * pressure) << what;
    area += pair.area;
  }
  EXPECT_NEAR(area, 1.0, tolerance) << what;
}

TEST(ContactPatch, IsExactOnTheGroundWithQuadraticElements) {
  for (const char* law : {"Unilateral Contact", "Elastic Foundation"}) {
    for (const char* element : {"Quad8", "Tri6"}) {
      for (const int pieces : {1, 2}) expectPatchOnGround("contact_patch/plane.xml", element, law, pieces);
    }
  }
  for (const char* element : {"Hex20", "Hex27", "Tet10", "Wedge15"}) {
    expectPatchOnGround("contact_patch/space.xml", element, "Unilateral Contact", 1);
  }
  expectPatchOnGround("contact_patch/space.xml", "Tet10", "Elastic Foundation", 2);
}

}  // namespace
}  // namespace harmos::verification
