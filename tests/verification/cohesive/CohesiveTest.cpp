// Cracks along glue against beam theory and linear elastic fracture mechanics.
#include <cmath>

#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/scene/Problem.hpp>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

constexpr double E = 7e4;

bool hasRemark(const SolvedScene& run, const std::string& words) {
  for (const std::string& remark : run.result.remarks) {
    if (remark.find(words) != std::string::npos) return true;
  }
  return false;
}

// Arms bend as cantilevers of the length of the crack a: G = P^2 a^2 / (E I), opening 2 P a^3 / (3 E I). While the
// crack runs P^2 = 2 (G E I)^(3/2) / (3 E I opening), whatever the rotation at its tip adds to a.
TEST(Cohesive, DoubleCantileverBeam) {
  const SolvedScene run(SceneInput::fromFile("cohesive/dcb.xml"));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_LE(run.result.linearStages, 40);  // it takes 18, of 40 load steps each
  EXPECT_TRUE(hasRemark(run, "there may be other solutions"));
  EXPECT_TRUE(hasRemark(run, "followed in parts"));
  constexpr double G = 0.3, EI = E * 8.0 / 12.0;
  const auto load = [&](double opening) { return std::sqrt(2.0 * std::pow(G * EI, 1.5) / (3.0 * EI * opening)); };
  int compared = 0;
  for (int step = 0; step < run.steps(); ++step) {
    const double opening = 4.0 * (step + 1) / run.steps();
    if (opening < 2.5) continue;
    EXPECT_NEAR(run.value("P", step), load(opening), 0.03 * load(opening)) << "opening " << opening;
    ++compared;
  }
  EXPECT_GE(compared, 10);
  // What the crack costs while it runs: G for the length that the force tells.
  const auto length = [&](int step) { return std::sqrt(G * EI) / run.value("P", step); };
  const double cost = G * (length(39) - length(24));
  EXPECT_NEAR(run.value("spent", 39) - run.value("spent", 24), cost, 0.05 * cost);
}

// Four elements in the cohesive zone are too few for a crack that runs smoothly: it snaps from point to point, by
// itself, and every load step is one at which it has come to rest. The force lies on both sides of the closed form.
TEST(Cohesive, CrackThatSnapsComesToRest) {
  const SolvedScene run(
      SceneInput::fromFile("cohesive/dcb.xml").set(assignment("Interfaces/bond/Law/Normal Strength", 20.0)));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_LE(run.result.linearStages, 40);  // it takes 10, of 40 load steps each
  EXPECT_TRUE(hasRemark(run, "a joint snaps in load steps"));
  constexpr double G = 0.3, EI = E * 8.0 / 12.0;
  double spent = 0.0;
  for (int step = 0; step < run.steps(); ++step) {
    const double opening = 4.0 * (step + 1) / run.steps();
    EXPECT_GE(run.value("spent", step), spent) << step;
    spent = run.value("spent", step);
    if (opening < 2.5) continue;
    const double load = std::sqrt(2.0 * std::pow(G * EI, 1.5) / (3.0 * EI * opening));
    EXPECT_NEAR(run.value("P", step), load, 0.06 * load) << "opening " << opening;
  }
}

// Short load steps end where the crack stands between two points, and long ones do not.
TEST(Cohesive, DoubleCantileverBeamInTwiceAsManyLoadSteps) {
  const SolvedScene run(SceneInput::fromFile("cohesive/dcb.xml").set("Steps/pull/Increments=80"));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_LE(run.result.linearStages, 40);     // it takes 8, of 80 load steps each
  EXPECT_NEAR(run.value("P"), 2.429, 0.001);  // as with 40
}

