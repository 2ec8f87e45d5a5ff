#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/scene/ProblemCost.hpp>
#include <harmos/substructure/FactorPrediction.hpp>
#include <harmos/substructure/MultigridLibrary.hpp>

#include "Sample.hpp"

namespace harmos::scene {
namespace {

std::string refusal(const CostEstimate& cost, double freeBytes) {
  try {
    demandCapacity(cost, freeBytes);
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    return error.what();
  }
  return "";
}

TEST(CostEstimate, OfARunIsTheSumOfItsPhases) {
  CostEstimate cost;
  cost.startSeconds = 0.125;
  cost.factorSeconds = 0.25;
  cost.staticsSeconds = 2.0;
  cost.stageSeconds = 0.5;
  cost.stages = 24.0;
  cost.correctionSeconds = 4.0;
  cost.wholeSeconds = 8.0;
  cost.meshErrorSeconds = 0.75;
  cost.fileSeconds = 0.25;
  EXPECT_DOUBLE_EQ(cost.seconds(), 0.125 + 0.25 + 2.0 + 12.0 + 4.0 + 8.0 + 1.0);
  // The certificate solves all load steps together, and compares states by all responses.
  cost.certificateStages = 8.0;
  cost.togetherSeconds = 0.25;
  cost.responseSeconds = 0.5;
  cost.boundarySeconds = 0.5;
  EXPECT_DOUBLE_EQ(cost.seconds(), 0.125 + 0.25 + 2.0 + 10.0 + 4.0 + 8.0 + 5.0 + 1.0);
  // Whether large parts are cut is asked once, and each of five times the displacements of whole parts are needed.
  cost.cuttingSeconds = 0.5;
  cost.lookSeconds = 1.0;
  EXPECT_DOUBLE_EQ(cost.seconds(), 0.125 + 0.5 + 0.25 + 2.0 + 10.0 + 4.0 + 8.0 + 10.0 + 1.0);
}

// A single column reads a factor faster than several can be worked on, which read it together, 64 of them at once.
TEST(CostEstimate, SolvesForManyColumnsReadAFactorOnce) {
  const SolveSeconds one{1.0, 2.0, 0.125}, both = one + 2.0 * one;
  EXPECT_DOUBLE_EQ(one.seconds(1.0), 1.0);
  EXPECT_DOUBLE_EQ(one.seconds(8.0), 3.0);
  EXPECT_DOUBLE_EQ(one.seconds(64.0), 10.0);
  EXPECT_DOUBLE_EQ(one.seconds(65.0), 4.0 + 65.0 / 8.0);
  EXPECT_DOUBLE_EQ(both.seconds(8.0), 9.0);
}

// Every response is counted; those of stress recover it in all parts, and the space for that is taken once.
TEST(CostEstimate, CountsResponses) {
  const auto comm = Tpetra::getDefaultComm();
  base::Timers timers;
  const auto costWith = [&](int stresses) {
    std::string text = sampleScene(), more;
    for (int i = 0; i < stresses; ++i) {
      more += "<ParameterList name=\"stress " + std::to_string(i) +
              "\"><Parameter name=\"Type\" type=\"string\" value=\"Von Mises Stress\"/></ParameterList>";
    }
    const std::string list = "<ParameterList name=\"Responses\">";
    text.insert(text.find(list) + list.size(), more);
    const Scene scene =
        makeScene(input::InputTree::fromText(text, "sample.xml"), "sample.xml", {}, laws::builtInLaws());
    return estimateCost(makeProblem(scene, *comm, timers), scene.solver, FactorSizes::fromOrder, *comm);
  };
  const CostEstimate none = costWith(0), one = costWith(1), three = costWith(3);
  EXPECT_EQ(one.responses, none.responses + 1.0);
  EXPECT_GT(one.responseSeconds, 5.0 * none.responseSeconds);
  EXPECT_NEAR(three.responseSeconds - none.responseSeconds, 3.0 * (one.responseSeconds - none.responseSeconds), 1e-12);
  EXPECT_GT(one.processBytes, none.processBytes);
  EXPECT_EQ(three.processBytes, one.processBytes);
}

// What converges slowly to the usual accuracy goes on as slowly.
TEST(CostEstimate, TakesStagesInProportionWithTheAccuracy) {
  const auto comm = Tpetra::getDefaultComm();
  base::Timers timers;
  const Scene scene = sample();
  const Problem problem = makeProblem(scene, *comm, timers);
  const auto stagesTo = [&](double accuracy) {
    latin::LatinOptions options = scene.solver;
    options.accuracy = accuracy;
    const CostEstimate cost = estimateCost(problem, options, FactorSizes::fromUnknowns, *comm);
    return cost.stages - cost.otherStages;
  };
  const double usual = stagesTo(1e-3);
  EXPECT_NEAR(stagesTo(1e-8) - stagesTo(1e-7), stagesTo(1e-4) - usual, 1e-9);
  EXPECT_GT(stagesTo(1e-8), 1.5 * usual);
  EXPECT_LT(stagesTo(1e-2), usual);
}

// Loads that boundaries prescribe as displacements are solved for like forces, and multiplied by the stiffness besides.
TEST(CostEstimate, CountsPrescribedDisplacementsAmongLoads) {
  const auto comm = Tpetra::getDefaultComm();
  base::Timers timers;
  const auto costOf = [&](const std::string& depth) {
    const Scene scene = sample({"Boundaries/fixed/Law/Z=" + depth});
    return estimateCost(makeProblem(scene, *comm, timers), scene.solver, FactorSizes::fromOrder, *comm);
  };
  EXPECT_GT(costOf("-0.01").loadSeconds, costOf("0").loadSeconds);
  EXPECT_GT(costOf("-0.01").processBytes, costOf("0").processBytes);
}

// Of the shipped joint, 7956 interface unknowns and 11 load steps, the derivatives by its friction take 25 MB, and 3.2
// CPU s at the speed of the rates; by three numbers 43 MB and 7.5 s.
TEST(CostEstimate, CountsDerivatives) {
  CostEstimate cost;
  cost.interfaceUnknowns = 7956;
  cost.steps = 11;
  cost.columnSeconds = 0.012 / cost.steps;
  cost.directionsOfStep = 72.0;
  CostEstimate byThree = cost;
  cost.addDerivatives(0);
  EXPECT_EQ(cost.processBytes, 0.0);
  EXPECT_EQ(cost.seconds(), 0.0);
  const auto isNear = [](double said, double taken) { return said > taken / 1.5 && said < taken * 1.5; };
  cost.addDerivatives(1);
  EXPECT_PRED2(isNear, cost.processBytes, 25e6);
  EXPECT_PRED2(isNear, cost.seconds(), 3.2);
  byThree.addDerivatives(3);
  EXPECT_PRED2(isNear, byThree.processBytes, 43e6);
  EXPECT_PRED2(isNear, byThree.seconds(), 7.5);
}

TEST(CostEstimate, RefusesFactorsBeyondTheNumbersOfSolvers) {
  CostEstimate cost;
  cost.largestBody = "block";
  cost.largestFactor = 2147483647.0;
  EXPECT_EQ(refusal(cost, 1e9), "");
  cost.largestFactor *= 2.0;
  const std::string said = refusal(cost, 1e9);
  EXPECT_NE(said.find("part \"block\""), std::string::npos) << said;
  // 2 x 2^(3/4) = 3.4: pieces have factors of a third of the limit, as entries grow with the unknowns to the 4/3.
  EXPECT_NE(said.find("value=\"4\""), std::string::npos) << said;
}

TEST(CostEstimate, RefusesWhatWillNotFitByAMargin) {
  CostEstimate cost;
  cost.processBytes = 1.4e9;
  EXPECT_EQ(refusal(cost, 1e9), "");
  cost.processBytes = 1.6e9;
  EXPECT_NE(refusal(cost, 1e9).find("1.6 GB, of which 1 GB are free"), std::string::npos) << refusal(cost, 1e9);
}

// Of two equal boxes one is held, so that they have one matrix but two factors; the trace of each are the nine nodes of
// the joint, for what is held or pressed has no unknowns there.
TEST(CostEstimate, CountsTracesInBothPrecisionsWhereTheyAreInverted) {
  const auto comm = Tpetra::getDefaultComm();
  base::Timers timers;
  const Scene scene = sample();
  const Problem problem = makeProblem(scene, *comm, timers);
  latin::LatinOptions options = scene.solver;
  const CostEstimate plain = estimateCost(problem, options, FactorSizes::fromOrder, *comm);
  options.stages.solver.invertTrace = true;
  const CostEstimate inverted = estimateCost(problem, options, FactorSizes::fromOrder, *comm);
  EXPECT_EQ(plain.inverseBytes, 0.0);
  EXPECT_EQ(inverted.inverseBytes, 2.0 * (8.0 + 4.0) * 27.0 * 27.0 / 2.0);  // of a triangle
  EXPECT_GE(inverted.processBytes, plain.processBytes + inverted.inverseBytes);
}

// Without a load a part keeps no fields of its loads.
TEST(CostEstimate, CountsFieldsOfLoadsForEveryLoadStep) {
  const auto comm = Tpetra::getDefaultComm();
  base::Timers timers;
  const Scene scene = sample();
  Problem problem = makeProblem(scene, *comm, timers);
  const auto costOf = [&] { return estimateCost(problem, scene.solver, FactorSizes::fromOrder, *comm); };
  const CostEstimate loaded = costOf();
  assembly::Assembly& assembly = problem.assembly;
  double fields = 0.0;
  for (std::size_t i = assembly.interfaces.size(); i-- > 0;) {
    if (!assembly.interfaces[i].law->prescribesTraction()) continue;
    fields += assembly.dimension * static_cast<double>(assembly.bodies[assembly.interfaces[i].body1].nodes.size());
    assembly.interfaces.erase(assembly.interfaces.begin() + static_cast<std::ptrdiff_t>(i));
  }
  ASSERT_GT(fields, 0.0);
  EXPECT_GE(loaded.processBytes - costOf().processBytes, 8.0 * fields * assembly.steps());
  EXPECT_GT(loaded.factorSeconds, costOf().factorSeconds);
}

TEST(CostEstimate, KnowsSolversWithoutSupernodesAndWhatVelocitiesTake) {
  const auto comm = Tpetra::getDefaultComm();
  base::Timers timers;
  const Scene scene = sample();
  Problem problem = makeProblem(scene, *comm, timers);
  latin::LatinOptions options = scene.solver;
  const CostEstimate usual = estimateCost(problem, options, FactorSizes::fromUnknowns, *comm);
  options.stages.solver.name = "KLU2";
  const CostEstimate plain = estimateCost(problem, options, FactorSizes::fromUnknowns, *comm);
  EXPECT_GT(plain.factorBytes, 2.0 * usual.factorBytes);
  EXPECT_EQ(plain.singleBytes, 0.0);
  EXPECT_GT(plain.factorSeconds, 2.0 * usual.factorSeconds);
  problem.assembly.times.resize(40);
  const double ofDisplacements = estimateCost(problem, options, FactorSizes::fromUnknowns, *comm).stages;
  options.stages.formulation = latin::Formulation::velocity;
  EXPECT_GT(estimateCost(problem, options, FactorSizes::fromUnknowns, *comm).stages, 2.0 * ofDisplacements);
}

TEST(CostEstimate, OfPartsSolvedIterativelyCountsNoFactor) {
  if (!substructure::hasMultigrid()) GTEST_SKIP() << "built without MueLu";
  const auto comm = Tpetra::getDefaultComm();
  base::Timers timers;
  const Scene scene = sample({"Parts/lower/Linear Solver=Iterative", "Parts/upper/Linear Solver=Iterative"});
  const Problem problem = makeProblem(scene, *comm, timers);
  const CostEstimate cost = estimateCost(problem, scene.solver, FactorSizes::fromOrder, *comm);
  EXPECT_EQ(cost.factorBytes, 0.0);
  EXPECT_EQ(cost.largestFactor, 0.0);
  EXPECT_GT(cost.iteratedBytes, cost.matrixBytes);
  EXPECT_GT(cost.stageSeconds, 0.0);
}

// Of many load steps the vectors of a few are kept at a time: eight times as many steps take far less than eight times
// the memory, and fields of all of them grow with the steps.
TEST(CostEstimate, OfManyLoadStepsCountsVectorsOfSome) {
  const auto comm = Tpetra::getDefaultComm();
  base::Timers timers;
  const Scene scene = sample();
  const auto fieldsOf = [&](int steps) {
    Problem problem = makeProblem(scene, *comm, timers);
    problem.assembly.times.resize(steps);
    for (substructure::Substructure& body : problem.assembly.bodies) {
      if (body.loads.numCols() > 0) body.loads.reshape(body.loads.numRows(), steps);
    }
    return estimateCost(problem, scene.solver, FactorSizes::fromOrder, *comm).fieldBytes;
  };
  EXPECT_GT(fieldsOf(64), 32.0 * fieldsOf(1));
  EXPECT_LE(fieldsOf(64), 64.0 * fieldsOf(1));
  EXPECT_LT(fieldsOf(512), 3.0 * fieldsOf(64));
  EXPECT_GT(fieldsOf(1024), 1.2 * fieldsOf(512));
}

std::string refusalOfMesh(const std::vector<std::string>& overrides, double freeBytes) {
  try {
    demandRoomForMesh(sample(overrides), freeBytes);
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    return error.what();
  }
  return "";
}

// A billion nodes: nobody makes them to see that they do not fit.
TEST(CostEstimate, RefusesAMeshBeforeItIsMade) {
  const std::string huge = "Mesh/Boxes/lower/Cells={1000,1000,1000}";
  EXPECT_NE(refusalOfMesh({huge}, 1e12).find("a mesh of about 1e+09 nodes"), std::string::npos)
      << refusalOfMesh({huge}, 1e12);
  EXPECT_NE(refusalOfMesh({"Mesh/Boxes/lower/Cells={125,125,125}", "Mesh/Refine=3"}, 1e12), "");
  EXPECT_NE(refusalOfMesh({"Mesh/Boxes/lower/Cells={700,700,700}", "Mesh/Order=2"}, 6e12), "");
  EXPECT_EQ(refusalOfMesh({"Mesh/Boxes/lower/Cells={700,700,700}"}, 6e12), "");
  EXPECT_EQ(refusalOfMesh({}, 1e9), "");
}

// What is refused before a mesh is made is less than what is said of the mesh that is made.
TEST(CostEstimate, OfAMeshIsMoreThanWhatItTakesAtLeast) {
  const auto comm = Tpetra::getDefaultComm();
  base::Timers timers;
  for (const char* const element : {"Hex8", "Hex20", "Hex27", "Tet4", "Tet10"}) {
    SCOPED_TRACE(element);
    const Scene scene = sample({"Mesh/Boxes/lower/Cells={12,12,12}", "Mesh/Boxes/upper/Cells={12,12,6}",
                                std::string("Mesh/Boxes/lower/Element=") + element});
    const double taken =
        estimateCost(makeProblem(scene, *comm, timers), scene.solver, FactorSizes::fromOrder, *comm).processBytes;
    EXPECT_NO_THROW(demandRoomForMesh(scene, taken / 1.5));
    EXPECT_THROW(demandRoomForMesh(scene, taken / 30.0), base::Error);
  }
}

// What a point sees of a face of six nodes, no element couples all across.
TEST(CostEstimate, CountsWhatPointsOfJoinedMeshesCouple) {
  const auto comm = Tpetra::getDefaultComm();
  base::Timers timers;
  const Scene scene = sample({"Mesh/Boxes/lower/Element=Tet10", "Mesh/Boxes/lower/Cells={6,6,2}",
                              "Mesh/Boxes/upper/Element=Tet10", "Mesh/Boxes/upper/Cells={5,5,2}"});
  const Problem problem = makeProblem(scene, *comm, timers);
  double uncoupled = 0.0;
  for (const substructure::Substructure& body : problem.assembly.bodies) {
    if (body.stiffness.is_null()) continue;  // of another rank
    uncoupled = std::max(uncoupled, substructure::predictFactor(*body.stiffness, {}).nonzeros);
  }
  EXPECT_GT(estimateCost(problem, scene.solver, FactorSizes::fromOrder, *comm).largestFactor, 1.05 * uncoupled);
}

}  // namespace
}  // namespace harmos::scene
