// Extreme numbers of the solver and the loads: search directions, units, gaps, small loads under large ones.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>

#include "Honest.hpp"

namespace harmos::verification {
namespace {

/// Solves with an extreme search direction; what is certified must be right. An operator that such a k makes singular
/// may be refused.
void expectHonestScale(const SceneInput& scene, double scale, const std::vector<std::string>& algorithms) {
  const SceneInput accurate = SceneInput(scene).set("Solver/Accuracy=1e-6");
  const SolvedRun truth(accurate), truthOfAllRows(accurate, false);
  for (const std::string& algorithm : algorithms) {
    SCOPED_TRACE(algorithm);
    SceneInput extreme = scene;
    extreme.set("Solver/Algorithm=" + algorithm).set("Solver/Maximum Iterations=500").set("Solver/Accuracy=1e-3");
    extreme.set(assignment("Solver/Search Direction/Scale", scale));
    try {
      const SolvedRun run(extreme);
      if (run.isCertified()) {
        expectRight(run, algorithm == "Default" ? truth : truthOfAllRows, 1e-3);
      } else {
        EXPECT_EQ(run.result().outcome, latin::Outcome::iterationLimit) << run.result().reason;
      }
    } catch (const base::Error& error) {
      EXPECT_NE(std::string(error.what()).find("singular"), std::string::npos) << error.what();
    }
  }
}

class SearchDirectionScale : public testing::TestWithParam<double> {};

TEST_P(SearchDirectionScale, OfPressedBlocks) {
  expectHonestScale(pressedBlocks(), GetParam(), {"Default", "Relaxed", "Plain"});
}

TEST_P(SearchDirectionScale, OfTheJointLong) {
  expectHonestScale(boltedJoint(), GetParam(), {"Default"});
}

TEST_P(SearchDirectionScale, OfVerificationScenes) {
  for (const char* scene : {"../../xml/gap", "bolt_diagram/bolt", "contact_patch/plane", "contact_patch/space",
                            "jenkins/jenkins", "perfect/beam", "volkersen/volkersen", "wedge/wedge"}) {
    SCOPED_TRACE(scene);
    expectHonestScale(SceneInput::fromFile(std::string("../verification/") + scene + ".xml"), GetParam(),
                      {"Default", "Relaxed", "Plain"});
  }
}

INSTANTIATE_TEST_SUITE_P(Scales, SearchDirectionScale, testing::Values(1e-6, 1e-3, 1e3, 1e6),
                         [](const auto& test) { return "Scale" + std::to_string(test.index); });

struct Units {
  const char* name;
  double length;  // of the unit, in mm; forces stay N
};

/// Pressed blocks in other units of length.
SceneInput pressedBlocksIn(const Units& units) {
  const double stress = units.length * units.length;
  SceneInput scene = pressedBlocks();
  const auto corner = [&](const std::string& path, const std::array<double, 3>& x) {
    std::string text;
    for (const double one : x) text += (text.empty() ? "" : ", ") + base::toText(one / units.length);
    scene.set("Mesh/Boxes/" + path + " Corner={" + text + "}");
  };
  corner("lower/Upper", {24, 16, 8});
  corner("upper/Lower", {0, 0, 8});
  corner("upper/Upper", {24, 16, 16});
  for (const std::string part : {"lower", "upper"}) {
    scene.set(assignment("Materials/" + part + "/Young's Modulus", 210000.0 * stress));
  }
  return scene.set(assignment("Values/pressure", 20.0 * stress)).set(assignment("Values/pull", 4.0 * stress));
}

class OtherUnits : public testing::TestWithParam<Units> {};

// The same digits come out after the same iterations.
TEST_P(OtherUnits, ChangeNothing) {
  const double length = 1.0 / GetParam().length;
  const double stress = 1.0 / (length * length);
  const SolvedRun run(pressedBlocksIn(GetParam()).set("Solver/Accuracy=1e-5"));
  const SolvedRun expected(pressedBlocks().set("Solver/Accuracy=1e-5"));
  ASSERT_TRUE(run.isCertified()) << run.result().reason;
  // The last digits differ, and a certificate may come a stage earlier or later.
  EXPECT_NEAR(run.result().linearStages, expected.result().linearStages, 4);
  for (const auto& [name, unit] : {std::pair<std::string, double>{"friction", 1.0},
                                   {"normal", 1.0},
                                   {"u_top", length},
                                   {"settlement", length},
                                   {"pressure", stress}}) {
    double size = 0.0;
    for (double value : expected.values(name)) size = std::max(size, std::abs(value));
    for (int t = 0; t < run.steps(); ++t)
      EXPECT_NEAR(run.value(name, t) / unit, expected.value(name, t), 2e-5 * size) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, OtherUnits,
                         testing::Values(Units{"Metres", 1e3}, Units{"Micrometres", 1e-3}, Units{"Inches", 25.4},
                                         Units{"Kilometres", 1e6}),
                         [](const auto& test) { return test.param.name; });

// In SI units springs as these have 1e13 Pa/m, and are no rigid ground. Quadratic faces make the difference.
TEST_P(OtherUnits, LeaveSpringsWhatTheyAre) {
  const double length = GetParam().length, stress = length * length;
  SceneInput scene = SceneInput::fromFile("block_on_springs.xml");
  const SolvedRun expected(scene);
  const std::string corner = base::toText(10.0 / length);
  scene.set("Mesh/Boxes/block/Upper Corner={" + corner + ", " + corner + ", " + corner + "}")
      .set(assignment("Materials/steel/Young's Modulus", 2e5 * stress))
      .set(assignment("Boundaries/springs/Law/Normal Stiffness", 1e4 * stress * length))
      .set(assignment("Boundaries/springs/Law/Tangential Stiffness", 1e4 * stress * length))
      .set(assignment("Boundaries/pull/Law/X", 10.0 * stress));
  const SolvedRun run(scene);
  ASSERT_TRUE(run.isCertified() && expected.isCertified()) << run.result().reason;
  EXPECT_NEAR(run.value("bottom") * length, 1e-3, 1e-8);
  EXPECT_NEAR(run.value("top") * length, expected.value("top"), 1e-5 * expected.value("top"));
}

/// Pressed blocks of which the upper one is driven instead, by -z times a history.
SceneInput drivenBlocks(double z, const std::string& history) {
  SceneInput scene = pressedBlocks();
  scene.remove("Boundaries/top").remove("Boundaries/pull");
  scene.add("Boundaries", xmlList("drive", xmlText("Side Set", "upper_zmax") +
                                               xmlList("Law", xmlText("Type", "Prescribed Displacement") +
                                                                  xmlNumber("X", 0.0) + xmlNumber("Y", 0.0) +
                                                                  xmlNumber("Z", -z) + xmlText("Z History", history))));
  return scene;
}

// Forces are differences of alpha and k w, so that a way of 5 m leaves this much of them.
constexpr double roundOffForce = 1e-4;

// Blocks 5 m apart that are driven together through a gap 600 times their height, and blocks that never meet.
TEST(Gap, ThatIsHugeIsCrossedOrNot) {
  SceneInput scene = drivenBlocks(5000.02, "pull");
  scene.add("Interfaces/contact/Law", xmlNumber("Gap", 5000.0));
  const auto run = solveSurely(scene);
  for (const int t : {0, 1, 2}) EXPECT_NEAR(run->value("normal", t), 0.0, roundOffForce);
  const auto met = solveSurely(drivenBlocks(0.02, "pull"));
  EXPECT_NEAR(run->value("normal", 3), met->value("normal", 3), 2e-3 * met->value("normal", 3));

  SceneInput apart = drivenBlocks(4000.0, "pull");
  apart.add("Interfaces/contact/Law", xmlNumber("Gap", 5000.0));
  const auto nothing = solveSurely(apart);
  for (int t = 0; t < nothing->steps(); ++t) {
    EXPECT_NEAR(nothing->value("normal", t), 0.0, roundOffForce);
    EXPECT_NEAR(nothing->value("settlement", t), 4000.0 * t / 3.0, 1e-3 * 4000.0);
  }
}

// A body that only a weight holds down falls through its gap first, which is no lack of equilibrium.
TEST(Gap, IsCrossedByABodyThatFalls) {
  SceneInput scene = pressedBlocks();
  scene.add("Interfaces/contact/Law", xmlNumber("Gap", 1.0));
  const auto run = solveSurely(scene);
  EXPECT_NEAR(run->value("settlement", 0), 1.0, 0.01);
  EXPECT_NEAR(run->value("normal", 3), 7680.0, 8.0);
}

// Clearances that the load would have to press together a million times over, and ones six times as large as the block;
// 384 mm2 are pressed.
TEST(Gap, IsCrossedUnderAnyLoad) {
  for (const double gap : {1e-3, 0.1, 3.0, 100.0}) {
    for (const double pressure : {1e-3, 0.1, 500.0}) {
      SCOPED_TRACE(std::to_string(gap) + " mm, " + std::to_string(pressure) + " MPa");
      SceneInput scene = pressedBlocks();
      scene.set(assignment("Values/pressure", pressure)).set(assignment("Values/pull", 0.2 * pressure));
      scene.add("Interfaces/contact/Law", xmlNumber("Gap", gap));
      const auto run = solveSurely(scene);
      EXPECT_NEAR(run->value("normal", 3), 384.0 * pressure, 2e-3 * 384.0 * pressure);
    }
  }
}

// The upper block falls upon the lower one, and both upon the ground.
TEST(Gap, IsClosedByAStackOfLooseBlocks) {
  const auto run = solveSurely(SceneInput::fromFile("loose_blocks.xml"));
  for (const char* contact : {"upper contact", "lower contact"}) {
    EXPECT_NEAR(run->value(contact), 10.0, 2e-2) << contact;
  }
}

// Two sides of 10 by 1 are pulled by 1 down, 0.5 and 0.25 up; the springs give 0.001 * 10 * 1.
TEST(Restart, FollowsABlockThatIsLiftedOnSoftSprings) {
  const auto run = solveSurely(SceneInput::fromFile("lifted_block.xml"));
  EXPECT_NEAR(run->value("contact", 0), 20.0, 1e-3 * 20.0);
  for (const int t : {1, 2}) EXPECT_NEAR(run->value("contact", t), 0.0, 1e-3 * 20.0);
  EXPECT_NEAR(run->value("height", 1), 1000.0, 1.0);
  EXPECT_NEAR(run->value("height", 2), 500.0, 1.0);
  // Without a softer search direction 1000 are not enough.
  EXPECT_LE(run->result().linearStages, 220);
}

// Pressed first, then lifted: a body that is free of stress hangs on its drive, with every contact open.
TEST(Opening, OfAllContacts) {
  SceneInput scene = drivenBlocks(0.02, "to and fro");
  scene.add("Histories", xmlList("to and fro", xmlText("Type", "Table") + xmlNumbers("Times", {1, 2}) +
                                                   xmlNumbers("Values", {1, -2})));
  const auto run = solveSurely(scene);
  EXPECT_GT(run->value("normal", 0), 1000.0);
  EXPECT_NEAR(run->value("settlement", 0), 0.02, 1e-3 * 0.02);
  for (const int t : {2, 3}) EXPECT_NEAR(run->value("normal", t), 0.0, 1e-3 * run->value("normal", 0));
  // Open in all load steps: the field of forces is nothing but round-off.
  const auto never = solveSurely(drivenBlocks(-0.02, "pull"));
  for (int t = 0; t < never->steps(); ++t) {
    EXPECT_NEAR(never->value("normal", t), 0.0, roundOffForce);
    EXPECT_NEAR(never->value("pressure", t), 0.0, roundOffForce);
  }
}

TEST(ZeroLoad, GivesZero) {
  SceneInput blocks = pressedBlocks(), joint = boltedJoint();
  blocks.set("Values/pressure=0").set("Values/pull=0");
  joint.set("Values/preload_1=0").set("Values/preload_2=0").set("Values/traction=0");
  for (const SceneInput& scene : {blocks, joint}) {
    const auto run = solveSurely(scene);
    for (const auto& response : run->result().responses) {
      for (const double value : response.values) EXPECT_EQ(value, 0.0) << response.name;
    }
  }
}

// Coulomb's law without friction is frictionless contact; it has a history, so that the way there may be another one.
TEST(NoFriction, IsFrictionless) {
  SceneInput coulomb = pressedBlocks();
  coulomb.remove("Boundaries/pull").set("Values/pull=0").set("Values/mu=0").set("Solver/Accuracy=1e-6");
  // Something has to keep the upper block from floating.
  coulomb.add("Boundaries", xmlList("spring", xmlText("Side Set", "upper_xmax") +
                                                  xmlList("Law", xmlText("Type", "Elastic Foundation") +
                                                                     xmlNumber("Normal Stiffness", 100.0) +
                                                                     xmlNumber("Tangential Stiffness", 50.0))));
  coulomb.add("Boundaries",
              xmlList("push", xmlText("Side Set", "upper_xmin") +
                                  xmlList("Law", xmlText("Type", "Prescribed Traction") + xmlNumber("X", -3.0) +
                                                     xmlText("X History", "pull"))));
  SceneInput contact = coulomb;
  contact.set("Interfaces/contact/Law/Type=Unilateral Contact").remove("Interfaces/contact/Law/Friction Coefficient");
  const SolvedRun a(coulomb), b(contact);
  EXPECT_TRUE(a.isCertified()) << a.result().reason;
  EXPECT_TRUE(b.isCertified()) << b.result().reason;
  for (const SolvedRun::Error& error : a.errorsOf(b)) EXPECT_LE(error.relative, 2e-6) << error.quantity;
  double size = 0.0;
  for (const double value : a.values("normal")) size = std::max(size, std::abs(value));
  for (const double value : a.values("friction")) EXPECT_NEAR(value, 0.0, 1e-6 * size);
}

// The load is 1e-4 of the preload and adds 1e-3 to the displacement: at an accuracy of 1e-6 its own part is right.
void expectSmallLoadRight(const SceneInput& scene, const std::string& load, double value, const std::string& response) {
  SceneInput small = scene;
  small.set(assignment("Values/" + load, value));
  solveSurely(small, 1e-3);
  const auto run = solveSurely(small, 1e-6);
  SceneInput twice = scene;
  const auto doubled = solveSurely(twice.set(assignment("Values/" + load, 2.0 * value)), 1e-6);
  const double increment = run->value(response) - run->value(response, 0);
  EXPECT_NEAR(doubled->value(response) - doubled->value(response, 0), 2.0 * increment, 0.05 * std::abs(increment));
}

TEST(SmallLoad, UnderALargePressure) {
  expectSmallLoadRight(pressedBlocks(), "pull", 2e-3, "u_top");
}

TEST(SmallLoad, UnderALargePreloadLong) {
  expectSmallLoadRight(boltedJoint(), "traction", 3.5e-4, "u_load");
}

}  // namespace
}  // namespace harmos::verification
