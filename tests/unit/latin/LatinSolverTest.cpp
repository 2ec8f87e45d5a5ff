#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include <harmos/base/Error.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/latin/StepsAtOnce.hpp>

#include "Chains.hpp"

namespace harmos::latin {
namespace {

// The chains give 10 and 20 per length; both together 20/3.
constexpr double left = 10.0, right = 20.0, both = left * right / (left + right);

std::shared_ptr<Response> endDisplacement() {
  return std::make_shared<DisplacementResponse>("end", std::vector<DisplacementResponse::Node>{{1, 2, 1.0}},
                                                base::Vector3{1.0, 0.0, 0.0});
}
std::shared_ptr<Response> jointForce() {
  return std::make_shared<ResultantResponse>("force", std::vector<int>{1}, std::vector<base::Vector3>{});
}

LatinOptions accurate(double accuracy = 1e-8) {
  LatinOptions options;
  options.accuracy = accuracy;
  return options;
}

LatinResult solve(const assembly::Assembly& assembly, const LatinOptions& options = accurate()) {
  base::Timers timers;
  LatinSolver solver(assembly, options, self(), timers);
  solver.addResponse(endDisplacement());
  solver.addResponse(jointForce());
  return solver.solve();
}

std::shared_ptr<const laws::InterfaceLaw> pull(double force, const std::vector<double>& history) {
  return laws::makeLaw("Prescribed Traction", {{"X", force}}, {{"X", history}});
}
std::shared_ptr<const laws::InterfaceLaw> move(double distance, const std::vector<double>& history) {
  return laws::makeLaw("Prescribed Displacement", {{"X", distance}, {"Y", 0.0}, {"Z", 0.0}}, {{"X", history}});
}

void expectValues(const LatinResult& result, std::size_t response, const std::vector<double>& exact) {
  EXPECT_EQ(result.outcome, Outcome::certified) << result.reason;
  double size = 0.0;
  for (double value : exact) size = std::max(size, std::abs(value));
  for (std::size_t t = 0; t < exact.size(); ++t)
    EXPECT_NEAR(result.responses[response].values[t], exact[t], 1e-8 * (size > 0.0 ? size : 1.0));
}

TEST(LatinSolver, SolvesSpringsInSeries) {
  const LatinResult result = solve(twoChains(laws::makeLaw("Perfect"), pull(3.0, {1, 0, -2}), 3));
  expectValues(result, 0, {3.0 / both, 0.0, -6.0 / both});
  expectValues(result, 1, {3.0, 0.0, -6.0});
  EXPECT_LE(result.errorEstimate, 1e-8);
  EXPECT_GT(result.iterations, 0);
  EXPECT_GE(result.linearStages, result.iterations);
  EXPECT_EQ(result.responses[0].name, "end");
}

// What a certificate has left at hand are the fields of the state that is delivered.
TEST(LatinSolver, DeliversTheFieldsOfItsState) {
  for (const char* law : {"Perfect", "Unilateral Contact"}) {
    const assembly::Assembly chains = twoChains(laws::makeLaw(law), pull(-3.0, {1, 0.5, 2}), 3);
    base::Timers timers;
    LatinSolver solver(chains, accurate(1e-4), self(), timers);
    solver.addResponse(endDisplacement());
    ASSERT_EQ(solver.solve().outcome, Outcome::certified);
    const base::Matrix traction(solver.state().hattedTraction()), trace(solver.state().trace());
    base::Matrix image(solver.alpha().numRows(), solver.alpha().numCols());
    const Iterate& again = solver.fixedPoint().apply(solver.alpha(), image);
    for (int t = 0; t < image.numCols(); ++t) {
      for (int row = 0; row < image.numRows(); ++row) {
        EXPECT_NEAR(traction(row, t), again.hattedTraction()(row, t), 1e-12 * 6.0);
        EXPECT_NEAR(trace(row, t), again.trace()(row, t), 1e-12 * 6.0 / both);
      }
    }
  }
}

// Of many load steps fields that are not at hand are kept in files, of which nothing is left.
TEST(LatinSolver, KeepsFieldsOfManyLoadStepsInFiles) {
  constexpr int many = 2 * stepsAtOnce + 10;
  std::vector<double> waves;
  for (int t = 0; t < many; ++t) waves.push_back(std::sin(0.3 * t) - 1.5);
  const auto scene = [&] { return twoChains(laws::makeLaw("Unilateral Contact"), pull(3.0, waves), many); };
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("harmos_latin_solver_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  LatinOptions options = accurate();
  const LatinResult inMemory = solve(scene(), options);
  options.stages.scratch = folder.string();
  const LatinResult inFiles = solve(scene(), options);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  std::filesystem::remove_all(folder);
  EXPECT_EQ(inMemory.outcome, Outcome::certified) << inMemory.reason;
  EXPECT_EQ(inFiles.outcome, inMemory.outcome);
  EXPECT_EQ(inFiles.linearStages, inMemory.linearStages);
  EXPECT_EQ(inFiles.errorEstimate, inMemory.errorEstimate);
  for (std::size_t i = 0; i < inFiles.responses.size(); ++i) {
    EXPECT_EQ(inFiles.responses[i].values, inMemory.responses[i].values);
  }
  EXPECT_THROW(solve(scene(), options), base::Error);  // the folder is gone
}

// A host may have computed them.
TEST(LatinSolver, RefusesOptionsOutOfRange) {
  const auto refuses = [](const std::string& what, const auto& spoil) {
    LatinOptions options;
    spoil(options);
    try {
      solve(twoChains(laws::makeLaw("Perfect"), pull(3.0, {1}), 1), options);
      ADD_FAILURE() << what << " was taken";
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ExitCode::input);
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  for (const double accuracy : {0.0, -1e-3, 1.0, std::nan(""), HUGE_VAL})
    refuses("accuracy is ", [&](LatinOptions& options) { options.accuracy = accuracy; });
  refuses("maximumIterations is 0", [](LatinOptions& options) { options.maximumIterations = 0; });
  refuses("memory is -1", [](LatinOptions& options) { options.memory = -1; });
  refuses("restarts is -1", [](LatinOptions& options) { options.restarts = -1; });
  refuses("relaxation is 1.5", [](LatinOptions& options) { options.relaxation = 1.5; });
  refuses("searchDirectionScale is 0", [](LatinOptions& options) { options.stages.searchDirectionScale = 0.0; });
}

TEST(LatinSolver, SolvesAGapThatCloses) {
  constexpr double gap = 0.05;
  const LatinResult result =
      solve(twoChains(laws::makeLaw("Unilateral Contact", {{"Gap", gap}}), move(-0.15, {0.2, 1.0 / 3.0, 1.0}), 3));
  expectValues(result, 1, {0.0, 0.0, -both * (0.15 - gap)});
}

TEST(LatinSolver, SolvesAPreload) {
  const LatinResult result =
      solve(twoChains(laws::makeLaw("Preload Jump", {{"Jump", 0.2}}, {{"Jump", {0.5, 1.0}}}), move(0.0, {1, 1}), 2));
  expectValues(result, 1, {0.1 * both, 0.2 * both});
}

TEST(LatinSolver, SolvesGlue) {
  const double glue = 40.0;
  const LatinResult result = solve(twoChains(
      laws::makeLaw("Linear Elastic", {{"Normal Stiffness", glue}, {"Tangential Stiffness", 1.0}}), pull(2.0, {1}), 1));
  expectValues(result, 0, {2.0 / both + 2.0 / glue});
}

// A node pressed by 1 and dragged to and fro, as a Jenkins element: friction 0.3 behind a spring of left + right.
TEST(LatinSolver, SolvesFrictionOnTheWayBack) {
  constexpr double friction = 0.3;
  assembly::Assembly assembly =
      twoChains(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", friction}}),
                laws::makeLaw("Prescribed Displacement", {{"X", -1.0 / both}, {"Y", 0.1}, {"Z", 0.0}},
                              {{"Y", {0.2, 1.0, 0.8, -1.0}}}),
                4);
  base::Timers timers;
  LatinSolver solver(assembly, accurate(), self(), timers);
  const auto shear =
      std::make_shared<ResultantResponse>("shear", std::vector<int>{1}, std::vector<base::Vector3>{{0.0, 1.0, 0.0}});
  solver.addResponse(shear);
  const LatinResult result = solver.solve();
  // Stick: both * way = 0.133; slip at 0.3; from there back by 0.02: 0.3 - 0.133; slip the other way.
  expectValues(result, 0, {both * 0.02, friction, friction - both * 0.02, -friction});
}

TEST(LatinSolver, AgreesWithItselfInEveryFormAndAlgorithm) {
  const auto joint = [] { return laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}); };
  const auto end = [] {
    return laws::makeLaw("Prescribed Displacement", {{"X", -0.15}, {"Y", 0.1}, {"Z", 0.0}}, {{"Y", {0.2, 1.0, -1.0}}});
  };
  const LatinResult exact = solve(twoChains(joint(), end(), 3));
  for (Formulation formulation : {Formulation::displacement, Formulation::velocity}) {
    for (Algorithm algorithm : {Algorithm::accelerated, Algorithm::plain, Algorithm::relaxed}) {
      for (bool withMacroProblem : {false, true}) {
        LatinOptions options = accurate();
        options.stages.formulation = formulation;
        options.stages.macroProblem = withMacroProblem;
        options.algorithm = algorithm;
        const LatinResult result = solve(twoChains(joint(), end(), 3), options);
        SCOPED_TRACE("formulation " + std::to_string(static_cast<int>(formulation)) + ", algorithm " +
                     std::to_string(static_cast<int>(algorithm)) + ", macro problem " +
                     std::to_string(withMacroProblem));
        // The plain iteration may jump to and fro for ever; then it must say so.
        if (algorithm == Algorithm::plain && result.outcome == Outcome::iterationLimit) continue;
        expectValues(result, 0, exact.responses[0].values);
        expectValues(result, 1, exact.responses[1].values);
      }
    }
  }
}

TEST(LatinSolver, DoesNotCareWhichSideIsOne) {
  assembly::Assembly swapped =
      twoChains(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}), move(-0.15, {1.0}), 1);
  assembly::Interface& joint = swapped.interfaces[1];
  std::swap(joint.body1, joint.body2);
  std::swap(joint.trace1, joint.trace2);
  joint.frame[0] = {{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}};
  expectValues(solve(swapped), 1, {-both * 0.15});
}

