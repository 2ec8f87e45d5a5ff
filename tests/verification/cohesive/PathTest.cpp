// Paths on which loads are found (Path Following), against closed forms: joints that snap, cracks that run.
#include <cmath>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

/// Two bars of length 10 and section 10, of Young's modulus E, and a bilinear glue between them.
struct Bars {
  double E = 1e4, K = 1e4, strength = 20.0, G = 0.03;

  double onset() const { return strength / K; }
  double end() const { return 2.0 * G / strength; }
  /// Stress at an opening that has never been larger.
  double stress(double opening) const {
    if (opening <= onset()) return K * opening;
    return opening < end() ? strength * (end() - opening) / (end() - onset()) : 0.0;
  }
  /// Displacement of the loaded end.
  double displacement(double opening) const { return opening + 20.0 / E * stress(opening); }

  /// The glue is opened to 1.17 times the opening at which it breaks.
  SceneInput scene(int steps) const {
    SceneInput input = SceneInput::fromFile("cohesive/snap.xml");
    input.set(assignment("Materials/metal/Young's Modulus", E))
        .set(assignment("Interfaces/glue/Law/Stiffness", K))
        .set(assignment("Interfaces/glue/Law/Normal Strength", strength))
        .set(assignment("Interfaces/glue/Law/Shear Strength", strength))
        .set(assignment("Interfaces/glue/Law/Mode I Fracture Energy", G))
        .set(assignment("Interfaces/glue/Law/Mode II Fracture Energy", 2.0 * G))
        .set(assignment("Values/u", 1.0))
        .set("Steps/pull/Increments=" + std::to_string(steps))
        .remove("Boundaries/drive/Law/X History");
    return input.add("Path Following", xmlText("Interface", "glue") + xmlNumber("Opening", opening(1, 1)) +
                                           xmlText("Opening History", "ramp") +
                                           "<Parameter name=\"Loads\" type=\"Array(string)\" value=\"{drive}\"/>");
  }
  double opening(int step, int steps) const { return 1.17 * end() * step / steps; }
};

std::string messageOf(const SceneInput& input) {
  try {
    const SolvedScene run(input);
    return run.result.reason;
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    return error.what();
  }
}

// The bars spring back by more than the glue gives: u falls from 0.042 at the strength to 0.003 where it is broken. The
// load factor is the displacement of the end, because 1 is prescribed.
TEST(RanksPath, BrittleBarIsFollowedBack) {
  const Bars bars;
  const SolvedScene run(bars.scene(12));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  double highest = 0.0;
  for (int step = 0; step < run.steps(); ++step) {
    const double opening = bars.opening(step + 1, run.steps());
    EXPECT_NEAR(run.value("load_factor", step), bars.displacement(opening), 2e-4 * 0.042) << step;
    EXPECT_NEAR(run.value("F", step), 10.0 * bars.stress(opening), 2e-4 * 200.0) << step;
    highest = std::max(highest, run.value("load_factor", step));
  }
  EXPECT_GT(highest, 3.0 * run.value("load_factor"));
  EXPECT_NEAR(run.value("spent"), 0.03 * 10.0, 1e-9);
}

// A traction as load has to fall to 0, and what is prescribed beside it stays: the glue bears both.
TEST(RanksPath, TractionsAreScaledAndOtherLoadsStay) {
  const Bars bars;
  SceneInput scene = bars.scene(12);
  scene.add("Boundaries/drive", xmlList("Law", xmlText("Type", "Prescribed Traction") + xmlNumber("X", 2.0)));
  scene.add("Parts/b", xmlList("Body Force", xmlNumber("X", 0.3)));
  scene.add("Responses", xmlList("pull", xmlText("Type", "Interface Force") + xmlText("Interface", "drive") +
                                             xmlNumbers("Direction", {1.0, 0.0})));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  for (int step = 0; step < run.steps(); ++step) {
    const double stress = bars.stress(bars.opening(step + 1, run.steps()));
    EXPECT_NEAR(run.value("load_factor", step), (stress - 3.0) / 2.0, 2e-4 * 10.0) << step;
    EXPECT_NEAR(run.value("pull", step), 10.0 * (stress - 3.0), 2e-4 * 200.0) << step;
  }
}

