// Laws of contact and friction against closed forms, point by point.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/laws/LawFailure.hpp>

#include "LawSamples.hpp"

namespace harmos::laws {
namespace {

constexpr double roundOff = 1e-13;

std::unique_ptr<InterfaceLaw> make(const std::string& type, const std::map<std::string, double>& values,
                                   const std::map<std::string, std::vector<double>>& lists) {
  input::Parameters p("law");
  p.set("Type", type);
  for (const auto& [name, value] : values) p.set(name, value);
  for (const auto& [name, numbers] : lists) p.set(name, numbers);
  return builtInLaws().create(p);
}

/// How many errors the check of a law finds.
int errorsOf(const std::string& type, const std::map<std::string, std::vector<double>>& lists) {
  input::Parameters p("law");
  p.set("Type", type);
  for (const auto& [name, numbers] : lists) p.set(name, numbers);
  input::ErrorList errors;
  builtInLaws().check(p, errors);
  return errors.count();
}

// Pressed by H p + x = 0.5 with p = 3 x and H = 0.5: x = 0.2; sticks with k_t = 4 up to mu p.
TEST(CompliantContact, GivesWay) {
  const auto law = makeLaw("Compliant Contact",
                           {{"Normal Stiffness", 3.0}, {"Friction Coefficient", 0.5}, {"Tangential Stiffness", 4.0}});
  Node node(*law, 0.1);
  const LocalLine line{{-0.6, 0.15, 0.0}, 0.5};
  const LocalState stick = node.solve(line);
  EXPECT_NEAR(stick.traction[0], -0.6, roundOff);
  EXPECT_NEAR(stick.traction[1], 0.2, roundOff);  // 4 (0.15 - 0.5 t)
  EXPECT_EQ(stick.status, Status::stick);
  const LocalLine far{{-0.6, 10.0, 0.0}, 0.5};
  const LocalState slip = node.solve(far);
  EXPECT_NEAR(slip.traction[1], 0.3, roundOff);
  EXPECT_EQ(slip.status, Status::slip);
  node.accept();
  PairStep step;
  step.jump = far.jump(slip.traction);
  step.traction = slip.traction;
  const std::vector<double> start(3, 0.0);
  step.oldHistory = start.data();
  step.history = node.oldHistory().data();
  const double slid = step.jump[1] - 0.3 / 4.0;
  EXPECT_NEAR(step.work() - law->keptWork(step), 0.3 * slid, roundOff);
  EXPECT_NEAR(law->storedEnergy(step), 0.5 * 0.36 / 3.0 + 0.5 * 0.09 / 4.0, roundOff);
  double way = 0.0;
  law->output(step, &way);
  EXPECT_NEAR(way, slid, roundOff);
}

TEST(CompliantContact, BetweenRigidContactAndNothing) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const auto stiff = makeLaw("Compliant Contact", {{"Normal Stiffness", 1e14}, {"Friction Coefficient", 0.4}});
    const auto rigid = makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.4}});
    Node a(*stiff), b(*rigid);
    for (int step = 0; step < 4; ++step) {
      const LocalLine line = randomLine(random);
      const LocalState found = a.solve(line), expected = b.solve(line);
      EXPECT_LE(norm(found.traction - expected.traction), 1e-9 * norm(line.freeJump) / line.compliance);
      EXPECT_EQ(found.status, expected.status);
      a.accept();
      b.accept();
    }
  }
}

// Half-way in the second piece, beyond the last, and before the first.
TEST(TabulatedContact, FollowsItsTable) {
  const auto law = make("Tabulated Contact", {{"Friction Coefficient", 0.2}, {"Gap", 0.0}},
                        {{"Overclosures", {-0.1, 0.0, 0.2}}, {"Pressures", {0.0, 1.0, 5.0}}});
  const double tiny = 1e-12;
  for (const auto& [x, p] : {std::pair{-0.2, 0.0}, std::pair{-0.1, 0.0}, std::pair{-0.05, 0.5}, std::pair{0.0, 1.0},
                             std::pair{0.1, 3.0}, std::pair{0.2, 5.0}, std::pair{0.3, 7.0}}) {
    EXPECT_NEAR(Node(*law).solve({{-x, 0.0, 0.0}, tiny}).traction[0], -p, 1e-9) << x;
    // The same point on a softer line.
    EXPECT_NEAR(Node(*law).solve({{-x - 2.0 * p, 0.0, 0.0}, 2.0}).traction[0], -p, 1e-12) << x;
  }
  EXPECT_EQ(Node(*law).solve({{0.2, 1.0, 0.0}, 1.0}).status, Status::open);
  PairStep step;
  step.traction = {-7.0, 0.0, 0.0};
  EXPECT_NEAR(law->storedEnergy(step), 0.05 + 0.6 + 0.6, roundOff);
}

