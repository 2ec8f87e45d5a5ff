#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <harmos/latin/March.hpp>
#include <harmos/latin/StepsAtOnce.hpp>
#include <harmos/substructure/SolverFactory.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

using Law = std::shared_ptr<const laws::InterfaceLaw>;

constexpr int memory = 30;
constexpr double accuracy = 1e-3;
constexpr double tight = 1e-11;

Law friction(double mu) {
  return laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", mu}});
}

/// Two cubes that are pressed and then dragged to and fro by more and by less than sticks.
const std::vector<double> cycle = {0.0, 0.3, 1.0, 0.8, -0.5, -1.0, 0.2, 0.3};
BoxAssembly draggedCubes() {
  return twoCubes(friction(0.3),
                  laws::makeLaw("Prescribed Displacement", {{"X", 0.1}, {"Y", 0.0}, {"Z", -0.05}}, {{"X", cycle}}),
                  static_cast<int>(cycle.size()));
}

struct Problem {
  explicit Problem(BoxAssembly boxes, const StageOptions& options = {})
      : cubes(std::move(boxes)), fixedPoint(cubes.assembly(), options, self(), timers) {}

  int steps() { return cubes.assembly().steps(); }
  base::Matrix zero() { return base::Matrix(fixedPoint.layout().rows(), steps()); }

  /// The iteration over all load steps, relaxed, until nothing moves.
  base::Matrix converged() {
    base::Matrix alpha = zero(), image = zero();
    double residual = 1.0;
    for (int n = 0; n < 5000 && residual > 1e-13; ++n) {
      fixedPoint.apply(alpha, image);
      base::Matrix difference(image);
      difference -= alpha;
      residual = fixedPoint.metric().norm(difference) / fixedPoint.metric().norm(image);
      difference.scale(0.7);
      alpha += difference;
    }
    EXPECT_LE(residual, 1e-13);
    return alpha;
  }

  /// Forces f^ of one load step at a state of all.
  std::vector<double> forces(const base::Matrix& alpha, int step) {
    base::Matrix image = zero();
    const double* column = fixedPoint.apply(alpha, image).hattedTraction()[step];
    return {column, column + fixedPoint.layout().rows()};
  }

  base::Timers timers;
  BoxAssembly cubes;
  FixedPoint fixedPoint;
};

void expectEqualForces(Problem& problem, const base::Matrix& alpha, const base::Matrix& expected) {
  for (int t = 0; t < problem.steps(); ++t) {
    const std::vector<double> found = problem.forces(alpha, t), right = problem.forces(expected, t);
    double size = 0.0, error = 0.0;
    for (std::size_t i = 0; i < right.size(); ++i) {
      size = std::max(size, std::abs(right[i]));
      error = std::max(error, std::abs(found[i] - right[i]));
    }
    EXPECT_LE(error, 1e-7 * size) << "load step " << t + 1;
  }
}

// Friction keeps what has slid: the way to and fro is not the way back, and both iterations find the same one.
TEST(March, FindsWhatTheIterationOverAllStepsFinds) {
  Problem problem(draggedCubes());
  base::Matrix alpha = problem.zero();
  March march(problem.fixedPoint, memory, accuracy, 0);
  EXPECT_EQ(march.run(alpha, tight, March::Guess::extrapolation), March::End::reached);
  expectEqualForces(problem, alpha, problem.converged());
  // The same displacement at the steps 2 and 8, but another history.
  const std::vector<double> there = problem.forces(alpha, 1), again = problem.forces(alpha, 7);
  double size = 0.0, difference = 0.0;
  for (std::size_t i = 0; i < there.size(); ++i) {
    size = std::max(size, std::abs(there[i]));
    difference = std::max(difference, std::abs(there[i] - again[i]));
  }
  EXPECT_GT(difference, 0.05 * size);
}

// Of many load steps what the acceleration remembers of them is not kept: a second march goes on without it.
TEST(March, GoesOnWithManyLoadSteps) {
  constexpr int steps = stepsAtOnce + 6;
  std::vector<double> factors;
  for (int t = 0; t < steps; ++t) factors.push_back(std::sin(0.5 * t));
  Problem problem(twoCubes(
      friction(0.3), laws::makeLaw("Prescribed Displacement", {{"X", 0.1}, {"Y", 0.0}, {"Z", -0.05}}, {{"X", factors}}),
      steps));
  base::Matrix alpha = problem.zero(), image = problem.zero();
  March march(problem.fixedPoint, memory, accuracy, 0);
  EXPECT_EQ(march.run(alpha, 1e-2, March::Guess::extrapolation), March::End::reached);
  EXPECT_EQ(march.run(alpha, 1e-8, March::Guess::state), March::End::reached);
  const Iterate& iterate = problem.fixedPoint.apply(alpha, image);
  const double size = problem.fixedPoint.metric().norm(iterate.hattedTraction());
  EXPECT_LE(problem.fixedPoint.metric().distance(image, alpha), 1e-6 * size);
}