// Back to the origin with the damage that has been done, and up again, under a load that stays.
TEST(RanksPath, UnloadsAndLoadsAgainUnderAPreload) {
  const Bars bars;
  const std::vector<double> openings{0.0005, 0.001, 0.0022, 0.0005, 0.0022, 0.0026, 0.0001, 0.0029, 0.0035};
  const auto steps = static_cast<int>(openings.size());
  std::vector<double> times{0.0}, values{0.0};
  for (int step = 0; step < steps; ++step) {
    times.push_back((step + 1.0) / steps);
    values.push_back(openings[step] / bars.opening(1, 1));
  }
  SceneInput scene = bars.scene(steps);
  scene.add("Boundaries/drive", xmlList("Law", xmlText("Type", "Prescribed Traction") + xmlNumber("X", 2.0)))
      .add("Parts/b", xmlList("Body Force", xmlNumber("X", 0.3)))
      .add("Histories",
           xmlList("zigzag", xmlText("Type", "Table") + xmlNumbers("Times", times) + xmlNumbers("Values", values)))
      .set("Path Following/Opening History=zigzag");
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  double widest = 0.0;
  for (int step = 0; step < steps; ++step) {
    widest = std::max(widest, openings[step]);
    const double stress = bars.stress(widest) * openings[step] / widest;
    EXPECT_NEAR(run.value("F", step), 10.0 * stress, 2e-4 * 200.0) << step;
    EXPECT_NEAR(run.value("load_factor", step), (stress - 3.0) / 2.0, 2e-4 * 10.0) << step;
  }
}

// Sides that touch do not come closer, whatever the load.
TEST(Path, OpeningsThatNothingCanHaveAreRefused) {
  SceneInput scene = Bars().scene(4);
  scene
      .add("Histories", xmlList("through", xmlText("Type", "Table") + xmlNumbers("Times", {0.0, 0.5, 1.0}) +
                                               xmlNumbers("Values", {0.0, 0.5, -0.5})))
      .set("Path Following/Opening History=through");
  const SolvedScene run(scene);
  EXPECT_FALSE(run.isCertified());
  EXPECT_GE(run.result.solvedSteps, 3);  // 0 can still be had; the first march may be content with the last one, too
  EXPECT_NE(run.result.reason.find("the laws of \"glue\" soften: control what the loads open most"), std::string::npos)
      << run.result.reason;
}

TEST(Path, RandomBarsFollowTheClosedForm) {
  std::mt19937 random(7);  // its sequence is fixed by the standard, that of the distributions is not
  const auto between = [&](double low, double high) { return low * std::pow(high / low, random() / 4294967296.0); };
  for (int trial = 0; trial < 12; ++trial) {
    Bars bars;
    bars.E = between(1e3, 1e5);
    bars.K = between(1e3, 1e6);
    bars.strength = between(2.0, 50.0);
    bars.G = 0.5 * bars.strength * bars.onset() * (1.0 + between(0.05, 20.0));
    const int steps = 5 + trial;
    const SolvedScene run(bars.scene(steps));
    ASSERT_TRUE(run.isCertified()) << "trial " << trial << ": " << run.result.reason;
    const double size = bars.displacement(bars.onset());
    for (int step = 0; step < steps; ++step) {
      const double expected = bars.displacement(bars.opening(step + 1, steps));
      EXPECT_NEAR(run.value("load_factor", step), expected, 2e-4 * size) << "trial " << trial << ", step " << step;
    }
  }
}

// Dragged to and fro by a traction of unknown size, which a joint without softening bears as well: mu N either way.
TEST(RanksPath, FrictionGivesTheForceOfAGivenSlip) {
  SceneInput scene = SceneInput::fromFile("sliding_block/sliding_block.xml");
  scene.add("Boundaries/push", xmlList("Law", xmlText("Type", "Prescribed Traction") + xmlNumber("X", 1.0)))
      .add("Path Following", xmlText("Interface", "contact") + xmlNumber("Opening", 0.02) +
                                 xmlText("Opening History", "to and fro") + xmlNumbers("Direction", {2.0, 0.0, 0.0}) +
                                 "<Parameter name=\"Loads\" type=\"Array(string)\" value=\"{push}\"/>")
      .remove("Responses/reaction");
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  for (const int step : {2, 6}) {
    EXPECT_NEAR(std::abs(run.value("load_factor", step)) * 16.0 * 10.0, 0.2 * 7680.0, 1e-4 * 1536.0) << step;
    EXPECT_NEAR(std::abs(run.value("friction", step)), 0.2 * 7680.0, 1e-4 * 1536.0) << step;
  }
  EXPECT_LT(run.value("load_factor", 2) * run.value("load_factor", 6), 0.0);
}

TEST(Path, LoadsThatDoNotMoveTheJointAreRefused) {
  SceneInput scene = Bars().scene(4);
  scene.add("Path Following", xmlNumbers("Direction", {0.0, 1.0}));
  EXPECT_NE(messageOf(scene).find("the loads that are to be found do not move what is controlled"), std::string::npos)
      << messageOf(scene);
}

