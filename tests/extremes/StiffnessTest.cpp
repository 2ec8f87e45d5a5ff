// Parts that are much softer or stiffer than their neighbours, thin ones, and nearly incompressible ones.
#include <gtest/gtest.h>

#include "Honest.hpp"

namespace harmos::verification {
namespace {

/// Adds a material of this modulus and gives it to the parts.
SceneInput& remake(SceneInput& scene, const std::vector<std::string>& parts, double modulus) {
  scene.add("Materials", xmlList("other", xmlText("Type", "Isotropic") + xmlNumber("Young's Modulus", modulus) +
                                              xmlNumber("Poisson's Ratio", 0.3)));
  for (const std::string& part : parts) scene.set("Parts/" + part + "/Material=other");
  return scene;
}

constexpr double jointModulus = 20000.0;
const std::vector<std::string> bolts = {"bolt_1", "head_1", "bolt_2", "head_2"};

class StiffnessRatio : public testing::TestWithParam<double> {};

TEST_P(StiffnessRatio, OfTwoBlocks) {
  for (const std::string part : {"lower", "upper"}) {
    SCOPED_TRACE(part);
    SceneInput scene = pressedBlocks();
    solveSurely(remake(scene, {part}, 210000.0 * GetParam()));
  }
}

// What is soft presses less and holds less, so that the load is made smaller with it.
TEST_P(StiffnessRatio, OfBoltsInAJointLong) {
  SceneInput scene = boltedJoint();
  remake(scene, bolts, jointModulus * GetParam());
  if (GetParam() < 1.0) scene.set(assignment("Values/traction", 3.5 * GetParam()));
  solveHonestly(scene);
}

TEST_P(StiffnessRatio, OfOnePlateInAJointLong) {
  SceneInput scene = boltedJoint();
  remake(scene, {"centre"}, jointModulus * GetParam());
  if (GetParam() < 1.0) scene.set(assignment("Values/traction", 3.5 * GetParam()));
  solveHonestly(scene);
}

INSTANTIATE_TEST_SUITE_P(Modulus, StiffnessRatio, testing::Values(1e-6, 1e-3, 1e3, 1e6), [](const auto& test) {
  return std::string(test.param < 1.0 ? "Softer" : "Stiffer") +
         (test.param < 1e-3 || test.param > 1e3 ? "Million" : "Thousand");
});

// Bolts of rubber press the plates a thousand times less, which cannot carry the pull.
TEST(StiffnessRatio, BoltsOfRubberDoNotHoldThePull) {
  SceneInput scene = boltedJoint();
  expectNoEquilibrium(remake(scene, bolts, 1e-3 * jointModulus), {"centre", "bolt_1", "bolt_2", "head_1", "head_2"});
}

// The bending of both together is all but absent from the residual. What a plate does alone under half of the pressure
// needs no contact.
TEST(ThinPlates, InContactShareThePressure) {
  const SceneInput both = SceneInput::fromFile("plates_in_contact.xml");
  SceneInput one = both;
  for (const char* list : {"Interfaces", "Parts/lower", "Mesh/Boxes/lower", "Boundaries/clamp of lower"})
    one.remove(list);
  const SolvedRun alone(one.set("Boundaries/top/Law/Pressure=0.0005").set("Solver/Accuracy=1e-6"));
  ASSERT_TRUE(alone.isCertified()) << alone.result().reason;
  const SolvedRun run(both);
  ASSERT_TRUE(run.isCertified()) << run.result().reason;
  // Besides the accuracy: the upper plate is pressed together by 1e-6 of the deflection.
  EXPECT_NEAR(run.value("deflection"), alone.value("deflection"), 2e-3 * alone.value("deflection"));
}

class ThinPlates : public testing::TestWithParam<const char*> {};

TEST_P(ThinPlates, BendOneElementThick) {
  SceneInput scene = SceneInput::fromFile("thin_plates.xml");
  scene.set(std::string("Values/mu=") + GetParam());
  const auto run = solveHonestly(scene);
  if (!run->isCertified()) return;
  // Both clamps together carry 0.05 MPa on 40 x 10.
  for (int t = 0; t < run->steps(); ++t) {
    const double load = 20.0 * (t + 1) / run->steps();
    EXPECT_NEAR(run->value("reaction lower", t) + run->value("reaction upper", t), load, 2e-3 * 20.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Friction, ThinPlates, testing::Values("0", "0.2", "2"),
                         [](const auto& test) { return "Case" + std::to_string(test.index); });

// Residuals hardly tell where the upper block is beside its way down.
TEST(SoftFoundation, HoldsABlockOnASmoothContact) {
  for (const double accuracy : {1e-3, 1e-5}) {
    SCOPED_TRACE(accuracy);
    solveSurely(SceneInput::fromFile("contact_on_foundation.xml"), accuracy);
  }
}

// What softer springs make of the way of the block is less than round-off in the end; then it is not said. With none at
// all the block goes aside by 0.34.
TEST(SoftFoundation, IsRefusedWhereItsSpringsAreLost) {
  SceneInput scene = SceneInput::fromFile("contact_on_foundation.xml");
  scene.set("Solver/Accuracy=1e-3");
  for (const double stiffness : {1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13}) {
    SCOPED_TRACE(stiffness);
    for (const std::string which : {"Normal", "Tangential"}) {
      scene.set(assignment("Boundaries/beside the upper one/Law/" + which + " Stiffness", stiffness));
    }
    const SolvedRun run(scene);
    if (run.isCertified()) {
      EXPECT_NEAR(run.value("aside"), -0.34, 0.02);
    } else {
      EXPECT_NE(run.result().reason.find("double precision"), std::string::npos) << run.result().reason;
    }
  }
}

// The volume hardly changes; without B-bar the elements lock, which is hard for any k: it may remain uncertified.
TEST(NearlyIncompressible, BlocksAreSolved) {
  const auto blocks = [](const std::string& formulation, const std::string& ratio) {
    SceneInput scene = pressedBlocks();
    for (const std::string part : {"lower", "upper"}) {
      scene.set("Materials/" + part + "/Poisson's Ratio=" + ratio);
      scene.set("Parts/" + part + "/Formulation=" + formulation);
    }
    return scene;
  };
  for (const std::string ratio : {"0.4999", "0.499999"}) {
    SCOPED_TRACE(ratio);
    solveSurely(blocks("B-Bar", ratio));
    solveHonestly(blocks("Full Integration", ratio));
  }
}

}  // namespace
}  // namespace harmos::verification
