#include <gtest/gtest.h>

#include <cmath>

#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/scene/MeshError.hpp>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

// Of the bolt diagram: a bolt of 420000 N/mm against columns of 1680000 N/mm, pulled apart by 0, 10, 20 and 25 kN.
constexpr double preload = 16800.0, overlap = 0.05, tolerance = 1e-5;
const std::vector<double> boltForces = {16800.0, 18800.0, 20800.0, 25000.0};

std::string pretension(double force, const std::string& more) {
  return xmlList("Law", xmlText("Type", "Pretension") + xmlNumber("Force", force) + more);
}

/// The scene of the bolt diagram with a force instead of a jump.
SceneInput boltDiagram(double force, const std::string& more) {
  SceneInput scene = SceneInput::fromFile("bolt_diagram/bolt.xml");
  scene.remove("Interfaces/preload/Law").add("Interfaces/preload", pretension(force, more));
  return scene.add("Responses", xmlList("overlap", xmlText("Type", "Overlap") + xmlText("Interface", "preload")));
}

/// The same on a plane through the shank instead of under the head, a little off the layer of faces at half the height.
SceneInput cutBolt(const std::vector<double>& normal, const std::string& more = xmlNumber("Locked From", 1.0)) {
  SceneInput scene = SceneInput::fromFile("bolt_diagram/bolt.xml");
  scene.remove("Interfaces/preload");
  scene.add("Interfaces", xmlList("preload", xmlText("Part", "bolt") + xmlNumbers("Point", {50.0, 47.0}) +
                                                 xmlNumbers("Normal", normal) + pretension(preload, more)) +
                              xmlList("thread", xmlText("Part 1", "bolt") + xmlText("Part 2", "head") +
                                                    xmlList("Law", xmlText("Type", "Perfect"))));
  return scene.add("Responses", xmlList("overlap", xmlText("Type", "Overlap") + xmlText("Interface", "preload")));
}

void expectBoltDiagram(const SceneInput& scene) {
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  for (int t = 0; t < 4; ++t) {
    EXPECT_NEAR(run.value("bolt", t), boltForces[static_cast<std::size_t>(t)], tolerance * preload) << t;
    EXPECT_NEAR(run.value("overlap", t), overlap, tolerance * overlap) << t;
  }
  EXPECT_NEAR(run.value("opening", 3), 4000.0 / 420000.0, tolerance * 4000.0 / 420000.0);
}

TEST(Pretension, LocksWhatTheForceHasDrawnTogether) {
  expectBoltDiagram(boltDiagram(preload, xmlNumber("Locked From", 1.0)));
}

// The cut through the bolt lies on several pieces, which share one overlap on any number of ranks.
TEST(RanksPretension, IsOneOverAllPieces) {
  SceneInput scene = boltDiagram(preload, xmlNumber("Locked From", 1.0));
  scene.set("Parts/bolt/Pieces=2").set("Parts/head/Pieces=2");
  expectBoltDiagram(scene);
}

TEST(RanksPretension, CutsABoltAlongItsElements) {
  SceneInput scene = cutBolt({0.0, 2.0});
  expectBoltDiagram(scene);
  scene.set("Parts/bolt/Pieces=5");
  expectBoltDiagram(scene);
}

