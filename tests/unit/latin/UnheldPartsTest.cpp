// Parts that nothing holds where they were found are named, others are not.
#include <gtest/gtest.h>

#include <harmos/latin/LatinSolver.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

using Law = std::shared_ptr<const laws::InterfaceLaw>;

std::vector<std::string> remarksOn(BoxAssembly cubes) {
  base::Timers timers;
  LatinSolver solver(cubes.assembly(), {}, self(), timers);
  const LatinResult result = solver.solve();
  EXPECT_EQ(result.outcome, Outcome::certified) << result.reason;
  return result.remarks;
}

Law friction(double mu) {
  return laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", mu}});
}
Law push(double x, double z) {
  return laws::makeLaw("Prescribed Traction", {{"X", x}, {"Z", z}});
}

TEST(UnheldParts, OnASmoothContactCanSlideAndTurn) {
  const auto remarks = remarksOn(twoCubes(laws::makeLaw("Unilateral Contact"), push(0.0, -2.0)));
  ASSERT_EQ(remarks.size(), 1U);
  for (const char* part : {"upper", "load step 1", "(1, 0, 0)", "(0, 1, 0)", "turning about (0, 0, 1)"})
    EXPECT_NE(remarks[0].find(part), std::string::npos) << remarks[0];
  EXPECT_EQ(remarks[0].find("lower"), std::string::npos) << remarks[0];
}

TEST(UnheldParts, AreNoneWhereFrictionSticksOrAJointBonds) {
  EXPECT_TRUE(remarksOn(twoCubes(friction(0.5), push(0.1, -2.0))).empty());
  EXPECT_TRUE(remarksOn(twoCubes(laws::makeLaw("Perfect"), push(0.1, 2.0))).empty());
  const Law soft = laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 1e-3}, {"Tangential Stiffness", 1e-3}});
  EXPECT_TRUE(remarksOn(twoCubes(soft, push(0.0, -0.1))).empty());
}

TEST(UnheldParts, ByGlueWithoutStiffnessAlongItCanSlide) {
  const Law rollers = laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 10.0}, {"Tangential Stiffness", 0.0}});
  EXPECT_EQ(remarksOn(twoCubes(rollers, push(0.0, 1.0))).size(), 1U);
}

TEST(UnheldParts, AreNamedWithTheirLoadSteps) {
  const Law top = laws::makeLaw("Prescribed Traction", {{"Z", -1.0}}, {{"Z", {1.0, 2.0}}});
  const auto remarks = remarksOn(twoCubes(laws::makeLaw("Unilateral Contact"), top, 2));
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("load steps 1 to 2"), std::string::npos) << remarks[0];
}

}  // namespace
}  // namespace harmos::latin
