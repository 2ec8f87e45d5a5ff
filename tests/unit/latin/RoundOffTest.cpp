#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <harmos/latin/LatinSolver.hpp>
#include <harmos/latin/PairFields.hpp>
#include <harmos/latin/detail/RoundOff.hpp>
#include <harmos/substructure/MultigridLibrary.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

/// Two cubes glued to each other, the lower one glued to a ground that moves by `way` along x; 4 N pull at the top.
BoxAssembly carried(double way) {
  BoxAssembly cubes({{"lower", {0, 0, 0}, {2, 2, 2}, {2, 2, 2}}, {"upper", {0, 0, 2}, {2, 2, 4}, {2, 2, 2}}});
  cubes.hold("ground", "lower_zmin", laws::makeLaw("Prescribed Displacement", {{"X", way}, {"Y", 0.0}, {"Z", 0.0}}));
  cubes.join("joint", "lower_zmax", "upper_zmin", laws::makeLaw("Perfect", {}));
  cubes.hold("top", "upper_zmax", laws::makeLaw("Prescribed Traction", {{"X", 0.5}, {"Z", 1.0}}));
  return cubes;
}

struct Pull {
  LatinResult result;
  double error;  // of the force through the joint
};

Pull pull(double way, bool recentres, double accuracy) {
  BoxAssembly cubes = carried(way);
  base::Timers timers;
  LatinOptions options;
  options.accuracy = accuracy;
  options.recentres = recentres;
  LatinSolver solver(cubes.assembly(), options, self(), timers);
  solver.addResponse(
      std::make_shared<ResultantResponse>("pull", std::vector<int>{1}, std::vector<base::Vector3>{{0.0, 0.0, 1.0}}));
  Pull pull{solver.solve(), 0.0};
  pull.error = std::abs(pull.result.responses[0].values[0] / 4.0 - 1.0);
  return pull;
}

// In the equations of whole displacements the stiffness adds up terms of 1e9 N.
TEST(RoundOff, LeavesTheForcesOfBodiesThatAreCarriedFar) {
  const Pull centred = pull(1e6, true, 1e-9);
  EXPECT_EQ(centred.result.outcome, Outcome::certified) << centred.result.reason;
  EXPECT_LT(centred.error, 1e-11);
  EXPECT_GT(pull(1e6, false, 1e-9).error, 1e-9);
}

TEST(RoundOff, RefusesWhatDoublePrecisionDoesNotGive) {
  const Pull whole = pull(1e6, false, 1e-9);
  EXPECT_EQ(whole.result.outcome, Outcome::roundOff) << whole.result.reason;
  EXPECT_NE(whole.result.reason.find("double precision"), std::string::npos) << whole.result.reason;
  EXPECT_NE(whole.result.reason.find("\"lower\"") == std::string::npos,
            whole.result.reason.find("\"upper\"") == std::string::npos)
      << whole.result.reason;
  EXPECT_GT(whole.result.roundOffEstimate, whole.error);
}

/// The way of the end of a beam that is held at its other end, so many times as long as thick, under 1 N across.
LatinResult bend(int length, double accuracy) {
  const double end = length;
  BoxAssembly beam({{"beam", {0, 0, 0}, {1, 1, end}, {1, 1, length}}});
  beam.hold("wall", "beam_zmin", laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}));
  beam.hold("load", "beam_zmax", laws::makeLaw("Prescribed Traction", {{"X", 1.0}}));
  base::Timers timers;
  LatinOptions options;
  options.accuracy = accuracy;
  LatinSolver solver(beam.assembly(), options, self(), timers);
  const std::vector<DisplacementResponse::Node> corner{{0, 4 * length, 1.0}};
  solver.addResponse(std::make_shared<DisplacementResponse>("end", corner, base::Vector3{1.0, 0.0, 0.0}));
  return solver.solve();
}

// Ways are those of the same finite elements, solved with 50 digits.
TEST(RoundOff, OfASlenderPartIsNotAboveItsEstimate) {
  const LatinResult result = bend(400, 1e-4);
  ASSERT_EQ(result.outcome, Outcome::certified) << result.reason;
  const double error = std::abs(result.responses[0].values[0] / 166353.880867277 - 1.0);
  EXPECT_GT(error, 1e-8);
  EXPECT_LT(error, result.roundOffEstimate);
}

