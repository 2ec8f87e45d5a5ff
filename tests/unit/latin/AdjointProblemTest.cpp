#include <cmath>

#include <gtest/gtest.h>

#include <harmos/latin/AdjointProblem.hpp>
#include <harmos/latin/LatinSolver.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

constexpr int steps = 3;

/// Two cubes that slide on one another here and stick there, the upper one on springs at one side.
BoxAssembly rubbing() {
  return twoCubes(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}),
                  laws::makeLaw("Prescribed Traction", {{"X", 0.9}, {"Z", -4.0}}, {{"X", {0, 0.5, 1}}}), steps);
}

/// Displacement of a node, resultants on the joint and at the clamp, and a moment.
std::vector<std::shared_ptr<const Response>> responses(const assembly::Assembly& assembly) {
  const auto indexOf = [&](bool isJoint) {
    for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
      const assembly::Interface& interface = assembly.interfaces[i];
      if (isJoint ? interface.sides() == 2 : interface.sides() == 1 && !interface.law->prescribesTraction()) {
        return static_cast<int>(i);
      }
    }
    return -1;
  };
  const int joint = indexOf(true), clamp = indexOf(false);
  return {std::make_shared<DisplacementResponse>(
              "u", std::vector<DisplacementResponse::Node>{{1, 3, 0.5}, {1, 20, 0.5}}, base::Vector3{1, 0.2, -0.5}),
          std::make_shared<ResultantResponse>("n", std::vector<int>{joint}, std::vector<base::Vector3>{}),
          std::make_shared<ResultantResponse>("m", std::vector<int>{joint}, std::vector<base::Vector3>{{0, 1, 0}},
                                              std::vector<base::Vector3>{{0.1, 0.2, 0.3}}),
          std::make_shared<ResultantResponse>("r", std::vector<int>{clamp}, std::vector<base::Vector3>{{1, 0, 0.5}})};
}

/// The responses at the last load step under additional nodal forces there.
std::vector<double> solve(const std::vector<base::Matrix>& loads, bool withMacroProblem) {
  BoxAssembly cubes = rubbing();
  for (std::size_t b = 0; b < loads.size(); ++b) {
    base::Matrix& all = cubes.assembly().bodies[b].loads;
    all.shape(loads[b].numRows(), steps);
    std::copy_n(loads[b][0], loads[b].numRows(), all[steps - 1]);
  }
  base::Timers timers;
  LatinOptions options;
  options.accuracy = 1e-10;
  options.stages.macroProblem = withMacroProblem;
  LatinSolver solver(cubes.assembly(), options, self(), timers);
  for (const auto& response : responses(cubes.assembly())) solver.addResponse(response);
  const LatinResult result = solver.solve();
  EXPECT_EQ(result.outcome, Outcome::certified) << result.reason;
  std::vector<double> values;
  for (const ResponseResult& response : result.responses) values.push_back(response.values.back());
  return values;
}

// dJ = z.dF for any small forces, whether nodes stick or slide, and whatever holds them.
TEST(AdjointProblem, SaysWhatForcesDoToResponses) {
  for (const bool withMacroProblem : {true, false}) {
    BoxAssembly cubes = rubbing();
    base::Timers timers;
    LatinOptions options;
    options.accuracy = 1e-10;
    options.stages.macroProblem = withMacroProblem;
    LatinSolver solver(cubes.assembly(), options, self(), timers);
    solver.solve();
    AdjointProblem problem(solver.fixedPoint(), solver.state(), steps - 1);
    std::vector<ResponseGradient> gradients;
    for (const auto& response : responses(cubes.assembly())) {
      gradients.push_back(response->gradient(cubes.assembly()).value());
    }
    const auto adjoints = problem.solve(gradients, 1e-8, 300);

    std::vector<base::Matrix> loads, against;
    for (const auto& body : cubes.assembly().bodies) {
      loads.emplace_back(3 * static_cast<int>(body.nodes.size()), 1);
      randomize(loads.back(), static_cast<unsigned>(loads.size()));
      loads.back().scale(1e-5);
      against.push_back(loads.back());
      against.back().scale(-1.0);
    }
    const std::vector<double> more = solve(loads, withMacroProblem), less = solve(against, withMacroProblem);
    for (std::size_t j = 0; j < gradients.size(); ++j) {
      double expected = 0.0;
      for (std::size_t b = 0; b < loads.size(); ++b) {
        for (int i = 0; i < loads[b].numRows(); ++i) expected += adjoints[j].displacement[b][i] * loads[b](i, 0);
      }
      const double found = 0.5 * (more[j] - less[j]);
      // The differences have about five digits left; none of them is small.
      EXPECT_NEAR(found, expected, 1e-4 * std::abs(found)) << "response " << j;
      EXPECT_GT(std::abs(found), 1e-8);
      EXPECT_LE(adjoints[j].hidden, 1e-8);
    }
  }
}

