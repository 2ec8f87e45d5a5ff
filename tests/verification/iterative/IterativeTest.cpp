#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Teuchos_DefaultMpiComm.hpp>

#include <harmos/substructure/MultigridLibrary.hpp>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

using Names = std::vector<std::string>;

/// The scene with these parts solved iteratively.
SceneInput iterating(SceneInput scene, const Names& parts) {
  for (const std::string& part : parts) scene.set("Parts/" + part + "/Linear Solver=Iterative");
  return scene;
}

/// Of two runs that are certified: all responses named, at all load steps, relative to the largest of each.
void expectSame(const SolvedScene& run, const SolvedScene& reference, const Names& responses, double tolerance) {
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  ASSERT_TRUE(reference.isCertified()) << reference.result.reason;
  for (const std::string& name : responses) {
    double size = 0.0;
    for (const double value : reference.values(name)) size = std::max(size, std::abs(value));
    for (int step = 0; step < reference.steps(); ++step)
      EXPECT_NEAR(run.value(name, step), reference.value(name, step), tolerance * size) << name << " " << step;
  }
  EXPECT_LT(displacementDifference(run, reference), tolerance);
}

class Iterative : public testing::Test {
 protected:
  void SetUp() override {
    if (!substructure::hasMultigrid()) GTEST_SKIP() << "built without MueLu";
  }
};

class LongIterative : public Iterative {};
class RanksIterative : public Iterative {};

SceneInput boltedJoint() {
  SceneInput scene = SceneInput::fromFile("../../xml/bolted_joint.xml");
  return scene.set("Mesh/Refinement=0.5");
}

const Names ofTheJoint = {"u_load", "bolt_force_1", "bolt_force_2", "reaction"};
const Names allOfTheJoint = {"cover_bottom", "centre", "cover_top", "bolt_1", "head_1", "bolt_2", "head_2"};

// Both are within the accuracy of the truth; the stages are nearly the same, for solves are far more exact.
TEST_F(Iterative, BoltedJointAsFactored) {
  const SolvedScene reference(boltedJoint());
  const SolvedScene run(iterating(boltedJoint(), allOfTheJoint));
  expectSame(run, reference, ofTheJoint, 1e-6);
  EXPECT_LE(run.result.linearStages, reference.result.linearStages + 3);
}

// A fine accuracy is not claimed by solves that are too coarse for it.
TEST_F(LongIterative, BoltedJointToAMillionth) {
  const SolvedScene reference(boltedJoint().set("Solver/Accuracy=1e-8"));
  const SolvedScene run(iterating(boltedJoint().set("Solver/Accuracy=1e-6"), allOfTheJoint));
  expectSame(run, reference, ofTheJoint, 1e-6);
}

// Of one part only, whose equal is factored; step after step, in the velocity form.
TEST_F(Iterative, OnePartInTheVelocityForm) {
  const auto joint = [] { return boltedJoint().set("Solver/Formulation=Velocity").set("Solver/Mesh Error=false"); };
  expectSame(SolvedScene(iterating(joint(), {"bolt_1"})), SolvedScene(joint()), ofTheJoint, 1e-5);
}

// The beam is cut, its pieces glued by perfect interfaces, as is the wall of the second scene, in the plane.
TEST_F(Iterative, GluedPiecesAsFactored) {
  SceneInput beam = SceneInput::fromFile("perfect/beam.xml");
  beam.set("Parts/beam/Pieces=3");
  const SolvedScene reference{SceneInput(beam)};
  expectSame(SolvedScene(iterating(beam, {"beam"})), reference, {"end_y", "end_z"}, 1e-5);
}

TEST_F(Iterative, GluedPlaneAsFactored) {
  SceneInput wall = SceneInput::fromFile("contact_patch/plane.xml");
  wall.set("Interfaces/contact/Law/Type=Perfect");
  for (const char* box : {"lower", "upper"}) wall.set("Mesh/Boxes/" + std::string(box) + "/Cells={20,12}");
  const SolvedScene reference{SceneInput(wall)};
  expectSame(SolvedScene(iterating(wall, {"lower", "upper"})), reference, {"top"}, 1e-5);
}

TEST_F(RanksIterative, BoltedJointOnAnyRanks) {
  const auto self = Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF));
  expectSame(SolvedScene(iterating(boltedJoint(), {"cover_top", "bolt_1", "head_1"})), SolvedScene(boltedJoint(), self),
             ofTheJoint, 1e-6);
}

}  // namespace
}  // namespace harmos::verification
