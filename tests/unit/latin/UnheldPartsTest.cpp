// Parts that nothing holds where they were found are named, others are not.
#include <gtest/gtest.h>

#include <harmos/latin/LatinSolver.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"
#include "Faces.hpp"

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

TEST(UnheldParts, AreNoneOnRollers) {
  BoxAssembly cubes({{"lower", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {"upper", {0, 0, 1}, {1, 1, 2}, {2, 2, 2}}}, 1);
  cubes.join("joint", "lower_zmax", "upper_zmin", friction(0.3));
  cubes.hold("floor", "lower_zmin", laws::makeLaw("Prescribed Displacement", {{"Z", 0.0}}));
  for (const std::string part : {"lower", "upper"}) {
    cubes.hold(part + " x", part + "_xmin", laws::makeLaw("Prescribed Displacement", {{"X", 0.0}}));
    cubes.hold(part + " y", part + "_ymin", laws::makeLaw("Prescribed Displacement", {{"Y", 0.0}}));
  }
  cubes.hold("top", "upper_zmax", push(0.0, -2.0));
  EXPECT_TRUE(remarksOn(cubes).empty());
}

// Where a part is decides of displacements along there, and of no others.
TEST(UnheldParts, LeaveResponsesAlongTheirWayOpen) {
  base::Timers timers;
  BoxAssembly cubes = twoCubes(laws::makeLaw("Unilateral Contact"), push(0.0, -2.0));
  LatinSolver solver(cubes.assembly(), {}, self(), timers);
  const auto last = static_cast<int>(cubes.assembly().bodies[1].nodes.size()) - 1;
  for (const auto& [name, body, direction] : std::vector<std::tuple<std::string, int, base::Vector3>>{
           {"pressed", 1, {0.0, 0.0, 1.0}}, {"slid", 1, {1.0, 0.0, 0.0}}, {"held", 0, {1.0, 0.0, 0.0}}}) {
    solver.addResponse(std::make_shared<DisplacementResponse>(
        name, std::vector<DisplacementResponse::Node>{{body, last, 1.0}}, direction));
  }
  const LatinResult result = solver.solve();
  ASSERT_EQ(result.remarks.size(), 1U);
  EXPECT_NE(result.remarks[0].find("along there, nor \"slid\", only the forces"), std::string::npos)
      << result.remarks[0];
}

// What is eliminated at the foot of a chain does not hold it in the macro problem.
TEST(UnheldParts, OfAChainOnRollersCanSlide) {
  BoxAssembly chain({{"a", {0, 0, 0}, {1, 1, 1}, {1, 1, 1}},
                     {"b", {0, 0, 1}, {1, 1, 2}, {1, 1, 1}},
                     {"c", {0, 0, 2}, {1, 1, 3}, {1, 1, 1}}});
  chain.hold("bottom", "a_zmin", laws::makeLaw("Symmetry"));
  chain.join("ab", "a_zmax", "b_zmin", laws::makeLaw("Perfect"));
  chain.join("bc", "b_zmax", "c_zmin", laws::makeLaw("Perfect"));
  chain.hold("top", "c_zmax", push(0.0, 1.0));
  const auto remarks = remarksOn(chain);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("along (1, 0, 0)"), std::string::npos) << remarks[0];
}

TEST(UnheldParts, ByGlueWithoutStiffnessAlongItCanSlide) {
  const Law rollers = laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 10.0}, {"Tangential Stiffness", 0.0}});
  EXPECT_EQ(remarksOn(twoCubes(rollers, push(0.0, 1.0))).size(), 1U);
}

// A force is no place: the bolt gives way until it is locked.
TEST(UnheldParts, OnABoltThatIsTightenedCanGiveWay) {
  const auto remarks = remarksOn(twoCubes(laws::makeLaw("Pretension", {{"Force", 2.0}}), push(0.5, 2.0)));
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("upper\" at load step 1: free along (0, 0, 1);"), std::string::npos) << remarks[0];
}