TEST(TabulatedContact, WantsATable) {
  const auto errors = [](std::vector<double> x, std::vector<double> p) {
    return errorsOf("Tabulated Contact", {{"Overclosures", std::move(x)}, {"Pressures", std::move(p)}});
  };
  EXPECT_EQ(errors({0.0, 1.0}, {0.0, 1.0}), 0);
  EXPECT_EQ(errors({0.0}, {0.0}), 1);
  EXPECT_EQ(errors({0.0, 1.0}, {0.0}), 1);
  EXPECT_EQ(errors({0.0, 1.0}, {0.5, 1.0}), 1);
  EXPECT_EQ(errors({1.0, 0.0, 2.0}, {0.0, 1.0, 2.0}), 1);
  EXPECT_EQ(errors({0.0, 1.0, 2.0}, {0.0, 2.0, 1.0}), 1);
  EXPECT_EQ(errors({0.0, 1.0, 2.0}, {0.0, 2.0, 2.0}), 1);
  EXPECT_EQ(errorsOf("Parallel Iwan", {{"Stiffnesses", {1.0, 2.0}}, {"Slip Limits", {1.0}}}), 1);
}

TEST(TrescaFriction, KnowsNoPressure) {
  const auto law = makeLaw("Tresca Friction", {{"Shear Limit", 0.5}});
  for (const double normal : {-10.0, -0.1, 3.0}) {
    Node node(*law);
    const LocalState slip = node.solve({{normal, 3.0, -4.0}, 2.0});
    EXPECT_NEAR(slip.traction[1], 0.3, roundOff);
    EXPECT_NEAR(slip.traction[2], -0.4, roundOff);
    EXPECT_NEAR(slip.traction[0], std::min(0.0, normal / 2.0), roundOff);
    node.accept();
    // Turns back from where it stopped: 3 - 2 * 0.3.
    const LocalState back = node.solve({{normal, 2.4, -3.2}, 2.0});
    EXPECT_EQ(back.status, Status::stick);
    EXPECT_NEAR(tangentialNorm(back.traction), 0.0, roundOff);
  }
}

TEST(AdhesiveFriction, AttractsUpToItsRange) {
  const auto law = makeLaw("Adhesive Friction",
                           {{"Adhesion", 2.0}, {"Range", 0.5}, {"Cohesion", 0.6}, {"Friction Coefficient", 0.5}});
  EXPECT_EQ(law->lowestSlope(), -4.0);
  const double h = 0.1;
  for (const auto& [opening, traction] :
       {std::pair{0.0, 2.0}, std::pair{0.125, 1.5}, std::pair{0.5, 0.0}, std::pair{1.0, 0.0}}) {
    EXPECT_NEAR(Node(*law).solve({{opening + h * traction, 0.0, 0.0}, h}).traction[0], traction, roundOff) << opening;
  }
  // In contact: under tension half of the adhesion is left, and half of the cohesion; under pressure Coulomb's cone.
  EXPECT_NEAR(Node(*law).solve({{h * 1.0, 9.0, 0.0}, h}).traction[1], 0.3, roundOff);
  EXPECT_NEAR(Node(*law).solve({{0.0, 9.0, 0.0}, h}).traction[1], 0.6, roundOff);
  EXPECT_NEAR(Node(*law).solve({{-h * 4.0, 9.0, 0.0}, h}).traction[1], 0.6 + 0.5 * 4.0, roundOff);
}

TEST(OrthotropicFriction, RefusesAnAxisAlongTheNormal) {
  const auto law =
      make("Orthotropic Friction", {{"Friction Coefficient 1", 0.2}, {"Friction Coefficient 2", 0.5}, {"Gap", 0.0}},
           {{"Axis", {2.0, 1e-9, 0.0}}});  // n of the sample's frame, but for round-off
  try {
    Node(*law).solve({{-1.0, 0.1, 0.2}, 0.5});
    FAIL() << "an axis was found";
  } catch (const LawFailure& failure) {
    EXPECT_EQ(failure.code(), base::ExitCode::input) << failure.what();
  }
}