constexpr double littleFriction = 0.01;

/// wall |--- spring of 30 ---| rubbing joint |--- a chain of bodies ---| pressed against it; the first body is pulled
/// along the joint and slides.
assembly::Assembly slidingOnAChain(int bodies) {
  assembly::Assembly assembly;
  assembly.times = {1.0};
  assembly.interfaces = {pointInterface("wall", clamp(), 0, 0, -1, 0, 1.0, 0.0, -1.0)};
  assembly.bodies = {chain("slider", 0.0, 2, 30.0)};
  for (int b = 1; b <= bodies; ++b) {
    assembly.bodies.push_back(chain("b" + std::to_string(b), b, 2, 30.0));
    const char* law = b == 1 ? "Coulomb Friction" : "Perfect";
    auto joint = b == 1 ? laws::makeLaw(law, {{"Friction Coefficient", littleFriction}}) : laws::makeLaw(law, {});
    assembly.interfaces.push_back(pointInterface("joint", std::move(joint), b - 1, 1, b, 0));
  }
  const auto boundary = [&](const char* law, const std::map<std::string, double>& numbers, int body) {
    assembly.interfaces.push_back(pointInterface("boundary", laws::makeLaw(law, numbers), body, 1));
  };
  boundary("Prescribed Traction", {{"Y", 1.0}}, 0);
  boundary("Prescribed Traction", {{"X", -3.0}}, bodies);
  boundary("Prescribed Displacement", {{"Y", 0.0}, {"Z", 0.0}}, bodies);
  return assembly;
}

// How a pressure far away changes the sliding is a small share of the residual, and of the adjoint: a space of a few
// directions does not know it, and must not be taken for one that does.
TEST(AdjointProblem, DoesNotStopBeforeSlowModesShow) {
  constexpr int bodies = 8;
  const assembly::Assembly springs = slidingOnAChain(bodies);
  base::Timers timers;
  LatinOptions options;
  options.accuracy = 1e-8;
  LatinSolver solver(springs, options, self(), timers);
  ASSERT_EQ(solver.solve().outcome, Outcome::certified);
  AdjointProblem problem(solver.fixedPoint(), solver.state(), 0);
  const DisplacementResponse slip("u", {{0, 1, 1.0}}, base::Vector3{0, 1, 0});
  const auto adjoints = problem.solve({slip.gradient(springs).value()}, 0.02, 100);
  EXPECT_NEAR(adjoints[0].displacement[0][4], 1.0 / 30.0, 0.02 / 30.0);
  for (int b = 1; b <= bodies; ++b) {
    EXPECT_NEAR(std::abs(adjoints[0].displacement[b][3]), littleFriction / 30.0, 0.05 * littleFriction / 30.0) << b;
  }
}

// The solver is as it was: another run gives the same numbers.
/// Two cubes between a wall and springs, drawn together by a force in the first load step, and locked.
BoxAssembly tightened() {
  input::Parameters parameters("law");
  parameters.set("Type", std::string("Pretension")).set("Force", 2.0).set("Locked From", 1.0);
  parameters.attach(std::make_shared<input::Histories>(std::vector<double>{1.0, 2.0, 3.0}));
  return twoCubes(laws::builtInLaws().create(parameters),
                  laws::makeLaw("Elastic Foundation", {{"Normal Stiffness", 500.0}, {"Tangential Stiffness", 300.0}}),
                  steps);
}

/// Its responses at the last load step under additional nodal forces at some load steps.
std::vector<double> solveTightened(const std::vector<base::Matrix>& loads, const std::vector<int>& at) {
  BoxAssembly cubes = tightened();
  for (std::size_t b = 0; b < loads.size(); ++b) {
    base::Matrix& all = cubes.assembly().bodies[b].loads;
    all.shape(loads[b].numRows(), steps);
    for (const int step : at) std::copy_n(loads[b][0], loads[b].numRows(), all[step]);
  }
  base::Timers timers;
  LatinOptions options;
  options.accuracy = 1e-8;
  LatinSolver solver(cubes.assembly(), options, self(), timers);
  for (const auto& response : responses(cubes.assembly())) solver.addResponse(response);
  const LatinResult result = solver.solve();
  std::vector<double> values;
  for (const ResponseResult& response : result.responses) values.push_back(response.values.back());
  return values;
}