// Its factor errs by less than its entries would if all of them were off alike.
TEST(RoundOff, OfAShorterPartIsNotOverestimated) {
  const LatinResult result = bend(40, 1e-8);
  ASSERT_EQ(result.outcome, Outcome::certified) << result.reason;
  const double error = std::abs(result.responses[0].values[0] / 166.01261695171 - 1.0);
  EXPECT_LT(error, result.roundOffEstimate);
}

void iterate(FixedPoint& fixedPoint, int times, base::Matrix& alpha, base::Matrix& image) {
  for (int i = 0; i < times; ++i) {
    fixedPoint.apply(alpha, image);
    alpha.assign(image);
  }
}

TEST(RoundOff, IsNotLookedForWhereItCannotMatter) {
  BoxAssembly cubes = carried(0.0);
  base::Timers timers;
  FixedPoint fixedPoint(cubes.assembly(), {}, self(), timers);
  base::Matrix alpha(fixedPoint.layout().rows(), 1), image(alpha);
  iterate(fixedPoint, 30, alpha, image);
  const std::vector<std::shared_ptr<const Response>> none;
  EXPECT_FALSE(RoundOff(fixedPoint, none).mayMatter(fixedPoint.apply(alpha, image), 1e-3));
  EXPECT_TRUE(RoundOff(fixedPoint, none).mayMatter(fixedPoint.apply(alpha, image), 1e-12));
}

// A block on springs that are far softer than what presses it is held by nothing else: round-off in its forces moves
// it.
TEST(RoundOff, IsLookedForWhereSpringsHardlyHoldABody) {
  const auto mayMatter = [](double stiffness) {
    BoxAssembly block({{"block", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}});
    block.hold("ground", "block_zmin",
               laws::makeLaw("Elastic Foundation", {{"Normal Stiffness", 10.0}, {"Tangential Stiffness", stiffness}}));
    block.hold("load", "block_zmax", laws::makeLaw("Prescribed Traction", {{"Z", -1.0}}));
    base::Timers timers;
    FixedPoint fixedPoint(block.assembly(), {}, self(), timers);
    base::Matrix alpha(fixedPoint.layout().rows(), 1), image(alpha);
    const std::vector<std::shared_ptr<const Response>> none;
    return RoundOff(fixedPoint, none).mayMatter(fixedPoint.apply(alpha, image), 1e-4);
  };
  EXPECT_FALSE(mayMatter(10.0));
  EXPECT_TRUE(mayMatter(1e-7));
}

// Displacements are counted from motions and small; those that a draw leaves are not.
TEST(RoundOff, DrawsDoNotAddUp) {
  constexpr int count = 60;
  std::vector<mesh::Box> boxes;
  for (int i = 0; i < count; ++i) boxes.push_back({std::to_string(i), {0, 0, 1.0 * i}, {1, 1, 1.0 + i}, {1, 1, 1}});
  BoxAssembly mast(boxes);
  mast.hold("ground", "0_zmin", laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}));
  for (int i = 1; i < count; ++i) {
    mast.join("joint " + std::to_string(i), std::to_string(i - 1) + "_zmax", std::to_string(i) + "_zmin",
              laws::makeLaw("Perfect", {}));
  }
  mast.hold("top", std::to_string(count - 1) + "_zmax", laws::makeLaw("Prescribed Traction", {{"X", 1.0}}));
  base::Timers timers;
  FixedPoint fixedPoint(mast.assembly(), {}, self(), timers);
  base::Matrix alpha(fixedPoint.layout().rows(), 1), image(alpha);
  iterate(fixedPoint, 60, alpha, image);
  fixedPoint.recentre(fixedPoint.apply(alpha, image), alpha);
  const auto largestForce = [&] {
    const std::vector<double>& forces = fixedPoint.linearStage().operators().perturbation();
    return *std::max_element(forces.begin(), forces.end());
  };
  fixedPoint.apply(alpha, image);
  fixedPoint.perturb(0, 16384.0);
  const double first = largestForce();
  fixedPoint.unperturb();
  const std::vector<std::shared_ptr<const Response>> none;
  RoundOff(fixedPoint, none).estimate(fixedPoint.apply(alpha, image), alpha, 1e-12);
  EXPECT_LT(largestForce(), 4.0 * first);
}