TEST(LatinSolver, KnowsNoUnits) {
  const auto joint = [](double gap) { return laws::makeLaw("Unilateral Contact", {{"Gap", gap}}); };
  const LatinResult millimetres = solve(twoChains(joint(0.05), move(-0.15, {1.0}), 1));
  assembly::Assembly assembly = twoChains(joint(0.05e-3), move(-0.15e-3, {1.0}), 1);
  assembly.bodies = {chain("left", 0.0, 4, 30e3), chain("right", 3.0, 3, 40e3)};
  for (auto& body : assembly.bodies) {
    for (auto& node : body.nodes) node[0] *= 1e-3;
  }
  for (auto& interface : assembly.interfaces) interface.area[0] *= 1e-6;
  const LatinResult metres = solve(assembly);
  EXPECT_EQ(metres.iterations, millimetres.iterations);
  EXPECT_EQ(metres.linearStages, millimetres.linearStages);
  EXPECT_NEAR(metres.responses[1].values[0], millimetres.responses[1].values[0], 1e-10);
}

TEST(LatinSolver, StartsFromAnEarlierState) {
  const assembly::Assembly assembly =
      twoChains(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}), move(-0.15, {0.5, 1.0}), 2);
  base::Timers timers;
  LatinSolver cold(assembly, accurate(), self(), timers);
  cold.addResponse(jointForce());
  const LatinResult first = cold.solve();
  LatinSolver warm(assembly, accurate(), self(), timers);
  warm.addResponse(jointForce());
  const LatinResult second = warm.solve(&cold.alpha());
  expectValues(second, 0, {-both * 0.075, -both * 0.15});
  EXPECT_LE(second.iterations, first.iterations);
  // The same solver once more: its counts start again.
  const LatinResult third = cold.solve();
  EXPECT_EQ(third.iterations, first.iterations);
  EXPECT_EQ(third.linearStages, first.linearStages);
}

