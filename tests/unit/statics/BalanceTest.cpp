// Limits of rigid statics that are known in closed form.
#include <cmath>

#include <gtest/gtest.h>

#include <harmos/statics/Balance.hpp>

namespace harmos::statics {
namespace {

constexpr double roundOff = 1e-9;  // of the programme, over the loads
constexpr double pi = 3.14159265358979323846;

/// Turned about y by `angle`: n is the inward normal of the ground under a block, pointing down into it.
base::Frame floorTurnedBy(double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  return {{{s, 0.0, -c}, {c, 0.0, s}, {0.0, 1.0, 0.0}}};
}

/// The same in the plane x, y.
base::Frame floorInThePlane(double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  return {{{s, -c, 0.0}, {c, s, 0.0}, {0.0, 0.0, 1.0}}};
}

/// A block with the edges `width` and `height`, on four corners (two in the plane) of a ground with friction.
RigidAssembly block(int dimension, double angle, double mu, double width = 1.0, double height = 1.0) {
  RigidAssembly assembly;
  assembly.dimension = dimension;
  assembly.bodies = {{{}, 1.0}};
  const base::Frame frame = dimension == 3 ? floorTurnedBy(angle) : floorInThePlane(angle);
  for (const double x : {-0.5 * width, 0.5 * width}) {
    for (const double y : {-0.5 * width, 0.5 * width}) {
      if (dimension == 2 && y > 0.0) continue;
      Joint joint;
      joint.interface = 7;
      joint.body1 = 0;
      joint.frame = frame;
      joint.place1 = base::toGlobal(frame, {0.5 * height, x, dimension == 3 ? y : 0.0});
      joint.place2 = joint.place1;
      joint.area = 0.25;
      joint.tractions = laws::AdmissibleTractions::pressure(mu);
      assembly.joints.push_back(joint);
    }
  }
  return assembly;
}

/// What is left of the load on a single body, over its force.
double residualOf(const RigidAssembly& assembly, const Wrench& load, Friction friction = Friction::full) {
  const Balance balance = findBalance(assembly, {load}, base::norm(load.force), friction);
  EXPECT_TRUE(balance.isKnown);
  return balance.residual;
}

class OnAnIncline : public testing::TestWithParam<int> {
 protected:
  Wrench weight() const {
    return {GetParam() == 3 ? base::Vector3{0.0, 0.0, -1.0} : base::Vector3{0.0, -1.0, 0.0}, {}};
  }
};

// A flat block stays up to the angle of friction, exactly.
TEST_P(OnAnIncline, ABlockStaysUpToTheAngleOfFriction) {
  const double mu = 0.3, angle = std::atan(mu);
  EXPECT_LT(residualOf(block(GetParam(), angle - 1e-6, mu, 1.0, 0.1), weight()), roundOff);
  const RigidAssembly steeper = block(GetParam(), angle + 1e-5, mu, 1.0, 0.1);
  EXPECT_GT(residualOf(steeper, weight()), 1e-6);
  EXPECT_GT(residualOf(block(GetParam(), angle - 1e-6, mu, 1.0, 0.1), weight(), Friction::none), 0.1);
}

// A high block turns over its lower edge: tan(angle) = width / height.
TEST_P(OnAnIncline, AHighBlockTipsOver) {
  const double angle = std::atan(0.25);
  EXPECT_LT(residualOf(block(GetParam(), angle - 1e-6, 10.0, 0.25, 1.0), weight()), roundOff);
  const RigidAssembly steeper = block(GetParam(), angle + 1e-3, 10.0, 0.25, 1.0);
  const Balance balance = findBalance(steeper, {weight()}, 1.0, Friction::full);
  ASSERT_TRUE(balance.isKnown);
  EXPECT_GT(balance.residual, 1e-4);
  EXPECT_GT(base::norm(balance.motions[0].rotation), 0.5);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, OnAnIncline, testing::Values(2, 3));

// In space the limit is the same in every direction: the cone is round, no pyramid.
TEST(Balance, OfAPushIsTheSameInEveryDirection) {
  const double mu = 0.4;
  const RigidAssembly assembly = block(3, 0.0, mu, 1.0, 1e-6);
  for (double direction = 0.0; direction < 2.0 * pi; direction += 0.37) {
    const auto load = [&](double push) {
      return Wrench{{push * std::cos(direction), push * std::sin(direction), -1.0}, {}};
    };
    EXPECT_LT(residualOf(assembly, load((1.0 - 1e-5) * mu)), roundOff) << direction;
    // The distance from the cone, in a norm that is at most sqrt(2) times the length.
    const double beyond = residualOf(assembly, load((1.0 + 1e-4) * mu));
    EXPECT_GT(beyond, 0.5e-4 * mu) << direction;
    EXPECT_LT(beyond, 1.5e-4 * mu) << direction;
  }
}

TEST(Balance, OfALiftIsNothing) {
  const Balance balance = findBalance(block(3, 0.0, 0.5), {{{0.0, 0.0, 1.0}, {}}}, 1.0, Friction::full);
  ASSERT_TRUE(balance.isKnown);
  EXPECT_NEAR(balance.residual, 1.0, 1e-9);
  EXPECT_NEAR(balance.unbalanced[0].force[2], 1.0, 1e-9);
  EXPECT_GT(balance.motions[0].translation[2], 0.0);
}

// The corners reach to x = 0.5: of a force at 0.51 the moment 0.01 is left, over the size 1.
TEST(Balance, OfAForceBesideTheBaseIsNothing) {
  const Wrench inside{{0.0, 0.0, -1.0}, base::cross({0.49, 0.49, 0.0}, {0.0, 0.0, -1.0})};
  const Wrench beside{{0.0, 0.0, -1.0}, base::cross({0.51, 0.0, 0.0}, {0.0, 0.0, -1.0})};
  EXPECT_LT(residualOf(block(3, 0.0, 0.5), inside), roundOff);
  EXPECT_NEAR(residualOf(block(3, 0.0, 0.5), beside), 0.01, 1e-9);
}

/// A ladder of length 1 between a rough floor and a smooth wall, `angle` to the floor, loaded by its weight.
RigidAssembly ladder(double angle, double mu) {
  RigidAssembly assembly;
  assembly.dimension = 2;
  assembly.bodies = {{{}, 1.0}};
  const base::Vector3 top{0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.0};
  Joint floor, wall;
  floor.body1 = wall.body1 = 0;
  floor.frame = {{{0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
  wall.frame = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  floor.place1 = -1.0 * top;
  wall.place1 = top;
  floor.area = wall.area = 1.0;
  floor.tractions = laws::AdmissibleTractions::pressure(mu);
  wall.tractions = laws::AdmissibleTractions::pressure(0.0);
  assembly.joints = {floor, wall};
  return assembly;
}

// tan(angle) >= 1 / (2 mu).
TEST(Balance, OfALadderIsItsAngle) {
  const double mu = 0.4, angle = std::atan(0.5 / mu);
  const Wrench weight{{0.0, -3.0, 0.0}, {}};
  EXPECT_LT(residualOf(ladder(angle + 1e-6, mu), weight), roundOff);
  EXPECT_GT(residualOf(ladder(angle - 1e-4, mu), weight), 1e-6);
}

/// A smooth wedge of slope `angle` under a block that a smooth wall guides: a push on the wedge lifts the block.
RigidAssembly wedge(double angle) {
  RigidAssembly assembly;
  assembly.dimension = 2;
  assembly.bodies = {{{}, 1.0}, {{0.0, 1.0, 0.0}, 1.0}};
  const auto add = [&](int body1, int body2, base::Vector3 place, base::Vector3 n) {
    Joint joint;
    joint.body1 = body1;
    joint.body2 = body2;
    joint.place1 = joint.place2 = place;
    joint.frame = {{n, {-n[1], n[0], 0.0}, {0.0, 0.0, 1.0}}};
    joint.area = 1.0;
    joint.tractions = laws::AdmissibleTractions::pressure(0.0);
    assembly.joints.push_back(joint);
  };
  for (const double x : {-0.5, 0.5}) {
    add(0, -1, {x, -0.5, 0.0}, {0.0, -1.0, 0.0});
    add(0, 1, {x, 0.5 - x * std::tan(angle), 0.0}, {std::sin(angle), std::cos(angle), 0.0});
    add(1, -1, {0.5, 1.0 + 0.3 * x, 0.0}, {1.0, 0.0, 0.0});
  }
  return assembly;
}

// Pushed by P, a smooth wedge bears exactly P / tan(angle): any other weight has no equilibrium.
TEST(Balance, OfASmoothWedgeIsOneRatio) {
  const double angle = 0.3, push = 2.0;
  const auto balance = [&](double weight) {
    return findBalance(wedge(angle), {{{push, 0.0, 0.0}, {}}, {{0.0, -weight, 0.0}, {}}}, push + weight,
                       Friction::full);
  };
  EXPECT_LT(balance(push / std::tan(angle)).residual, roundOff);
  for (const double ratio : {0.99, 1.01}) {
    const Balance other = balance(ratio * push / std::tan(angle));
    ASSERT_TRUE(other.isKnown);
    EXPECT_GT(other.residual, 1e-4);
    // The wedge goes in under a weight that is too small, and is driven out by one that is too large.
    EXPECT_EQ(other.motions[0].translation[0] > 0.0, ratio < 1.0);
    // Nothing resists: no joint closes.
    for (const Joint& joint : wedge(angle).joints) {
      EXPECT_GE(jumpOf(joint, wedge(angle).bodies, other.motions)[0], -1e-9);
    }
  }
}

// A traction that is limited bears its area times the limit: 0.5 of 2 on an area of 1.
TEST(Balance, OfALimitedTractionIsWhatItsAreaBears) {
  RigidAssembly assembly = block(3, 0.0, 0.0);
  for (Joint& joint : assembly.joints) joint.tractions.upper = {0.5, 0.0, 0.0};
  EXPECT_NEAR(residualOf(assembly, {{0.0, 0.0, 2.0}, {}}), 0.75, 1e-9);
}

// A force in a point beside the body, of any size in any unit, bears what goes through that point.
TEST(Balance, OfACouplingIsItsLine) {
  for (const double size : {1e-6, 1.0, 1e6}) {
    RigidAssembly assembly;
    assembly.bodies = {{{}, size}};
    assembly.couplings = {{0, {{0, {{0.0, 0.0, 1e3}, {2e3 * size, 0.0, 0.0}}}}}};
    EXPECT_LT(residualOf(assembly, {{0.0, 0.0, -3.0}, {-6.0 * size, 0.0, 0.0}}), roundOff) << size;
    EXPECT_GT(residualOf(assembly, {{0.0, 0.0, -3.0}, {-5.0 * size, 0.0, 0.0}}), 0.1) << size;
    EXPECT_GT(residualOf(assembly, {{0.0, -3.0, 0.0}, {}}), 0.1) << size;
  }
}

TEST(Balance, OfLoadsThatBalanceEachOtherNeedsNothing) {
  const RigidAssembly assembly = block(3, 0.0, 0.0);
  const Balance balance = findBalance(assembly, {{{1e-12, 0.0, -1e-13}, {}}}, 1.0, Friction::full);
  EXPECT_TRUE(balance.isKnown);
  EXPECT_LT(balance.residual, roundOff);
}

}  // namespace
}  // namespace harmos::statics