// Sliding across the axes is Coulomb's; between them along the normal of the ellipse.
TEST(OrthotropicFriction, SlidesAlongTheNormalOfItsEllipse) {
  const auto law =
      make("Orthotropic Friction", {{"Friction Coefficient 1", 0.2}, {"Friction Coefficient 2", 0.5}, {"Gap", 0.0}},
           {{"Axis", {0.0, 1.0, 0.0}}});  // t1 of the sample's frame
  const double h = 1e-9, p = 3.0;
  const auto slide = [&](double t1, double t2) { return Node(*law).solve({{-h * p, t1, t2}, h}).traction; };
  EXPECT_NEAR(slide(1.0, 0.0)[1], 0.2 * p, 1e-9);
  EXPECT_NEAR(slide(0.0, -1.0)[2], -0.5 * p, 1e-9);
  for (const double angle : {0.1, 0.7, 1.3, 2.5, -2.0}) {
    const base::Vector3 t = slide(std::cos(angle), std::sin(angle));
    EXPECT_NEAR(std::hypot(t[1] / (0.2 * p), t[2] / (0.5 * p)), 1.0, 1e-12);
    // The jump lies along (t1 / mu1^2, t2 / mu2^2).
    EXPECT_NEAR(t[1] / 0.04 * std::sin(angle), t[2] / 0.25 * std::cos(angle), 1e-7);
  }
  const auto isotropic =
      make("Orthotropic Friction", {{"Friction Coefficient 1", 0.3}, {"Friction Coefficient 2", 0.3}, {"Gap", 0.0}},
           {{"Axis", {1.0, 2.0, 3.0}}});
  const auto coulomb = makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}});
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const LocalLine line = randomLine(random);
    const LocalState a = Node(*isotropic).solve(line), b = Node(*coulomb).solve(line);
    EXPECT_LE(norm(a.traction - b.traction), 1e-12 * norm(line.freeJump) / line.compliance);
  }
}

// A steady slip: from the second load step on the coefficient is that of its velocity.
TEST(RateDependentFriction, FallsWithTheVelocity) {
  const auto law = makeLaw("Rate-Dependent Friction",
                           {{"Static Coefficient", 0.5}, {"Kinetic Coefficient", 0.2}, {"Velocity", 2.0}});
  Node node(*law);
  const double h = 1e-9, duration = 0.5;
  for (int step = 0; step < 4; ++step) {
    const double jump = 0.75 * (step + 1);  // 1.5 [length/time]
    const double found = node.solve({{-h, jump, 0.0}, h}, step, duration).traction[1];
    EXPECT_NEAR(found, step == 0 ? 0.5 : 0.2 + 0.3 * std::exp(-1.5 / 2.0), 1e-8);
    node.accept();
  }
}

/// Traction along t1 after `steps` load steps of equal duration in [0, end], on a line whose free jump goes by
/// `velocity` along t1, pressed by `closing` along the normal.
double drag(const InterfaceLaw& law, double closing, double velocity, double compliance, double end, int steps) {
  Node node(law);
  LocalState state;
  for (int i = 1; i <= steps; ++i) {
    state = node.solve({{-closing, velocity * end * i / steps, 0.0}, compliance}, i - 1, end / steps);
    node.accept();
  }
  return state.traction[1];
}

// A block pulled by a spring k, friction that rises: k (V t - s) = p mu(s'), integrated by Runge and Kutta in the
// spring force q, q' = k (V - mu^-1(q / p)). Implicit Euler, so half the load step is half the error.
TEST(RateDependentFriction, RisesWithTheVelocity) {
  const double rest = 0.2, moving = 0.5, scale = 2.0, h = 0.1, p = 3.0, velocity = 1.5;
  const auto law = makeLaw("Rate-Dependent Friction",
                           {{"Static Coefficient", rest}, {"Kinetic Coefficient", moving}, {"Velocity", scale}});
  const auto rate = [&](double q) { return (velocity + scale * std::log((moving - q / p) / (moving - rest))) / h; };
  const double begin = rest * p * h / velocity, end = begin + 0.15;  // it sticks until then
  double q = rest * p;
  constexpr int pieces = 2000;
  for (int i = 0; i < pieces; ++i) {
    const double dt = 0.15 / pieces, a = rate(q), b = rate(q + 0.5 * dt * a), c = rate(q + 0.5 * dt * b);
    q += dt / 6.0 * (a + 2.0 * b + 2.0 * c + rate(q + dt * c));
  }
  const auto error = [&](int steps) { return std::abs(drag(*law, h * p, velocity, h, end, steps) - q); };
  EXPECT_LT(error(100), 0.01 * q);
  for (const int steps : {100, 400, 1600}) EXPECT_NEAR(error(steps) / error(2 * steps), 2.0, 0.1) << steps;
  // However short the load step: the velocity of a steady slip.
  EXPECT_NEAR(drag(*law, h * p, velocity, h, 100.0, 7), p * (moving - (moving - rest) * std::exp(-velocity / scale)),
              1e-9);
}