TEST(LatinSolver, GoesOnFromItsOwnState) {
  const assembly::Assembly assembly =
      twoChains(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}), move(-0.15, {0.5, 1.0}), 2);
  base::Timers timers;
  LatinSolver solver(assembly, accurate(), self(), timers);
  solver.addResponse(jointForce());
  expectValues(solver.solve(&solver.alpha()), 0, {-both * 0.075, -both * 0.15});
  const base::Matrix copy(solver.alpha());
  LatinSolver other(assembly, accurate(), self(), timers);
  other.addResponse(jointForce());
  const LatinResult fromCopy = other.solve(&copy);
  const LatinResult again = solver.solve(&solver.alpha());
  EXPECT_EQ(again.iterations, fromCopy.iterations);
  EXPECT_EQ(again.linearStages, fromCopy.linearStages);
  EXPECT_EQ(again.responses[0].values, fromCopy.responses[0].values);
}

TEST(LatinSolver, StopsWhenAsked) {
  const assembly::Assembly assembly = twoChains(laws::makeLaw("Perfect"), pull(1.0, {1}), 1);
  base::Timers timers;
  LatinSolver solver(assembly, accurate(), self(), timers);
  solver.setInterrupt([] { return true; });  // bars need but two iterations
  const LatinResult result = solver.solve();
  EXPECT_EQ(result.outcome, Outcome::interrupted);
  EXPECT_LE(result.iterations, 2);
  EXPECT_TRUE(std::isnan(result.errorEstimate));
}