// Loads that go through the point are borne; that the cube may turn about it is said.
TEST(UnheldParts, OnAFaceHeldInAPointCanTurn) {
  const auto remarksWith = [](std::map<std::string, double> held) {
    BoxAssembly cube({{"cube", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}});
    held.insert({{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}});
    holdFace(cube, {"cube_zmin"}, laws::makeLaw("Remote Displacement", held));
    cube.hold("top", "cube_zmax", push(0.0, 1.0));
    return remarksOn(cube);
  };
  const auto remarks = remarksWith({});
  ASSERT_EQ(remarks.size(), 1U);
  for (const char* part : {"cube", "load step 1", "turning about (1, 0, 0) through (0.5, 0.5, 0)",
                           "turning about (0, 1, 0) through (0.5, 0.5, 0)", "turning about (0, 0, 1)"})
    EXPECT_NE(remarks[0].find(part), std::string::npos) << remarks[0];
  EXPECT_TRUE(remarksWith({{"Rotation X", 0.0}, {"Rotation Y Stiffness", 1e-3}, {"Rotation Z", 0.0}}).empty());
}

// A joint between two faces does not feel that both move together.
TEST(UnheldParts, OnBothSidesOfAJointBetweenFacesMoveTogether) {
  BoxAssembly bar({{"left", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {"right", {1, 0, 0}, {2, 1, 1}, {2, 2, 2}}});
  holdFace(bar, {"left_xmin"},
           laws::makeLaw("Remote Displacement", {{"Y", 0.0}, {"Z", 0.0}, {"Rotation Y", 0.0}, {"Rotation Z", 0.0}}));
  holdFace(bar, {"left_xmax"},
           laws::makeLaw("Face Spring", {{"Axial Stiffness", 500.0}}, {},
                         {{"Point", {1.0, 0.5, 0.5}}, {"Axis", {1.0, 0.0, 0.0}}}),
           {"right_xmin"});
  bar.hold("end", "right_xmax", push(0.0, 1.0));
  const auto remarks = remarksOn(bar);
  ASSERT_EQ(remarks.size(), 1U);
  for (const char* part : {"parts \"left\", \"right\"", "along (1, 0, 0)", "turning about (1, 0, 0)"})
    EXPECT_NE(remarks[0].find(part), std::string::npos) << remarks[0];
}

TEST(UnheldParts, AreNamedWithTheirLoadSteps) {
  const Law top = laws::makeLaw("Prescribed Traction", {{"Z", -1.0}}, {{"Z", {1.0, 2.0}}});
  const auto remarks = remarksOn(twoCubes(laws::makeLaw("Unilateral Contact"), top, 2));
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("load steps 1 to 2"), std::string::npos) << remarks[0];
}

/// Pressed and sheared, hardly pressed, and as at first again.
BoxAssembly relieved(double share) {
  return twoCubes(friction(0.2),
                  laws::makeLaw("Prescribed Traction", {{"X", 0.1}, {"Z", -2.0}},
                                {{"X", {1.0, 0.0, 1.0}}, {"Z", {1.0, share, 1.0}}}),
                  3);
}

/// A load that is small beside those of other load steps tells all the same where the part is that it presses down, and
/// so what friction makes of its place later.
TEST(UnheldParts, AreHeldByWhateverPressesThem) {
  for (const double share : {1e-2, 1e-4, 1e-6, 1e-9, 1e-12}) {
    base::Timers timers;
    BoxAssembly cubes = relieved(share);
    LatinSolver solver(cubes.assembly(), {}, self(), timers);
    const LatinResult result = solver.solve();
    EXPECT_EQ(result.outcome, Outcome::certified) << share << ": " << result.reason;
    EXPECT_TRUE(result.remarks.empty()) << share;
    const int node = static_cast<int>(cubes.assembly().bodies[1].nodes.size()) - 1;
    const auto at = [&](int step) { return solver.state().displacement(1, node, step); };
    const double size = base::norm(at(0));
    EXPECT_LT(base::norm(at(1)), 2.0 * share * size) << share;
    EXPECT_LT(base::distance(at(2), at(0)), 1e-3 * size) << share;
  }
}

TEST(UnheldParts, LeaveOpenWhatFrictionMakesOfTheirPlaceLater) {
  const auto remarks = remarksOn(relieved(0.0));
  ASSERT_EQ(remarks.size(), 1U);
  for (const char* part : {"upper", "load step 2:", "nor what friction makes of that place at later load steps"})
    EXPECT_NE(remarks[0].find(part), std::string::npos) << remarks[0];
}

}  // namespace
}  // namespace harmos::latin