TEST(Pretension, CutsWhereElementsHaveALayerOfFaces) {
  const auto message = [](const SceneInput& scene) {
    try {
      const SolvedScene run(scene);
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ExitCode::input);
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(message(cutBolt({1.0, 1.0})).find("have no layer of faces there"), std::string::npos);
  SceneInput glued = cutBolt({0.0, 1.0});
  glued.remove("Interfaces/preload/Law");
  glued.add("Interfaces/preload",
            xmlList("Law", xmlText("Type", "Linear Elastic") + xmlNumber("Normal Stiffness", 1.0) +
                               xmlNumber("Tangential Stiffness", 1.0)));
  EXPECT_NE(message(glued).find("cannot act on a plane through one part"), std::string::npos);
}

TEST(Pretension, FollowsItsHistoryUntilItIsLocked) {
  SceneInput scene = boltDiagram(preload, xmlText("Force History", "tighten") + xmlNumber("Locked From", 3.0));
  scene.add("Histories", xmlList("tighten", xmlText("Type", "Table") + xmlNumbers("Times", {1.0, 2.0, 3.0}) +
                                                xmlNumbers("Values", {0.5, 1.0, 1.5})));
  scene.set("Boundaries/pull/Law/Y=0");
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double share[] = {0.5, 1.0, 1.5, 1.5};
  for (int t = 0; t < 4; ++t) {
    EXPECT_NEAR(run.value("bolt", t), share[t] * preload, 1e-6 * preload);
    EXPECT_NEAR(run.value("overlap", t), share[t] * overlap, tolerance * overlap);
    EXPECT_NEAR(run.value("left_force", t) + run.value("right_force", t), share[t] * preload, tolerance * preload);
  }
}

// Quadratic elements and the velocity form meet the same force.
TEST(Pretension, HoldsOnQuadraticFacesAndInVelocities) {
  SceneInput quadratic = boltDiagram(preload, xmlNumber("Locked From", 1.0));
  quadratic.set("Solver/Accuracy=1e-5");  // round-off of the stiff head
  expectBoltDiagram(quadratic.add("Mesh", "<Parameter name=\"Order\" type=\"int\" value=\"2\"/>"));
  SceneInput velocities = boltDiagram(preload, xmlNumber("Locked From", 1.0));
  velocities.set("Solver/Accuracy=1e-5");
  expectBoltDiagram(velocities.add("Solver", xmlText("Formulation", "Velocity")));
}

/// The estimate for a response, relative.
double meshErrorOf(const SceneInput& scene, const std::string& name) {
  const auto comm = Tpetra::getDefaultComm();
  base::Timers timers;
  const scene::Scene made = scene.scene();
  const scene::Problem problem = scene::makeProblem(made, *comm, timers);
  latin::LatinSolver solver(problem.assembly, latin::LatinOptions(made.input.list("Solver")), comm, timers);
  for (const auto& response : problem.responses) solver.addResponse(response);
  const latin::LatinResult result = solver.solve();
  EXPECT_EQ(result.outcome, latin::Outcome::certified) << result.reason;
  for (const auto& error :
       scene::estimateMeshErrors(problem, solver.fixedPoint(), solver.state(), problem.responses, *comm).responses) {
    if (error.response == name) return error.relative;
  }
  return -1.0;
}

/// That for the force of the bolt, where the head bends on a coarse mesh; after a pull of that traction.
double meshErrorOfBolt(SceneInput scene, double traction) {
  scene.set("Materials/rigid/Young's Modulus=210000").set("Mesh/Boxes/head/Cells={22, 1}");
  scene.set(assignment("Values/traction", traction)).set("Solver/Accuracy=1e-5");
  return meshErrorOf(scene, "bolt");
}

// A force that was given is right on every mesh, also when it is locked; what a given overlap makes of it is not, and
// what a later pull adds to it hardly is.
TEST(RanksPretension, OfALockedBoltTheMeshErrorIsThatOfWhatFollows) {
  const SceneInput locked = boltDiagram(preload, xmlNumber("Locked From", 1.0));
  EXPECT_LT(meshErrorOfBolt(locked, 0.0), 1e-3);
  EXPECT_GT(meshErrorOfBolt(SceneInput::fromFile("bolt_diagram/bolt.xml"), 0.0), 0.02);
  // Split twice, the mesh gives 0.15 % more.
  const double pulled = meshErrorOfBolt(locked, 5e-4);
  EXPECT_GT(pulled, 0.5 * 1.5e-3);
  EXPECT_LT(pulled, 3.0 * 1.5e-3);
  EXPECT_LT(meshErrorOfBolt(boltDiagram(preload, ""), 1e-4), 1e-6);  // never locked
}

// As is that of a bolt that is a spring between two faces: of what the mesh does to its elongation, 5 % of its force,
// the lock keeps what had been there before; split twice more, the mesh gives 0.05 % less.
TEST(RanksPretension, OfALockedSpringTheMeshErrorIsThatOfWhatFollows) {
  SceneInput scene = SceneInput::fromFile("pretension/clamped_plates.xml");
  scene.add("Mesh", "<Parameter name=\"Refine\" type=\"int\" value=\"1\"/>");
  const double error = meshErrorOf(scene, "bolt");
  EXPECT_GT(error, 0.0);
  EXPECT_LT(error, 0.01);
}

}  // namespace
}  // namespace harmos::verification