// The beam of dcb.xml, of which the mean opening of the glue is given: force and opening of the ends follow beam theory
// while the crack runs, P^2 = 2 (G E I)^(3/2) / (3 E I opening). With a strength of 20 too few elements lie in the
// cohesive zone, and the crack snaps from point to point: displacements as loads jump there
// (Cohesive.CrackThatSnapsComesToRest).
TEST(Path, CrackIsFollowedWhereItSnaps) {
  constexpr double G = 0.3, EI = 7e4 * 8.0 / 12.0;
  for (const double strength : {8.0, 20.0}) {
    SceneInput scene = SceneInput::fromFile("cohesive/dcb.xml");
    scene.set(assignment("Interfaces/bond/Law/Normal Strength", strength))
        .remove("Boundaries/up/Law/Y History")
        .remove("Boundaries/down/Law/Y History")
        .add("Path Following", xmlText("Interface", "bond") + xmlNumber("Opening", 0.05) +
                                   xmlText("Opening History", "ramp") +
                                   "<Parameter name=\"Loads\" type=\"Array(string)\" value=\"{up, down}\"/>");
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << strength << ": " << run.result.reason;
    EXPECT_LE(run.result.linearStages, 40);  // it takes 16, of 40 load steps each
    double back = 0.0;
    for (int step = 0; step < run.steps(); ++step) {
      if (step > 0) back = std::max(back, run.value("load_factor", step - 1) - run.value("load_factor", step));
      const double opening = 4.0 * run.value("load_factor", step);
      if (opening < 2.5) continue;
      const double load = std::sqrt(2.0 * std::pow(G * EI, 1.5) / (3.0 * EI * opening));
      EXPECT_NEAR(run.value("P", step), load, (strength < 10.0 ? 0.03 : 0.06) * load) << strength << ", " << opening;
    }
    EXPECT_GT(back, strength < 10.0 ? 0.0 : 0.005) << "the ends must close where the crack jumps";
  }
}

/// Mixed-mode bending by a force P in the middle and one of `lift` P at the end: a crack of length a between arms of
/// height h, by beam theory. The arms are opened by m P, m = lift - 1/4, and bent by P:
/// G_I = 12 a^2 m^2 P^2 / (E h^3), G_II = 9 a^2 P^2 / (16 E h^3); opening 2 m P a^3 / (3 E I) (Reeder, Crews 1990).
struct MixedModeBending {
  double lift;

  static constexpr double E = 7e4, h = 3.0, EI = E * h * h * h / 12.0;
  double m() const { return lift - 0.25; }
  double share() const { return 9.0 / 16.0 / (9.0 / 16.0 + 12.0 * m() * m()); }  // of mode II
  /// Benzeggagh, Kenane.
  double energy() const { return 0.3 + 0.5 * share() * share(); }
  /// P a while the crack runs.
  double moment() const { return std::sqrt(energy() * E * h * h * h / (12.0 * m() * m() + 9.0 / 16.0)); }
  double forceAt(double opening) const { return std::sqrt(2.0 * m() * std::pow(moment(), 3) / (3.0 * EI * opening)); }
  /// What a lever that makes these forces of one does at its end, in terms of its own force: goes back for short
  /// cracks.
  double lever(double end, double middle) const { return (lift * end - middle) / (1.0 - lift); }
};

/// The force falls along the closed form from an opening on at which the crack runs; how far the end of the lever goes
/// back before that.
double wayBack(const MixedModeBending& beam, int running, double tolerance) {
  SceneInput scene = SceneInput::fromFile("cohesive/mmb.xml");
  scene.set(assignment("Boundaries/lift/Law/Y", beam.lift));
  const SolvedScene run(scene);
  EXPECT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_LE(run.result.linearStages, 40);  // of 40 load steps each
  double back = 0.0, highest = 0.0;
  for (int step = 0; step < run.steps(); ++step) {
    const double force = run.value("P", step), end = run.value("end", step);
    const double lever = beam.lever(end, run.value("mid", step));
    if (step < 25) back = std::max(back, highest - lever);
    highest = std::max(highest, lever);
    if (step < running) continue;  // the crack runs from there on
    EXPECT_NEAR(force, beam.forceAt(end), tolerance * force) << beam.share() << ", " << step;
  }
  return back;
}

// Forces alone would break the glue at once, and the end of the lever goes back while the crack runs. Half of the
// energy is that of shear.
TEST(Path, MixedModeBending) {
  EXPECT_GT(wayBack({0.4665}, 16, 0.035), 0.01);
}

TEST(LongPath, MixedModeBendingOfOtherMixes) {
  wayBack({0.683}, 16, 0.035);    // 20 % shear
  wayBack({0.54505}, 16, 0.035);  // 35 %
  wayBack({0.35825}, 16, 0.035);  // 80 %
}

}  // namespace
}  // namespace harmos::verification