TEST(LatinSolver, SaysThatTheLimitWasReached) {
  LatinOptions options = accurate();
  options.maximumIterations = 3;
  const LatinResult result = solve(
      twoChains(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}), move(-0.15, {1.0}), 1), options);
  EXPECT_EQ(result.outcome, Outcome::iterationLimit);
  EXPECT_NE(result.reason.find('3'), std::string::npos) << result.reason;
  EXPECT_TRUE(std::isnan(result.errorEstimate));
}

TEST(LatinSolver, SaysThatNothingCarriesTheLoad) {
  // The right chain pulls away from a contact.
  const LatinResult away = solve(twoChains(laws::makeLaw("Unilateral Contact"), pull(3.0, {0.5, 1}), 2));
  EXPECT_EQ(away.outcome, Outcome::noEquilibrium) << away.reason;
  EXPECT_NE(away.reason.find("\"right\""), std::string::npos) << away.reason;
  // The first load step that is not carried: half of 3.
  EXPECT_NE(away.reason.find("load step 1; part \"right\": unbalanced force (1.5"), std::string::npos) << away.reason;
}

TEST(LatinSolver, SolvesNothingAtRest) {
  const LatinResult result = solve(twoChains(laws::makeLaw("Perfect"), pull(0.0, {1, 1}), 2));
  expectValues(result, 0, {0.0, 0.0});
  EXPECT_EQ(result.errorEstimate, 0.0);
}

TEST(LatinSolver, PassesOnTheErrorOfALaw) {
  EXPECT_THROW(solve(twoChains(laws::makeLaw("Preload Jump", {{"Jump", std::nan("")}}), move(0.0, {1}), 1)),
               base::Error);
}

}  // namespace
}  // namespace harmos::latin