TEST(RoundOff, ExperimentLeavesNoTrace) {
  BoxAssembly cubes = carried(3.0);
  base::Timers timers;
  FixedPoint fixedPoint(cubes.assembly(), {}, self(), timers);
  base::Matrix alpha(fixedPoint.layout().rows(), 1), before(alpha), during(alpha), after(alpha);
  randomize(alpha);
  fixedPoint.apply(alpha, before);
  fixedPoint.perturb(1, 1e6);
  fixedPoint.apply(alpha, during);
  fixedPoint.unperturb();
  fixedPoint.apply(alpha, after);
  const double change = fixedPoint.metric().distance(during, before);
  EXPECT_GT(change, 1e-12 * fixedPoint.metric().norm(before));
  EXPECT_LT(change, 1e-6 * fixedPoint.metric().norm(before));
  EXPECT_EQ(fixedPoint.metric().distance(after, before), 0.0);
}

/// The force through the joint of the two cubes, of more than a thousand unknowns each so that they are not solved on
/// their coarsest level at once, by iterations of this tolerance; its error is that beside factors.
Pull iterated(double tolerance, double accuracy) {
  Pull pulls[2];
  for (const bool iterates : {false, true}) {
    BoxAssembly cubes({{"lower", {0, 0, 0}, {2, 2, 2}, {8, 8, 8}}, {"upper", {0, 0, 2}, {2, 2, 4}, {8, 8, 8}}});
    cubes.hold("ground", "lower_zmin", laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}));
    cubes.join("joint", "lower_zmax", "upper_zmin", laws::makeLaw("Perfect", {}));
    cubes.hold("top", "upper_zmax", laws::makeLaw("Prescribed Traction", {{"X", 0.5}, {"Z", 1.0}}));
    for (substructure::Substructure& body : cubes.assembly().bodies) body.iterates = iterates;
    base::Timers timers;
    LatinOptions options;
    options.accuracy = iterates ? accuracy : 1e-10;
    options.maximumIterations = 200;
    options.stages.solver.iterationTolerance = tolerance;
    LatinSolver solver(cubes.assembly(), options, self(), timers);
    solver.addResponse(
        std::make_shared<ResultantResponse>("pull", std::vector<int>{1}, std::vector<base::Vector3>{{0.0, 0.0, 1.0}}));
    pulls[iterates ? 1 : 0].result = solver.solve();
  }
  const double exact = pulls[0].result.responses[0].values[0];
  pulls[1].error = std::abs(pulls[1].result.responses[0].values[0] / exact - 1.0);
  return pulls[1];
}

// It is looked for and small; of iterations that are too coarse for an accuracy nothing is claimed.
TEST(RoundOff, OfIterationsIsWhatTheyLeave) {
  if (!substructure::hasMultigrid()) GTEST_SKIP() << "built without MueLu";
  const Pull fine = iterated(1e-12, 1e-8);
  EXPECT_EQ(fine.result.outcome, Outcome::certified) << fine.result.reason;
  EXPECT_LT(fine.error, 1e-8);
  EXPECT_GT(fine.result.roundOffEstimate, 0.0);
  const Pull coarse = iterated(1e-6, 1e-9);
  EXPECT_NE(coarse.result.outcome, Outcome::certified) << coarse.error;
}

/// Cubes with friction between them on springs, two load steps, pushed at the top.
BoxAssembly rubbing() {
  BoxAssembly cubes({{"lower", {0, 0, 0}, {2, 2, 2}, {2, 2, 2}}, {"upper", {0, 0, 2}, {2, 2, 4}, {2, 2, 2}}}, 2);
  cubes.hold("bottom", "lower_zmin",
             laws::makeLaw("Elastic Foundation", {{"Normal Stiffness", 50.0}, {"Tangential Stiffness", 20.0}}));
  cubes.hold("side", "lower_xmin", laws::makeLaw("Symmetry", {}));
  cubes.join("joint", "lower_zmax", "upper_zmin", laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}));
  cubes.hold("top", "upper_zmax",
             laws::makeLaw("Prescribed Displacement", {{"X", 0.3}, {"Y", 0.1}, {"Z", -0.2}}, {{"X", {0, 0.4, 1}}}));
  return cubes;
}

