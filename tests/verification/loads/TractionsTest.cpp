#include <gtest/gtest.h>

#include <cmath>

#include <harmos/base/Error.hpp>

#include "../elements/Body.hpp"

namespace harmos::verification {
namespace {

constexpr double tolerance = 1e-6;

/// A boundary of one entry with history and formula.
std::string load(const std::string& law, const std::string& entry, double value, const std::string& formula,
                 const std::string& more = "") {
  return xmlList("load",
                 xmlText("Side Set", "body_xmax") + xmlList("Law", xmlText("Type", law) + xmlNumber(entry, value) +
                                                                       xmlText(entry + " Formula", formula) + more));
}

/// A plate 4 x 1 whose left end is a plane of symmetry, with a pin at its middle.
SceneInput plate() {
  SceneInput scene = bodyOf({"Quad8", "Full Integration", 2}, {4, 2}, [](const base::Vector3& x) {
    return base::Vector3{4.0 * x[0], x[1] - 0.5, 0.0};
  });
  scene.add("Model", xmlText("Kinematics", "Plane Stress")).set("Materials/elastic/Poisson's Ratio=0");
  return scene.changeMesh([](mesh::Mesh& mesh) {
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      if (norm(mesh.nodes[n]) == 0.0) mesh.nodeSets = {{"pin", 1, {static_cast<int>(n)}}};
    }
  });
}

std::string support() {
  return boundary("wall", "body_xmin", "Symmetry") +
         xmlList("pin", xmlText("Node Set", "pin") +
                            xmlList("Law", xmlText("Type", "Prescribed Displacement") + xmlNumber("Y", 0.0)));
}

// sigma_xx = -12 M y t, which is exact everywhere without Poisson's effect: u_y = 6 M t x^2 / E.
TEST(FormulaLoads, BendPlatesPurely) {
  constexpr double moment = 0.01;
  for (const bool isPressure : {false, true}) {
    SceneInput scene = plate();
    const std::string formula = "12 * y * t";
    scene.add("Boundaries", support() + (isPressure ? load("Pressure", "Pressure", moment, formula)
                                                    : load("Prescribed Traction", "X", -moment, formula)));
    scene.remove("Steps/load").add("Steps", xmlList("load", xmlNumber("Duration", 2.0)));
    scene.add("Responses", meanDisplacement("lift", "body_xmax", {0, 1}));
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    EXPECT_NEAR(run.value("lift"), 12.0 * moment * 16.0 * 0.5 * 2.0, tolerance * 2.0);
  }
}

TEST(FormulaLoads, KeepTheirHistories) {
  SceneInput scene = plate();
  scene.add("Histories", xmlList("ramp", xmlText("Type", "Ramp") + xmlNumber("End", 4.0)));
  scene.add("Boundaries", support() + load("Prescribed Traction", "X", 8.0, "1 + y", xmlText("X History", "ramp")));
  scene.add("Responses", forceResponse("pull", "wall", {1, 0}));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_NEAR(run.value("pull"), -2.0, tolerance * 2.0);
}

TEST(FormulaLoads, NamePlacesWithoutValue) {
  SceneInput scene = plate();
  scene.add("Boundaries", support() + load("Pressure", "Pressure", 1.0, "sqrt(y)"));
  try {
    const SolvedScene run(scene);
    FAIL() << "accepted";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    const std::string message = error.what();
    EXPECT_NE(message.find("Pressure Formula: the formula \"sqrt(y)\" has no value at y = -0.5"), std::string::npos)
        << message;
  }
}

// The wall turns by a small angle, and takes the plate along without any stress.
TEST(FormulaLoads, TurnWallsAsTheySay) {
  constexpr double angle = 1e-3;
  SceneInput scene = plate();
  scene.add("Boundaries",
            xmlList("wall", xmlText("Side Set", "body_xmin") +
                                xmlList("Law", xmlText("Type", "Prescribed Displacement") + xmlNumber("X", angle) +
                                                   xmlText("X Formula", "-y * t") + xmlNumber("Y", 0.0))));
  scene.add("Responses", meanDisplacement("lift", "body_xmax", {0, 1}) + forceResponse("pull", "wall", {1, 0}));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_NEAR(run.value("lift"), 4.0 * angle, tolerance * 4.0 * angle);
}

// Springs that stiffen over the face carry the integral of their stiffness.
TEST(FormulaLoads, LetStiffnessesVaryOverTheFace) {
  SceneInput scene = plate().set("Materials/elastic/Young's Modulus=1e9");
  scene.add("Boundaries", xmlList("springs", xmlText("Side Set", "body_xmin") +
                                                 xmlList("Law", xmlText("Type", "Elastic Foundation") +
                                                                    xmlNumber("Normal Stiffness", 3.0) +
                                                                    xmlText("Normal Stiffness Formula", "2 + y"))) +
                              xmlList("pull", xmlText("Side Set", "body_xmax") +
                                                  xmlList("Law", xmlText("Type", "Prescribed Displacement") +
                                                                     xmlNumber("X", 0.01) + xmlNumber("Y", 0.0))));
  scene.add("Responses", forceResponse("force", "pull", {1, 0}));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_NEAR(std::abs(run.value("force")), 3.0 * 2.0 * 0.01, 1e-5 * 0.06);
}

}  // namespace
}  // namespace harmos::verification
