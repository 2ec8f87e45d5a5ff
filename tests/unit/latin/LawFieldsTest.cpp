#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <harmos/latin/LatinSolver.hpp>
#include <harmos/latin/LawFields.hpp>
#include <harmos/latin/Response.hpp>
#include <harmos/laws/FaceLaw.hpp>
#include <harmos/laws/PointwiseLaw.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

constexpr std::size_t elements = 4;
constexpr double spring = 8.0, normalSpring = 50.0;
constexpr std::array<double, elements> slider{0.5, 1.0, 2.0, 4.0};

/// Jenkins elements in parallel along t1, each a spring in series with a slider; a spring along n.
struct Iwan {
  static constexpr const char* name = "Iwan";
  static constexpr int historySize = elements;  // slips
  static constexpr laws::Sides sides = laws::Sides::any;
  static constexpr bool dissipates = true;

  static double forceOf(std::size_t i, double jump, double slip) {
    return std::clamp(spring * (jump - slip), -slider[i], slider[i]);
  }

  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext&, const double* old, double* now) const {
    const auto force = [&](double jump) {
      double sum = 0.0;
      for (std::size_t i = 0; i < elements; ++i) sum += forceOf(i, jump, old[i]);
      return sum;
    };
    // delta + H t(delta) grows with delta.
    const double reach = 8.0 * line.compliance + 1.0;
    double below = line.freeJump[1] - reach, above = line.freeJump[1] + reach;
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (below + above);
      (middle + line.compliance * force(middle) < line.freeJump[1] ? below : above) = middle;
    }
    const double jump = 0.5 * (below + above);
    for (std::size_t i = 0; i < elements; ++i) now[i] = jump - forceOf(i, jump, old[i]) / spring;
    laws::LocalState state;
    state.traction = {normalSpring * line.freeJump[0] / (1.0 + normalSpring * line.compliance), force(jump), 0.0};
    state.status = laws::Status::stick;
    return state;
  }

  double keptWork(const laws::PairStep& step) const {
    double kept = normalSpring * step.jump[0] * (step.jump[0] - step.oldJump[0]);
    for (std::size_t i = 0; i < elements; ++i) {
      const double now = step.jump[1] - step.history[i], old = step.oldJump[1] - step.oldHistory[i];
      kept += spring * now * (now - old);
    }
    return kept;
  }
};

/// A crack that opens against a constant traction, as long as it opens.
struct Tearing {
  static constexpr const char* name = "Tearing";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::any;
  static constexpr bool dissipates = true;
  laws::LocalState solve(const laws::LocalLine&, const laws::NodeContext&, const double*, double*) const {
    laws::LocalState state;
    state.traction = {2.0, 0.0, 0.0};
    return state;
  }
};

/// One pair of area 1 under a law.
assembly::Interface onePair(std::shared_ptr<const laws::InterfaceLaw> law) {
  assembly::Interface interface;
  interface.name = "joint";
  interface.law = std::move(law);
  interface.body1 = 0;
  interface.body2 = 1;
  interface.trace1 = interface.trace2 = mesh::TraceOperator({0});
  interface.position = {{}};
  interface.frame = {{base::Vector3{1, 0, 0}, base::Vector3{0, 1, 0}, base::Vector3{0, 0, 1}}};
  interface.area = {1.0};
  interface.gap = {0.0};
  return interface;
}

/// The law led along these jumps.
PairFields along(const assembly::Interface& interface, const std::vector<base::Vector3>& path) {
  const auto numbers = static_cast<std::size_t>(interface.law->historySize());
  std::vector<double> old(numbers, 0.0), now(numbers, 0.0);
  PairFields fields;
  fields.pairs = 1;
  fields.steps = static_cast<int>(path.size());
  for (int t = 0; t < fields.steps; ++t) fields.times.push_back(t + 1.0);
  for (int t = 0; t < fields.steps; ++t) {
    const laws::LocalLine line{path[t], 1e-9};
    laws::LocalState state;
    interface.law->solve(t, {1, &line, interface.gap.data(), old.data(), now.data(), &state});
    fields.traction.push_back(state.traction);
    fields.jump.push_back(line.jump(state.traction));
    fields.status.push_back(state.status);
    old.swap(now);
  }
  return fields;
}

TEST(LostWork, OfSpringsWithSlidersThatStickIsNothing) {
  const assembly::Interface interface = onePair(std::make_shared<laws::PointwiseLaw<Iwan>>());
  const double most = slider[0] / spring;  // where the first one slides
  const auto lost =
      lawFields(interface, along(interface, {{0.1, 0.9 * most, 0}, {0.3, -0.4 * most, 0}, {-0.2, 0, 0}})).lost;
  for (const double each : lost) EXPECT_NEAR(each, 0.0, 1e-6 * slider[0] * most);
}