// What a load step lags behind is told: nothing in a steady slip, and where friction rises.
TEST(RateDependentFriction, TellsItsLag) {
  const auto lags = [](double rest, double moving) {
    const auto law = makeLaw("Rate-Dependent Friction",
                             {{"Static Coefficient", rest}, {"Kinetic Coefficient", moving}, {"Velocity", 2.0}});
    Node node(*law);
    std::vector<double> result;
    for (int step = 0; step < 2; ++step) {
      node.solve({{-1e-9, 0.75 * (step + 1), 0.0}, 1e-9}, step, 0.5);
      const std::vector<double> history = node.newHistory();
      PairStep at;
      at.history = history.data();
      double values[3];
      law->output(at, values);
      result.push_back(values[2]);
      node.accept();
    }
    return result;
  };
  EXPECT_NEAR(lags(0.5, 0.2)[0], 0.3 * (std::exp(-0.75) - 1.0), 1e-8);
  EXPECT_NEAR(lags(0.5, 0.2)[1], 0.0, 1e-8);
  EXPECT_EQ(lags(0.2, 0.5)[0], 0.0);
}

// Dragged by 0.4 a step under a pressure that is held, as three cycles: the depth is K p times three times the way,
// from the second load step on; what the first one lacks is told.
TEST(ArchardWear, GrowsWithPressureAndWay) {
  const auto law =
      makeLaw("Archard Wear", {{"Wear Coefficient", 0.01}, {"Cycles", 3.0}, {"Friction Coefficient", 0.2}});
  Node node(*law);
  const double soft = 1e6, pressure = 2.0, each = 3.0 * 0.01 * pressure * 0.4;
  for (int step = 0; step < 5; ++step) {
    const double slid = 0.4 * (step + 1), worn = step == 0 ? 0.0 : each * (step + 1);
    const LocalLine line{{-soft * pressure - worn, slid + soft * 0.2 * pressure, 0.0}, soft};
    const LocalState state = node.solve(line, step);
    EXPECT_NEAR(state.traction[0], -pressure, 1e-8);
    EXPECT_NEAR(state.traction[1], 0.2 * pressure, 1e-8);
    double values[3];
    PairStep at;
    const std::vector<double> history = node.newHistory();
    at.traction = state.traction;
    at.history = history.data();
    law->output(at, values);
    EXPECT_NEAR(values[0], slid, 1e-6);
    EXPECT_NEAR(values[1], worn, 1e-6);
    EXPECT_NEAR(values[2], step == 0 ? each : 0.0, 1e-6);
    node.accept();
  }
}

// Pressed by a spring k that wear relaxes, and dragged by the same: from the onset of slip on
// ln(p / p_0) - K mu (p - p_0) = -K k V t. Half the load step is half the error.
TEST(ArchardWear, RelaxesThePressure) {
  const double wear = 0.05, mu = 0.3, h = 0.1, first = 2.0, velocity = 1.0, end = 2.0;
  const auto law = makeLaw("Archard Wear", {{"Wear Coefficient", wear}, {"Cycles", 1.0}, {"Friction Coefficient", mu}});
  const double slides = end - mu * first * h / velocity;
  double p = first;
  for (int i = 0; i < 50; ++i) p = first * std::exp(wear * mu * (p - first) - wear / h * velocity * slides);
  const auto error = [&](int steps) { return std::abs(drag(*law, h * first, velocity, h, end, steps) / mu - p); };
  EXPECT_LT(error(100), 0.01 * first);
  for (const int steps : {100, 400, 1600}) EXPECT_NEAR(error(steps) / error(2 * steps), 2.0, 0.2) << steps;
}

// Two points under a rigid plate, one with a little gap, that is dragged by turns slowly and fast: more wears off where
// the pressure is higher, so that the pressures come to each other, whatever the velocity does.
TEST(ArchardWear, EvensOutThePressure) {
  const auto law = makeLaw("Archard Wear", {{"Wear Coefficient", 0.1}, {"Cycles", 1.0}, {"Friction Coefficient", 0.0}});
  Node first(*law), second(*law, 1e-4);
  constexpr double soft = 1e-3, load = 2.0;
  double slid = 0.0, difference = 0.0;
  for (int step = 0; step < 20; ++step) {
    slid += step % 2 == 0 ? 0.01 : 0.4;
    double low = -10.0, high = 0.0;  // how high the plate is
    std::array<double, 2> pressure{};
    for (int i = 0; i < 200; ++i) {
      const double height = 0.5 * (low + high);
      const LocalLine line{{height, slid, 0.0}, soft};
      pressure = {-first.solve(line, step).traction[0], -second.solve(line, step).traction[0]};
      (pressure[0] + pressure[1] > load ? low : high) = height;
    }
    first.accept();
    second.accept();
    EXPECT_LE(std::abs(pressure[0] - pressure[1]), step == 0 ? load : 1.001 * difference + 1e-9 * load) << step;
    difference = std::abs(pressure[0] - pressure[1]);
  }
  EXPECT_LT(difference, 1e-6 * load);
}

}  // namespace
}  // namespace harmos::laws
