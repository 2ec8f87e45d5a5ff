// Motions that nothing holds, of bodies and chains of bodies that are held in known ways.
#include <gtest/gtest.h>

#include <harmos/statics/FreeMotions.hpp>

namespace harmos::statics {
namespace {

const base::Frame axes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

/// A body at `centre` with joints at the corners of a square of edge 1 below it, to `other` or to the ground.
void addBody(RigidAssembly& assembly, const base::Vector3& centre, int other = -1) {
  const int body = static_cast<int>(assembly.bodies.size());
  assembly.bodies.push_back({centre, 1.0});
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      Joint joint;
      joint.body1 = body;
      joint.body2 = other;
      joint.place1 = joint.place2 = centre + base::Vector3{x, y, -0.5};
      joint.frame = axes;
      joint.area = 0.25;
      assembly.joints.push_back(joint);
    }
  }
}

/// Holds of all joints of a body along some axes.
void hold(const RigidAssembly& assembly, int body, const std::vector<int>& along, std::vector<Hold>& holds) {
  for (std::size_t j = 0; j < assembly.joints.size(); ++j) {
    if (assembly.joints[j].body1 != body) continue;
    for (const int axis : along) holds.push_back({static_cast<int>(j), axes[axis]});
  }
}

TEST(FreeMotions, OfABodyThatIsHeldAreNone) {
  RigidAssembly assembly;
  addBody(assembly, {3.0, 0.0, 0.0});
  std::vector<Hold> holds;
  hold(assembly, 0, {0, 1, 2}, holds);
  EXPECT_TRUE(findFreeMotions(assembly, holds).empty());
}

TEST(FreeMotions, OfABodyOnASmoothFloorAreThree) {
  RigidAssembly assembly;
  addBody(assembly, {100.0, -7.0, 0.5});
  std::vector<Hold> holds;
  hold(assembly, 0, {2}, holds);
  const auto motions = findFreeMotions(assembly, holds);
  ASSERT_EQ(motions.size(), 3U);
  for (const auto& motion : motions) {
    EXPECT_NEAR(motion[0].translation[2], 0.0, 1e-9);
    EXPECT_NEAR(motion[0].rotation[0], 0.0, 1e-9);
    EXPECT_NEAR(motion[0].rotation[1], 0.0, 1e-9);
  }
}

// Normals of a mesh carry round-off: a tilt of 1e-17 holds nothing.
TEST(FreeMotions, AreNotHeldByRoundOff) {
  RigidAssembly assembly;
  addBody(assembly, {0.0, 0.0, 0.5});
  std::vector<Hold> holds;
  hold(assembly, 0, {2}, holds);
  for (std::size_t i = 0; i < holds.size(); ++i) holds[i].direction[1] = 1e-17 * static_cast<double>(i);
  EXPECT_EQ(findFreeMotions(assembly, holds).size(), 3U);
}

// Held along y and z at all corners: only x is left, and it comes out as such.
TEST(FreeMotions, AreNamedAlongTheirAxis) {
  RigidAssembly assembly;
  addBody(assembly, {0.0, 0.0, 0.5});
  std::vector<Hold> holds;
  hold(assembly, 0, {1, 2}, holds);
  const auto motions = findFreeMotions(assembly, holds);
  ASSERT_EQ(motions.size(), 1U);
  EXPECT_NEAR(motions[0][0].translation[0], 1.0, 1e-12);
  EXPECT_NEAR(base::norm(motions[0][0].rotation), 0.0, 1e-12);
}

// The upper one is bound to the lower one, which slides along x: both move as one.
TEST(FreeMotions, TakeAlongWhatIsBound) {
  RigidAssembly assembly;
  addBody(assembly, {0.0, 0.0, 0.5});
  addBody(assembly, {0.0, 0.0, 1.5}, 0);
  std::vector<Hold> holds;
  hold(assembly, 0, {1, 2}, holds);
  hold(assembly, 1, {0, 1, 2}, holds);
  const auto motions = findFreeMotions(assembly, holds);
  ASSERT_EQ(motions.size(), 1U);
  for (const Motion& motion : motions[0]) EXPECT_NEAR(std::abs(motion.translation[0]), 1.0, 1e-9);
}

// Forces through a point hold it, whatever the unit of length; with a moment one turn less is left.
TEST(FreeMotions, OfABodyHeldInAPointAreItsTurns) {
  for (const double size : {1e-6, 1.0, 1e6}) {
    RigidAssembly assembly;
    assembly.bodies.push_back({{}, size});
    for (std::size_t c = 0; c < 3; ++c) {
      base::Vector3 unit{};
      unit[c] = 1.0;
      assembly.couplings.push_back({0, {{0, {unit, base::cross({0.0, 2.0 * size, 0.0}, unit)}}}});
    }
    const auto turns = findFreeMotions(assembly, {});
    ASSERT_EQ(turns.size(), 3U) << size;
    for (const auto& motion : turns)
      EXPECT_LT(base::norm(displacementOf(assembly.bodies[0], motion[0], {0.0, 2.0 * size, 0.0})), 1e-9) << size;
    assembly.couplings.push_back({0, {{0, {{}, {0.0, 0.0, 1.0}}}}});
    EXPECT_EQ(findFreeMotions(assembly, {}).size(), 2U) << size;
  }
}

// Two bodies on one face whose mean does not move go opposite ways.
TEST(FreeMotions, OfTwoBodiesWithOneMeanAreOpposite) {
  RigidAssembly assembly;
  assembly.dimension = 2;
  addBody(assembly, {-1.0, 0.0, 0.0});
  addBody(assembly, {1.0, 0.0, 0.0});
  std::vector<Hold> holds;
  hold(assembly, 0, {1}, holds);
  hold(assembly, 1, {1}, holds);
  assembly.couplings = {{0, {{0, {{0.5, 0.0, 0.0}, {}}}, {1, {{0.5, 0.0, 0.0}, {}}}}}};
  const auto motions = findFreeMotions(assembly, holds);
  ASSERT_EQ(motions.size(), 1U);
  EXPECT_NEAR(motions[0][0].translation[0], -motions[0][1].translation[0], 1e-9);
}

TEST(FreeMotions, InThePlaneAreThreeAtMost) {
  RigidAssembly assembly;
  assembly.dimension = 2;
  addBody(assembly, {0.0, 0.0, 0.0});
  EXPECT_EQ(findFreeMotions(assembly, {}).size(), 3U);
  std::vector<Hold> holds;
  hold(assembly, 0, {1}, holds);
  EXPECT_EQ(findFreeMotions(assembly, holds).size(), 1U);
}

}  // namespace
}  // namespace harmos::statics