TEST(LostWork, OfSpringsWithSlidersIsForceTimesSlip) {
  const assembly::Interface interface = onePair(std::make_shared<laws::PointwiseLaw<Iwan>>());
  const double far = 0.3, back = -0.2;
  // However coarse the load steps are.
  for (const int divisions : {1, 7}) {
    std::vector<base::Vector3> path;
    for (int k = 1; k <= divisions; ++k) path.push_back({0.0, far * k / divisions, 0.0});
    for (int k = 1; k <= divisions; ++k) path.push_back({0.0, far + (back - far) * k / divisions, 0.0});
    double expected[2] = {0.0, 0.0};
    for (const double force : slider) {
      const double there = std::max(0.0, far - force / spring);          // slip on the way out
      const double left = std::max(0.0, there - back - force / spring);  // and on the way back
      expected[0] += force * there;
      expected[1] += force * (there + left);
    }
    const auto lost = lawFields(interface, along(interface, path)).lost;
    EXPECT_NEAR(lost[static_cast<std::size_t>(divisions) - 1], expected[0], 1e-6 * expected[0]);
    EXPECT_NEAR(lost.back(), expected[1], 1e-6 * expected[1]);
  }
}

TEST(LostWork, IsAlsoThatAlongTheNormal) {
  const assembly::Interface interface = onePair(std::make_shared<laws::PointwiseLaw<Tearing>>());
  const auto lost = lawFields(interface, along(interface, {{0.5, 0, 0}, {0.75, 0, 0}})).lost;
  EXPECT_NEAR(lost[0], 1.0, 1e-6);
  EXPECT_NEAR(lost[1], 1.5, 1e-6);
}

TEST(LostWork, OfAGapThatClosesIsNothing) {
  assembly::Interface interface = onePair(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}));
  interface.gap = {0.1};
  PairFields fields;
  fields.pairs = 1;
  fields.steps = 2;
  fields.times = {1.0, 2.0};
  fields.traction = {{-5.0, 0.0, 0.0}, {-5.0, 1.5, 0.0}};
  fields.jump = {{-0.1, 0.0, 0.0}, {-0.1, 0.2, 0.0}};
  fields.status = {laws::Status::stick, laws::Status::slip};
  const auto lost = lawFields(interface, fields).lost;
  EXPECT_DOUBLE_EQ(lost[0], 0.0);
  EXPECT_NEAR(lost[1], 0.3, 1e-15);  // friction does what it did
  for (const char* law : {"Linear Elastic", "Elastic Foundation"}) {
    interface.law = laws::makeLaw(law, {{"Normal Stiffness", 3.0}, {"Tangential Stiffness", 2.0}});
    for (const double each : lawFields(interface, fields).lost) EXPECT_EQ(each, 0.0);
  }
}

// A Jenkins element led out, beyond its limit, half the way back, and to where it has slid as far the other way.
TEST(LawFields, ReadWhatTheLawRemembers) {
  input::Parameters p("law");
  p.set("Type", std::string("Jenkins")).set("Tangential Stiffness", 4.0).set("Slip Limit", 2.0).set("Opens", false);
  p.set("Normal Stiffness", 50.0);
  const assembly::Interface interface = onePair(laws::builtInLaws().create(p));
  const LawFields fields =
      lawFields(interface, along(interface, {{0.1, 0.25, 0}, {0.1, 1.5, 0}, {0.1, 0.75, 0}, {-0.1, -0.5, 0}}));
  ASSERT_EQ(fields.outputs.size(), 1U);
  const std::array<double, 4> way{0.0, 1.0, 1.0, 2.0}, force{1.0, 2.0, -1.0, -2.0};
  for (std::size_t t = 0; t < way.size(); ++t) {
    EXPECT_NEAR(fields.outputs[0][t], way[t], 1e-6);
    EXPECT_NEAR(fields.lost[t], 2.0 * way[t], 1e-6);
    EXPECT_NEAR(fields.stored[t], 0.5 * 50.0 * 0.01 + 0.5 * force[t] * force[t] / 4.0, 1e-6);
  }
}

