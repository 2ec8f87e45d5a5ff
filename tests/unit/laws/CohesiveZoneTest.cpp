// The graph of the cohesive zone by hand, met on lines of any compliance below one over its steepest fall.
#include <cmath>

#include <gtest/gtest.h>

#include "LawSamples.hpp"

namespace harmos::laws {
namespace {

// sigma_n = 20 at delta = 0.002, 0 at 0.012; sigma_t = 40 at 0.004, 0 at 0.024.
constexpr double K = 1e4, strength = 20.0, shearStrength = 40.0, energy = 0.12, shearEnergy = 0.48;
constexpr double fall = 20.0 / 0.01;  // the same in both modes
constexpr double roundOff = 1e-12;

std::unique_ptr<InterfaceLaw> make(const std::string& softening = "Bilinear",
                                   const std::map<std::string, double>& other = {}) {
  const LawRegistry laws = builtInLaws();
  input::Parameters p("law");
  p.set("Type", "Cohesive Zone");
  p.set("Stiffness", K);
  p.set("Normal Strength", strength);
  p.set("Shear Strength", shearStrength);
  p.set("Mode I Fracture Energy", energy);
  p.set("Mode II Fracture Energy", shearEnergy);
  p.set("Mixed Mode Exponent", 2.0);
  p.set("Softening", softening);
  for (const auto& [name, value] : other) p.set(name, value);
  return laws.create(p);
}

/// Leads a pair to a jump, given to all digits by the traction that belongs to it.
LocalState solveAt(Node& node, const base::Vector3& jump, const base::Vector3& traction, double compliance) {
  return node.solve({jump + compliance * traction, compliance});
}

/// Leads a pair to a jump of the normal on lines so stiff that it is given.
LocalState lead(Node& node, const base::Vector3& jump) {
  constexpr double stiff = 1e-12;
  const LocalState state = node.solve({jump, stiff});
  node.accept();
  return state;
}

TEST(CohesiveZone, FallsLinearlyToZero) {
  const auto law = make();
  for (const double compliance : {1e-9, 0.1 / fall, 0.9 / fall}) {
    Node node(*law);
    EXPECT_NEAR(solveAt(node, {0.001, 0, 0}, {10.0, 0, 0}, compliance).traction[0], 10.0, roundOff * strength);
    EXPECT_NEAR(solveAt(node, {0.002, 0, 0}, {20.0, 0, 0}, compliance).traction[0], 20.0, roundOff * strength);
    EXPECT_NEAR(solveAt(node, {0.007, 0, 0}, {10.0, 0, 0}, compliance).traction[0], 10.0, 1e2 * roundOff * strength);
    EXPECT_EQ(node.solve({{0.007, 0, 0}, compliance}).status, Status::bonded);
    const LocalState failed = solveAt(node, {0.013, 0, 0}, {}, compliance);
    EXPECT_EQ(failed.traction, base::Vector3{});
    EXPECT_EQ(failed.status, Status::broken);
    EXPECT_NEAR(solveAt(node, {0, 0.014, 0}, {0, 20.0, 0}, compliance).traction[1], 20.0, 1e2 * roundOff * strength);
  }
}

TEST(CohesiveZone, FallsExponentially) {
  const auto law = make("Exponential");
  const double tail = energy / strength - 0.001;
  for (const double compliance : {1e-9, 0.1 * tail / strength, 0.9 * tail / strength}) {
    Node node(*law);
    for (const double x : {0.1, 1.0, 5.0, 20.0}) {
      const double t = strength * std::exp(-x);
      EXPECT_NEAR(solveAt(node, {0.002 + x * tail, 0, 0}, {t, 0, 0}, compliance).traction[0], t, 1e-9 * strength);
    }
  }
}

TEST(CohesiveZone, UnloadsToTheOriginAndRemembers) {
  for (const char* softening : {"Bilinear", "Exponential"}) {
    const auto law = make(softening);
    Node node(*law);
    const double t = lead(node, {0.007, 0, 0}).traction[0];
    const double damage = node.oldHistory()[0];
    EXPECT_NEAR(damage, 1.0 - t / (K * 0.007), 1e-9);
    EXPECT_NEAR(lead(node, {0.0035, 0, 0}).traction[0], 0.5 * t, 1e-6 * t);
    EXPECT_EQ(node.oldHistory()[0], damage);
    EXPECT_NEAR(lead(node, {0.007, 0, 0}).traction[0], t, 1e-6 * t);
    // Shear is damaged as well.
    EXPECT_NEAR(lead(node, {0, 0.001, 0}).traction[1], (1.0 - damage) * K * 0.001, 1e-6 * t);
  }
}

TEST(CohesiveZone, PressedSidesDoNotPassThroughEachOther) {
  const auto law = make();
  Node node(*law);
  for (int broken = 0; broken < 2; ++broken) {
    const LocalLine line{{-0.5, 0.0, 0.0}, 1e-4};
    const LocalState state = node.solve(line);
    EXPECT_DOUBLE_EQ(state.traction[0], -5000.0);
    EXPECT_DOUBLE_EQ(line.jump(state.traction)[0], 0.0);
    EXPECT_EQ(state.status, broken == 0 ? Status::bonded : Status::slip);
    lead(node, {1.0, 0, 0});
  }
  // Broken glue has no shear under pressure.
  EXPECT_EQ(node.solve({{-0.5, 0.3, 0.0}, 1e-4}).traction[1], 0.0);
}

TEST(CohesiveZone, MixesModesAsBenzeggaghAndKenane) {
  const auto law = make();
  const double direction = 0.6;  // angle of the jump from the normal
  const double share = std::sin(direction) * std::sin(direction), x = share * share;
  const double onset = std::sqrt(0.002 * 0.002 + (0.004 * 0.004 - 0.002 * 0.002) * x);
  const double failed = 2.0 * (energy + (shearEnergy - energy) * x) / (K * onset);
  const auto at = [&](double opening) {
    Node node(*law);
    return base::norm(lead(node, {opening * std::cos(direction), 0, opening * std::sin(direction)}).traction);
  };
  EXPECT_NEAR(at(onset), K * onset, 1e-6 * strength);
  EXPECT_NEAR(at(0.5 * (onset + failed)), 0.5 * K * onset, 1e-6 * strength);
  EXPECT_GT(at(0.999 * failed), 0.0);
  EXPECT_EQ(at(1.001 * failed), 0.0);
}

// The energy is spent once, in however many steps, with unloading in between, and whatever the steps before.
TEST(CohesiveZone, DissipatesItsFractureEnergy) {
  for (const char* softening : {"Bilinear", "Exponential"}) {
    const auto law = make(softening);
    const double far = softening == std::string("Bilinear") ? 0.013 : 0.25;
    for (const int steps : {1, 7, 50}) {
      for (const base::Vector3& way : {base::Vector3{1, 0, 0}, base::Vector3{0, 2, 0}}) {
        Node node(*law);
        double lost = 0.0;
        PairStep step;
        for (int i = 1; i <= 2 * steps; ++i) {
          const double share = (i % 2 == 0 ? 1.0 : 0.3) * (0.5 * i) / steps;
          const LocalLine line{far * share * way, 1e-12};
          step.traction = node.solve(line).traction;
          step.jump = line.jump(step.traction);
          step.oldHistory = node.oldHistory().data();
          step.history = node.newHistory().data();
          const double now = step.work() - law->keptWork(step);
          EXPECT_GE(now, 0.0);
          lost += now;
          node.accept();
          step.oldJump = step.jump;
        }
        EXPECT_NEAR(lost, way[0] > 0.0 ? energy : shearEnergy, 1e-9 * energy) << softening << ", " << steps;
      }
    }
  }
}

// What the solver relies on: no secant of the graph falls more steeply than it says, and one nearly does.
TEST(CohesiveZone, KnowsItsLowestSlope) {
  for (const char* softening : {"Bilinear", "Exponential"}) {
    const auto law = make(softening, {{"Shear Strength", 25.0}});
    double steepest = 0.0;
    constexpr double step = 1e-5;
    for (const double angle : {0.0, 0.4, 0.8, 1.2, 1.5707963267948966}) {
      double before = 0.0;
      for (double opening = step; opening < 0.05; opening += step) {
        Node node(*law);
        const double t =
            base::norm(node.solve({{opening * std::cos(angle), opening * std::sin(angle), 0}, 0.0}).traction);
        steepest = std::max(steepest, (before - t) / step);
        before = t;
      }
    }
    EXPECT_LE(steepest, -law->lowestSlope() * (1.0 + 1e-6));
    EXPECT_GE(steepest, -law->lowestSlope() * 0.98);
  }
}

// Below that compliance the point is unique: small moves of the line, small moves of the point, whatever the history.
TEST(CohesiveZone, IsContinuousOnLinesStiffEnough) {
  Random random(7);
  for (const char* softening : {"Bilinear", "Exponential"}) {
    const auto law = make(softening);
    const double compliance = -0.5 / law->lowestSlope();
    for (int i = 0; i < 40; ++i) {
      Node node(*law);
      lead(node, 0.005 * randomVector(random));
      const base::Vector3 from = 0.01 * randomVector(random), to = 0.01 * randomVector(random);
      constexpr int moves = 2000;
      const base::Vector3 move = (1.0 / moves) * (to - from);
      LocalLine line{from, compliance};
      base::Vector3 before = node.solve(line).traction;
      for (int m = 0; m < moves; ++m) {
        line.freeJump = line.freeJump + move;
        const base::Vector3 traction = node.solve(line).traction;
        // Changes of the mix of modes at damage d add to the slope.
        EXPECT_LE(compliance * norm(traction - before), 8.0 * norm(move)) << softening << ", " << i << ", " << m;
        before = traction;
      }
    }
  }
}

TEST(CohesiveZone, StoresAndShowsWhatIsLeft) {
  const auto law = make();
  Node node(*law);
  PairStep step;
  step.jump = {0.007, 0.0, 0.0};
  step.traction = lead(node, step.jump).traction;
  step.history = node.oldHistory().data();
  double damage = 0.0;
  law->output(step, &damage);
  EXPECT_NEAR(damage, 6.0 / 7.0, 1e-8);
  EXPECT_NEAR(law->storedEnergy(step), 0.5 * 10.0 * 0.007, 1e-8);
}

}  // namespace
}  // namespace harmos::laws
