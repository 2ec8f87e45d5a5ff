#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include <harmos/latin/detail/TractionProbe.hpp>

#include "Chains.hpp"

namespace harmos::latin {
namespace {

using base::Vector3;

/// A pair that a law meets for the first time, with the normal along x: what it admits beside a traction, closed and
/// after a slip of so much along y.
std::optional<TractionSet> admitted(const std::shared_ptr<const laws::InterfaceLaw>& law, const Vector3& traction,
                                    double slip = 0.0) {
  assembly::Assembly assembly;
  assembly.times = {1.0};
  assembly.interfaces = {pointInterface("joint", law, 0, 0)};
  const LawReplay replay(assembly, 0, {0});
  TractionProbe::Pair pair;
  pair.traction = traction;
  pair.jump = {0.0, slip, 0.0};
  pair.size = 2.0;
  pair.compliance = 1e-3;
  pair.slides = slip != 0.0;
  return TractionProbe(replay, assembly.interfaces[0], 3).find(0, {pair}).front();
}

void expectNear(const Vector3& found, const Vector3& expected) {
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-4);
}

const Vector3 aside{-1.0, 0.0, 5.0};

TEST(TractionProbe, FindsTheConeOfCoulombsLaw) {
  const std::shared_ptr<const laws::InterfaceLaw> law =
      laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}});
  const Vector3 axes[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const TractionSet cone = TractionSet::cone({axes[0], axes[1], axes[2]}, 0.3, 3);
  const auto found = admitted(law, {-1.0, 0.1, 0.0});
  ASSERT_TRUE(found);
  for (const Vector3& x : {aside, Vector3{-1.0, 0.1, 0.2}, Vector3{1.0, 0.1, 0.0}})
    expectNear(found->nearest(x), cone.nearest(x));
}

TEST(TractionProbe, StaysWithinFrictionThatDependsOnTheDirection) {
  const std::shared_ptr<const laws::InterfaceLaw> law =
      laws::makeLaw("Orthotropic Friction", {{"Friction Coefficient 1", 0.5}, {"Friction Coefficient 2", 0.1}}, {},
                    {{"Axis", {0.0, 1.0, 0.0}}});
  const auto found = admitted(law, {-1.0, 0.0, 0.0});
  ASSERT_TRUE(found);
  const Vector3 far = found->nearest({-10.0, 0.0, 100.0});
  EXPECT_NEAR(std::abs(far[2] / far[0]), 0.1, 1e-4);
  // Sliding along y, all of the friction there.
  const auto sliding = admitted(law, {-1.0, 0.5, 0.0}, 0.1);
  ASSERT_TRUE(sliding);
  const Vector3 there = sliding->nearest({-10.0, 0.0, 0.0});
  EXPECT_NEAR(std::abs(there[1] / there[0]), 0.5, 1e-4);
}

// Friction at rest is a tenth of that of a pair that moves fast.
TEST(TractionProbe, KnowsFrictionAtRest) {
  const std::shared_ptr<const laws::InterfaceLaw> law = laws::makeLaw(
      "Rate-Dependent Friction", {{"Static Coefficient", 0.05}, {"Kinetic Coefficient", 0.5}, {"Velocity", 1.0}});
  const auto found = admitted(law, {-1.0, 0.0, 0.0});
  ASSERT_TRUE(found);
  const Vector3 far = found->nearest({-10.0, 0.0, 100.0});
  EXPECT_NEAR(std::abs(far[2] / far[0]), 0.05, 1e-3);
}

// Shear up to a limit whatever the pressure; after a slip that limit, besides any pressure.
TEST(TractionProbe, KnowsLimitsThatPressureDoesNotChange) {
  const std::shared_ptr<const laws::InterfaceLaw> law = laws::makeLaw("Tresca Friction", {{"Shear Limit", 0.05}});
  const auto found = admitted(law, {-1.0, 0.0, 0.0});
  ASSERT_TRUE(found);
  expectNear(found->nearest(aside), {-1.0, 0.0, 0.05});
  expectNear(found->nearest({1.0, 0.01, 0.0}), {0.0, 0.01, 0.0});
  const auto sliding = admitted(law, {-1.0, 0.05, 0.0}, 0.1);
  ASSERT_TRUE(sliding);
  const Vector3 there = sliding->nearest({-7.0, 0.0, 0.0});
  EXPECT_NEAR(there[0], -7.0, 1e-4);
  EXPECT_NEAR(std::abs(there[1]), 0.05, 1e-4);
}

TEST(TractionProbe, LeavesWhatJumpsDetermineAsItIs) {
  EXPECT_FALSE(admitted(laws::makeLaw("Compliant Contact", {{"Normal Stiffness", 100.0}}), {-1.0, 0.0, 0.0}));
}

// A bonded normal bears anything; a spring along the surface only what it was stretched for.
TEST(TractionProbe, FindsWhatBearsTensionToo) {
  const std::shared_ptr<const laws::InterfaceLaw> law =
      laws::makeLaw("Jenkins", {{"Tangential Stiffness", 10.0}, {"Slip Limit", 3.0}});
  const auto found = admitted(law, {-1.0, 0.0, 0.0});
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->isSpan());
  expectNear(found->nearest({7.0, 1.0, 1.0}), {7.0, 0.0, 0.0});
}

}  // namespace
}  // namespace harmos::latin