// With lines a million times too steep, what memory of one iteration finds is far from a solution after a hundred.
TEST(March, KnowsWhetherItHasLeftAStepAsItWas) {
  StageOptions steep;
  steep.searchDirectionScale = 1e6;
  Problem problem(draggedCubes()), slow(draggedCubes(), steep);
  base::Matrix alpha = problem.zero();
  March march(problem.fixedPoint, 1, accuracy, 0), slowMarch(slow.fixedPoint, 1, accuracy, 0);
  EXPECT_EQ(march.run(alpha, 1e-6, March::Guess::extrapolation), March::End::reached);
  EXPECT_TRUE(march.isNearEnough());
  alpha = slow.zero();
  EXPECT_EQ(slowMarch.run(alpha, 1e-6, March::Guess::extrapolation), March::End::reached);
  EXPECT_FALSE(slowMarch.isNearEnough());
}

TEST(March, StaysWhereItIsRight) {
  Problem problem(draggedCubes());
  base::Matrix alpha = problem.converged();
  std::vector<int> visited, iterations;
  March march(problem.fixedPoint, memory, accuracy, 0);
  march.setObserver([&](int step, int count, const Iterate&) {
    visited.push_back(step);
    iterations.push_back(count);
  });
  EXPECT_EQ(march.run(alpha, 1e-9, March::Guess::state), March::End::reached);
  EXPECT_EQ(visited, allSteps(problem.steps()));
  EXPECT_EQ(iterations, std::vector<int>(cycle.size(), 1));
  expectEqualForces(problem, alpha, problem.converged());
}

// What is asked for decides how far it may serve.
TEST(March, IsAsExactInSinglePrecisionAsInDouble) {
  if (substructure::availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD solves in single precision";
  StageOptions inDouble, inSingle;
  inDouble.solver.invertTrace = inSingle.solver.invertTrace = true;
  inDouble.solver.allowsSingle = false;
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-9}) {
    Problem exact(draggedCubes(), inDouble), problem(draggedCubes(), inSingle);
    EXPECT_EQ(exact.fixedPoint.prepareSingle(), 0.0);
    EXPECT_GT(problem.fixedPoint.prepareSingle(), 1e-8);
    base::Matrix states[] = {exact.zero(), exact.zero()};
    std::vector<int> iterations[2];
    for (const int i : {0, 1}) {
      March march((i == 0 ? exact : problem).fixedPoint, memory, accuracy, 0);
      march.setObserver([&](int, int count, const Iterate&) { iterations[i].push_back(count); });
      EXPECT_EQ(march.run(states[i], tolerance, March::Guess::extrapolation), March::End::reached);
    }
    for (std::size_t t = 0; t < cycle.size(); ++t) EXPECT_NEAR(iterations[1][t], iterations[0][t], 1) << tolerance;
    // The residual is in double precision.
    const StateMetric& metric = exact.fixedPoint.metric();
    base::Matrix image = exact.zero();
    const double force = metric.norm(exact.fixedPoint.apply(states[1], image).hattedTraction());
    EXPECT_LE(metric.distance(image, states[1]), tolerance * force);
    // Whether it has served.
    EXPECT_EQ(metric.distance(states[0], states[1]) > 0.0, tolerance > 1e-8) << tolerance;
  }
}

// After a march the fixed point has all load steps again, from the unloaded state.
TEST(March, LeavesTheFixedPointAsItWas) {
  Problem problem(draggedCubes());
  base::Matrix state = problem.zero();
  randomize(state);
  const std::vector<double> before = problem.forces(state, 5);
  base::Matrix alpha = problem.zero();
  March(problem.fixedPoint, memory, accuracy, 0).run(alpha, 1e-3, March::Guess::extrapolation);
  EXPECT_EQ(problem.forces(state, 5), before);
}

// What comes after an early end are copies of its last state, not the nothing that load steps may begin from.
TEST(March, StopsWhenAsked) {
  for (const March::Guess guess : {March::Guess::extrapolation, March::Guess::nothing}) {
    Problem problem(draggedCubes());
    base::Matrix alpha = problem.zero();
    int steps = 0;
    March march(problem.fixedPoint, memory, accuracy, 0);
    march.setObserver([&](int, int, const Iterate&) { ++steps; });
    march.setStop([&] { return steps == 3; });
    EXPECT_EQ(march.run(alpha, tight, guess), March::End::stopped);
    EXPECT_EQ(steps, 4);
    EXPECT_EQ(march.stepsReached(), 3);
    for (int t = 4; t < problem.steps(); ++t) {
      for (int row = 0; row < alpha.numRows(); ++row) EXPECT_EQ(alpha(row, t), alpha(row, 3));
    }
  }
}