// T of states that are counted from the motions of bodies is T of whole states, counted from them.
TEST(ReferenceMotions, ChangeNothingButWhereDisplacementsAreCountedFrom) {
  BoxAssembly cubes = rubbing();
  base::Timers timers;
  FixedPoint fixedPoint(cubes.assembly(), {}, self(), timers);
  base::Matrix alpha(fixedPoint.layout().rows(), 2), image(alpha), relativeImage(alpha);
  randomize(alpha);
  const Iterate& whole = fixedPoint.apply(alpha, image);
  const base::Matrix trace(whole.trace()), hattedTrace(whole.hattedTrace()), traction(whole.hattedTraction());
  const PairFields pairs = pairFields(whole, 2), boundary = pairFields(whole, 0);
  base::Matrix relative(alpha);
  fixedPoint.recentre(whole, relative);
  const Iterate& counted = fixedPoint.apply(relative, relativeImage);
  EXPECT_LT(counted.relativeTrace().normInf(), 0.8 * trace.normInf());
  fixedPoint.addReference(relative);
  fixedPoint.addReference(relativeImage);
  const auto expectEqual = [](const base::Matrix& a, const base::Matrix& b) {
    base::Matrix difference(a);
    difference -= b;
    EXPECT_LT(difference.normInf(), 1e-11 * b.normInf());
  };
  expectEqual(relative, alpha);
  expectEqual(relativeImage, image);
  expectEqual(counted.trace(), trace);
  expectEqual(counted.hattedTrace(), hattedTrace);
  for (int t = 0; t < trace.numCols(); ++t) {
    for (int row = 0; row < trace.numRows(); ++row) {
      const double between = counted.relativeTrace()[t][row] - counted.relativeHattedTrace(row, t);
      EXPECT_NEAR(between, trace[t][row] - hattedTrace[t][row], 1e-11 * trace.normInf());
    }
  }
  expectEqual(counted.hattedTraction(), traction);
  for (const auto& [now, then] :
       {std::pair(pairFields(counted, 2), pairs), std::pair(pairFields(counted, 0), boundary)}) {
    for (std::size_t i = 0; i < then.jump.size(); ++i) {
      EXPECT_LT(base::distance(now.jump[i], then.jump[i]), 1e-11);
      EXPECT_LT(base::distance(now.traction[i], then.traction[i]), 1e-8);
    }
  }
}

TEST(ReferenceMotions, AreThoseOfBodiesThatMoveRigidly) {
  BoxAssembly cubes = carried(0.0);
  base::Timers timers;
  FixedPoint fixedPoint(cubes.assembly(), {}, self(), timers);
  const TraceLayout& layout = fixedPoint.layout();
  base::Matrix trace(layout.rows(), 1);
  const base::Vector3 way{3e5, -2e4, 1e5}, turn{4e4, 5e5, -6e3};
  for (const TraceLayout::Block& block : layout.blocks()) {
    const mesh::TraceOperator& points = cubes.assembly().interfaces[block.interface].trace(block.side);
    for (int p = 0; p < block.pairs; ++p) {
      const base::Vector3 u = way + base::cross(turn, points.at(p, cubes.assembly().bodies[block.body].nodes));
      for (int c = 0; c < 3; ++c) trace(block.begin + 3 * p + c, 0) = u[c];
    }
  }
  ReferenceMotions motions(cubes.assembly());
  EXPECT_TRUE(motions.isEmpty());
  motions.add(trace, layout);
  const int far = static_cast<int>(cubes.assembly().bodies[1].nodes.size()) - 1;
  const base::Vector3 u = way + base::cross(turn, cubes.assembly().bodies[1].nodes[far]);
  EXPECT_LT(base::distance(motions.at(1, far, 0), u), 1e-9 * base::norm(u));
  for (int pair = 0; pair < 9; ++pair) {
    EXPECT_LT(base::norm(motions.jump(cubes.assembly().interfaces[1], pair, 0)), 1e-9 * base::norm(u));
  }
  EXPECT_LT(base::norm(motions.below(u, 1, far, 0)), 1e-9 * base::norm(u));
}

}  // namespace
}  // namespace harmos::latin