// Forces while a bolt is tightened change what it keeps, and so all that follows: by the jump kept, and by nothing
// else.
TEST(AdjointProblem, SaysWhatLockedBoltsKeep) {
  BoxAssembly cubes = tightened();
  base::Timers timers;
  LatinOptions options;
  options.accuracy = 1e-8;
  LatinSolver solver(cubes.assembly(), options, self(), timers);
  ASSERT_EQ(solver.solve().outcome, Outcome::certified);
  std::vector<ResponseGradient> gradients;
  for (const auto& response : responses(cubes.assembly())) {
    gradients.push_back(response->gradient(cubes.assembly()).value());
  }
  AdjointProblem last(solver.fixedPoint(), solver.state(), steps - 1), first(solver.fixedPoint(), solver.state(), 0);
  EXPECT_TRUE(first.kept().empty());
  ASSERT_EQ(last.kept().size(), 1U);
  EXPECT_EQ(last.kept()[0].step, 0);
  const auto adjoints = last.solve(gradients, 1e-8, 300);
  const auto ofJump = first.solve({last.kept()[0].gradient}, 1e-8, 300);

  std::vector<base::Matrix> loads, against;
  for (const auto& body : cubes.assembly().bodies) {
    loads.emplace_back(3 * static_cast<int>(body.nodes.size()), 1);
    randomize(loads.back(), static_cast<unsigned>(loads.size()));
    against.push_back(loads.back());
    against.back().scale(-1.0);
  }
  const auto change = [&](const auto& adjoint) {
    double sum = 0.0;
    for (std::size_t b = 0; b < loads.size(); ++b) {
      for (int i = 0; i < loads[b].numRows(); ++i) sum += adjoint.displacement[b][i] * loads[b](i, 0);
    }
    return sum;
  };
  const auto more = solveTightened(loads, {0}), less = solveTightened(against, {0});
  const auto always = solveTightened(loads, {0, steps - 1}), never = solveTightened(against, {0, steps - 1});
  for (std::size_t j = 0; j < gradients.size(); ++j) {
    const double kept = adjoints[j].ofKept[0] * change(ofJump[0]), atOnce = change(adjoints[j]);
    const double tolerance = 1e-4 * (std::abs(kept) + std::abs(atOnce));
    EXPECT_NEAR(0.5 * (more[j] - less[j]), kept, tolerance) << "response " << j;
    EXPECT_NEAR(0.5 * (always[j] - never[j]), kept + atOnce, tolerance) << "response " << j;
    if (j < 2) {  // along the axis of the bolt
      EXPECT_GT(std::abs(kept), 5e-4 * std::abs(atOnce));
    }
  }
}

TEST(AdjointProblem, LeavesTheSolverAsItWas) {
  BoxAssembly cubes = rubbing();
  base::Timers timers;
  LatinSolver solver(cubes.assembly(), {}, self(), timers);
  for (const auto& response : responses(cubes.assembly())) solver.addResponse(response);
  const LatinResult before = solver.solve();
  AdjointProblem problem(solver.fixedPoint(), solver.state(), 1);
  EXPECT_TRUE(solver.state().isValid());
  problem.solve({responses(cubes.assembly())[3]->gradient(cubes.assembly()).value()}, 0.05, 30);
  const LatinResult after = solver.solve();
  for (std::size_t j = 0; j < before.responses.size(); ++j) {
    EXPECT_EQ(before.responses[j].values, after.responses[j].values);
  }
}

// A response that is nowhere, such as the resultant of what is prescribed, depends on nothing.
TEST(AdjointProblem, OfNothingIsNothing) {
  BoxAssembly cubes = rubbing();
  base::Timers timers;
  LatinSolver solver(cubes.assembly(), {}, self(), timers);
  solver.solve();
  AdjointProblem problem(solver.fixedPoint(), solver.state(), 1);
  const auto adjoints = problem.solve({ResponseGradient{}}, 0.05, 30);
  for (const auto& body : adjoints[0].displacement) {
    for (const double z : body) EXPECT_EQ(z, 0.0);
  }
}

}  // namespace
}  // namespace harmos::latin