// Whatever alpha held; a tolerance that everything meets leaves a load step at its first image.
TEST(March, BeginsLoadStepsFromNothing) {
  constexpr double any = 1e9;
  Problem problem(draggedCubes());
  base::Matrix alpha = problem.zero(), image = problem.zero(), random = problem.zero();
  problem.fixedPoint.apply(alpha, image);
  randomize(random);
  alpha.assign(random);
  March(problem.fixedPoint, memory, accuracy, 0).run(alpha, any, March::Guess::nothing);
  // One column is solved for otherwise than many at once.
  const double roundOff = 1e-12 * image.normInf();
  for (int row = 0; row < alpha.numRows(); ++row) EXPECT_NEAR(alpha(row, 0), image(row, 0), roundOff);
  base::Matrix again = problem.zero(), other = problem.zero();
  March(problem.fixedPoint, memory, accuracy, 0).run(again, any, March::Guess::nothing);
  EXPECT_EQ(alpha, again);
  other.assign(random);
  March(problem.fixedPoint, memory, accuracy, 0).run(other, any, March::Guess::state);
  EXPECT_FALSE(other == again);
}

// The pull grows step by step; 0.3 x 2 carries it until the fourth. A step at the edge may pass for one that is slow.
TEST(March, FindsTheStepThatNothingCarries) {
  const std::vector<double> pull = {0.0, 0.2, 0.4, 0.8, 0.9};
  Problem problem(
      twoCubes(friction(0.3), laws::makeLaw("Prescribed Traction", {{"X", 1.0}, {"Z", -2.0}}, {{"X", pull}}), 5));
  base::Matrix alpha = problem.zero();
  March march(problem.fixedPoint, memory, accuracy, 0);
  EXPECT_EQ(march.run(alpha, 1e-8, March::Guess::extrapolation), March::End::noEquilibrium);
  EXPECT_NE(march.reason().find("part \"upper\", load step "), std::string::npos) << march.reason();
  EXPECT_EQ(march.reason().find("load step 3:"), std::string::npos) << march.reason();
}

// With so soft lines the watch is silent; in pseudo-time the cube is seen to slide on and on. What is solved is not
// lost.
TEST(March, NotesTheStepThatSlidesWithoutEnd) {
  const auto dragged = [](double most) {
    return twoCubes(friction(0.3),
                    laws::makeLaw("Prescribed Traction", {{"X", 1.0}, {"Z", -2.0}}, {{"X", {0.0, most}}}), 2);
  };
  std::optional<March::Slide> slide;
  for (const double most : {0.9, 0.4}) {
    BoxAssembly cubes = dragged(most);
    base::Timers timers;
    StageOptions options;
    options.searchDirectionScale = 1e-3;
    FixedPoint fixedPoint(cubes.assembly(), options, self(), timers);
    StepNewton newton(fixedPoint);
    March march(fixedPoint, memory, accuracy, 0);
    march.setNewton(newton);
    march.setSlide(slide);
    base::Matrix alpha(fixedPoint.layout().rows(), 2);
    EXPECT_EQ(march.run(alpha, accuracy, March::Guess::extrapolation), March::End::reached);
    ASSERT_EQ(slide.has_value(), most > 0.6);
    if (!slide) continue;
    EXPECT_EQ(slide->step, 1);
    EXPECT_NE(slide->reason.find("part \"upper\", load step 2: unbalanced force"), std::string::npos) << slide->reason;
  }
}

// Rigid statics knows it before the load step is iterated, and the steps before it are solved.
TEST(March, StopsBeforeAStepThatCannotBeBalanced) {
  const std::vector<double> pull = {0.0, 0.2, 0.4, 0.601, 0.2};
  Problem problem(
      twoCubes(friction(0.3), laws::makeLaw("Prescribed Traction", {{"X", 1.0}, {"Z", -2.0}}, {{"X", pull}}), 5));
  base::Matrix alpha = problem.zero();
  base::Timers timers;
  LoadBalance balance(problem.fixedPoint.assembly(), *self(), timers);
  March march(problem.fixedPoint, memory, accuracy, 0);
  march.setLoadBalance(balance);
  int steps = 0;
  march.setObserver([&](int, int, const Iterate&) { ++steps; });
  EXPECT_EQ(march.run(alpha, 1e-8, March::Guess::extrapolation), March::End::noEquilibrium);
  EXPECT_EQ(steps, 3);
  EXPECT_NE(march.reason().find("balance the loads of load step 4"), std::string::npos) << march.reason();
}

}  // namespace
}  // namespace harmos::latin
