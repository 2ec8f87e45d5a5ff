#include <gtest/gtest.h>

#include <cmath>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

SceneInput gluedAssembly(double factor1, double factor2) {
  SceneInput scene = SceneInput::fromFile("../../xml/glued_assembly.xml");
  constexpr double normal1 = 500.0 / 0.3, normal2 = 1000.0 / 0.3, shear = 1.0 / 2.9;
  const auto set = [&](const std::string& glue, double stiffness) {
    scene.set(assignment("Interfaces/" + glue, stiffness));
  };
  set("glue_1/Law/Normal Stiffness", factor1 * normal1);
  set("glue_1/Law/Tangential Stiffness", factor1 * normal1 * shear);
  set("glue_2/Law/Normal Stiffness", factor2 * normal2);
  set("glue_2/Law/Tangential Stiffness", factor2 * normal2 * shear);
  return scene.set("Solver/Accuracy=1e-7");
}

// References: a direct solution of the same discrete problem.
constexpr double tolerance = 1e-6;

void expectNear(const SolvedScene& run, const std::string& response, double expected) {
  EXPECT_NEAR(run.value(response), expected, tolerance * std::abs(expected)) << response;
}

TEST(GluedAssembly, MeanStiffness) {
  const SolvedScene run(gluedAssembly(1.0, 1.0).add("Responses", forceResponse("normal_1", "glue_1", {1.0, 0.0}) +
                                                                     forceResponse("normal_2", "glue_2", {1.0, 0.0}) +
                                                                     forceResponse("shear_2", "glue_2", {0.0, 1.0})));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  expectNear(run, "u_x", -2.09265936);
  expectNear(run, "u_y", 0.33549566);
  expectNear(run, "glue_1_normal", 28.76582);
  expectNear(run, "glue_1_tangential", 19.41389);
  expectNear(run, "glue_2_normal", 22.49248);
  expectNear(run, "glue_2_tangential", 15.34842);
  // Equilibrium: the glue carries the load of 400 N/mm in shear and no force along x.
  expectNear(run, "glue_1_shear_force", 400.0);
  expectNear(run, "shear_2", 400.0);
  EXPECT_NEAR(run.value("normal_1"), 0.0, tolerance * 400.0);
  EXPECT_NEAR(run.value("normal_2"), 0.0, tolerance * 400.0);
  double lower = 145.0, upper = 95.0;
  PairValue lowest, uppermost;
  for (const PairValue& pair : run.pairs("glue_2")) {
    if (pair.position[1] <= lower) lower = pair.position[1], lowest = pair;
    if (pair.position[1] >= upper) upper = pair.position[1], uppermost = pair;
  }
  EXPECT_NEAR(lowest.traction[0], 22.49248, 1e-5);
  EXPECT_NEAR(uppermost.traction[0], -6.66560, 1e-5);
  EXPECT_NEAR(std::abs(lowest.traction[1]), 15.34842, 1e-5);
  EXPECT_NEAR(std::abs(uppermost.traction[1]), 10.60775, 1e-5);
}

TEST(GluedAssembly, SoftFirstGlue) {
  const SolvedScene run(gluedAssembly(0.5, 1.7));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  expectNear(run, "u_x", -2.18688472);
  expectNear(run, "u_y", 0.35667656);
}

TEST(GluedAssembly, SoftSecondGlue) {
  const SolvedScene run(gluedAssembly(1.4, 0.6));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  expectNear(run, "u_x", -2.06299579);
  expectNear(run, "u_y", 0.33236453);
}

}  // namespace
}  // namespace harmos::verification