// A mean shear crack between two beams in bending: C = (2 L^3 + 3 a^3) / (96 E I), L half of the span, I of one arm;
// G = 9 a^2 P^2 / (16 E h^3). Cracks longer than 0.7 L grow in a stable way.
TEST(Cohesive, EndNotchedFlexure) {
  const SolvedScene run(SceneInput::fromFile("cohesive/enf.xml"));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  constexpr double G = 0.8, h = 3.0, L = 70.0, EI = E * h * h * h / 12.0;
  // The crack has run: P and a from G and the compliance, one number by halves.
  const auto load = [&](double deflection) {
    double low = 0.75 * L, high = L;
    for (int i = 0; i < 60; ++i) {
      const double a = 0.5 * (low + high), P = 4.0 / (3.0 * a) * std::sqrt(G * E * h * h * h);
      (P * (2.0 * L * L * L + 3.0 * a * a * a) / (96.0 * EI) < deflection ? low : high) = a;
    }
    return 4.0 / (3.0 * low) * std::sqrt(G * E * h * h * h);
  };
  EXPECT_LE(run.result.linearStages, 40);  // 110 when certificates went on below the round-off of images
  EXPECT_NEAR(run.value("P"), load(2.4), 0.02 * load(2.4));
  // Intact: the compliance with the crack as it was; the arms also shear.
  const double first = 0.1 * 2.4, elastic = 96.0 * EI / (2.0 * L * L * L + 3.0 * 52.0 * 52.0 * 52.0);
  EXPECT_NEAR(run.value("P", 0), elastic * first, 0.05 * elastic * first);
}

// Bodies on springs that are far stiffer than their arms lose nine digits in the linear stage.
TEST(Cohesive, StiffSearchDirectionsComeToTheRoundOffOfImages) {
  const SolvedScene run(
      SceneInput::fromFile("cohesive/enf.xml").set(assignment("Solver/Search Direction/Scale", 10.0)));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_LE(run.result.linearStages, 40);        // it takes 22; 106 when residuals had to fall below that
  EXPECT_NEAR(run.value("P"), 27.6464, 0.0277);  // as with the usual one
}

// One number for the force below the strength: 10 u / (20 / E + 1 / K), whatever the search direction.
TEST(Cohesive, BrittleGlueHoldsBelowItsStrength) {
  for (const double scale : {0.1, 1.0, 10.0}) {
    const SolvedScene run(
        SceneInput::fromFile("cohesive/snap.xml").set(assignment("Solver/Search Direction/Scale", scale)));
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    EXPECT_NEAR(run.value("F"), 10.0 * 0.03 / (20.0 / 1e4 + 1.0 / 1e4), 0.02) << scale;
    EXPECT_EQ(run.value("spent"), 0.0);
    EXPECT_TRUE(hasRemark(run, "there may be other solutions"));
  }
}

// Pulled beyond it, the bars spring back by more than the glue can give: it breaks at once, and spends its energy.
TEST(Cohesive, BrittleGlueSnaps) {
  const SolvedScene run(SceneInput::fromFile("cohesive/snap.xml").set(assignment("Values/u", 0.05)));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_NEAR(run.value("F"), 0.0, 1e-6);
  EXPECT_NEAR(run.value("spent"), 0.03 * 10.0, 1e-9);
}

// Pulled by a force beyond its strength: no equilibrium is found, and none is claimed.
TEST(Cohesive, ForcesBeyondTheStrengthAreRefused) {
  const SolvedScene run(
      SceneInput::fromFile("cohesive/snap.xml")
          .remove("Boundaries/drive")
          .add("Boundaries",
               xmlList("drive", xmlText("Side Set", "b_xmax") +
                                    xmlList("Law", xmlText("Type", "Prescribed Traction") + xmlNumber("X", 30.0)))));
  EXPECT_FALSE(run.isCertified());
  EXPECT_EQ(run.result.solvedSteps, 0);
}

TEST(Cohesive, WarnsOfMeshesTooCoarseForTheZone) {
  const auto warnings = [](const char* path) {
    base::Timers timers;
    return scene::makeProblem(SceneInput::fromFile(path).scene(), *Tpetra::getDefaultComm(), timers).warnings;
  };
  const std::vector<std::string> coarse = warnings("cohesive/snap.xml");
  ASSERT_EQ(coarse.size(), 1U);
  EXPECT_NE(coarse[0].find("lie up to 2.5 apart, but its cohesive zone, E G / strength^2, is only 0.75 long"),
            std::string::npos)
      << coarse[0];
  EXPECT_TRUE(warnings("cohesive/dcb.xml").empty());
}

}  // namespace
}  // namespace harmos::verification