// The same through the law that users have: nothing is lost while all sliders stick, whatever is stored meanwhile.
TEST(LawFields, OfParallelIwanLoseNothingBeforeItSlides) {
  input::Parameters p("law");
  p.set("Type", std::string("Parallel Iwan")).set("Stiffnesses", std::vector<double>(elements, spring));
  p.set("Slip Limits", std::vector<double>(slider.begin(), slider.end())).set("Residual Stiffness", 0.0);
  p.set("Opens", false).set("Normal Stiffness", normalSpring);
  const assembly::Interface interface = onePair(laws::builtInLaws().create(p));
  const std::size_t sticking = 4;
  const LawFields fields = lawFields(
      interface, along(interface, {{0.1, 0.05, 0}, {0.1, -0.06, 0}, {0.1, 0.06, 0}, {-0.1, 0.0, 0}, {-0.1, 1.0, 0}}));
  for (std::size_t t = 0; t < sticking; ++t) EXPECT_NEAR(fields.lost[t], 0.0, 1e-9) << t;
  EXPECT_GT(fields.stored[1], 0.25);
  double lost = 0.0;
  for (const double limit : slider) lost += limit * (1.0 - limit / spring);
  EXPECT_NEAR(fields.lost[sticking], lost, 1e-6);
}

/// Through the solver: cubes joined by such a law and dragged less than makes the first slider move.
TEST(DissipationResponse, OfElementsThatStickIsZero) {
  BoxAssembly cubes = twoCubes(
      std::make_shared<laws::PointwiseLaw<Iwan>>(),
      laws::makeLaw("Prescribed Displacement", {{"X", 0.05}, {"Y", 0.0}, {"Z", 0.01}}, {{"X", {0.5, 1.0, -1.0}}}), 3);
  base::Timers timers;
  LatinOptions options;
  options.accuracy = 1e-6;
  LatinSolver solver(cubes.assembly(), options, self(), timers);
  const auto loss = std::make_shared<DissipationResponse>("loss", std::vector<int>{1});
  solver.addResponse(loss);
  solver.addResponse(
      std::make_shared<ResultantResponse>("drag", std::vector<int>{1}, std::vector<base::Vector3>{{1.0, 0.0, 0.0}}));
  const LatinResult result = solver.solve();
  ASSERT_EQ(result.outcome, Outcome::certified) << result.reason;
  ASSERT_GT(std::abs(result.responses[1].values[1]), 0.1);
  for (const double each : result.responses[0].values) EXPECT_NEAR(each, 0.0, 1e-6);
  EXPECT_TRUE(result.responses[0].isSmall);
  EXPECT_FALSE(result.responses[1].isSmall);
  EXPECT_EQ(result.solvedSteps, 3);
}

TEST(Response, MayStateItsOwnScale) {
  BoxAssembly cubes =
      twoCubes(laws::makeLaw("Perfect"), laws::makeLaw("Prescribed Traction", {{"Z", 1.0}, {"X", 1e-6}}), 1);
  base::Timers timers;
  LatinOptions options;
  options.accuracy = 1e-4;
  LatinSolver solver(cubes.assembly(), options, self(), timers);
  const auto force = [](const std::string& name) {
    return std::make_shared<ResultantResponse>(name, std::vector<int>{0}, std::vector<base::Vector3>{{1.0, 0.0, 0.0}});
  };
  const auto scaled = force("scaled");
  scaled->setScale(1e-6);
  solver.addResponse(force("usual"));
  solver.addResponse(scaled);
  const LatinResult result = solver.solve();
  ASSERT_EQ(result.outcome, Outcome::certified) << result.reason;
  // 1e-3 of the sum of all interface forces, beside its own value.
  EXPECT_TRUE(result.responses[0].isSmall);
  EXPECT_GT(result.responses[0].size, 1e-4);
  EXPECT_NEAR(result.responses[1].size, 1e-6, 1e-7);
  EXPECT_NEAR(result.responses[1].values[0], -1e-6, 1e-4 * 1e-6 * 2);
}

// A law over a whole face is asked for nothing where a piece has a pair of it only, which does not tell its motion.
TEST(LawFields, OfAPieceOfAFaceAreNothing) {
  const auto law = laws::makeLaw("Face Spring", {}, {}, {{"Point", {0.5, 0.5, 0.0}}, {"Axis", {0.0, 0.0, 1.0}}});
  const std::vector<std::pair<base::Vector3, double>> face{
      {{0, 0, 0}, 1.0}, {{1, 0, 0}, 1.0}, {{0, 1, 0}, 1.0}, {{1, 1, 0}, 1.0}};
  const assembly::Interface piece = onePair(dynamic_cast<const laws::FaceLaw&>(*law).on(
      std::make_shared<const laws::FaceMotions>(laws::FaceMotions::of(face, 3).value())));
  PairFields fields;
  fields.pairs = fields.steps = 1;
  fields.times = {1.0};
  fields.traction = fields.jump = {{0.0, 0.0, 1.0}};
  fields.status = {laws::Status::bonded};
  EXPECT_EQ(lawFields(piece, fields).stored, std::vector<double>{0.0});
}

}  // namespace
}  // namespace harmos::latin
