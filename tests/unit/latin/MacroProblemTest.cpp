#include <cmath>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/latin/FixedPoint.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"
#include "Faces.hpp"

namespace harmos::latin {
namespace {

/// Keeps the pairs of the joint for which `keep` is true.
template <class Keep>
void restrictJoint(assembly::Assembly& assembly, int index, const Keep& keep) {
  assembly::Interface& joint = assembly.interfaces[index];
  assembly::Interface kept = joint;
  kept.trace1 = kept.trace2 = {};
  kept.position.clear(), kept.frame.clear(), kept.area.clear(), kept.gap.clear();
  for (int p = 0; p < joint.pairs(); ++p) {
    if (!keep(joint.position[p])) continue;
    kept.trace1.append({{joint.trace1.node(p), 1.0}});
    kept.trace2.append({{joint.trace2.node(p), 1.0}});
    kept.position.push_back(joint.position[p]);
    kept.frame.push_back(joint.frame[p]);
    kept.area.push_back(joint.area[p]);
    kept.gap.push_back(joint.gap[p]);
  }
  joint = kept;
}

/// Unknowns of the macro problem of two cubes that meet at some nodes only; checks the balance of forces there.
template <class Keep>
int unknowns(const Keep& keep) {
  BoxAssembly cubes = twoCubes(laws::makeLaw("Perfect"), laws::makeLaw("Symmetry"));
  assembly::Assembly& assembly = cubes.assembly();
  restrictJoint(assembly, 1, keep);
  base::Timers timers;
  FixedPoint fixedPoint(assembly, {}, self(), timers);
  const TraceLayout& layout = fixedPoint.layout();
  base::Matrix alpha(layout.rows(), 1), image(layout.rows(), 1);
  randomize(alpha);
  const Iterate& iterate = fixedPoint.apply(alpha, image);
  base::Vector3 sum{};
  for (int side = 0; side < 2; ++side) {
    for (int row = 0; row < 3 * assembly.interfaces[1].pairs(); ++row) {
      sum[row % 3] += assembly.interfaces[1].area[row / 3] * iterate.traction()[0][layout.begin(1, side) + row];
    }
  }
  for (double component : sum) EXPECT_NEAR(component, 0.0, 1e-11);
  return fixedPoint.linearStage().macroUnknowns();
}

TEST(MacroProblem, LeavesOutMotionsThatAnInterfaceCannotFeel) {
  EXPECT_EQ(unknowns([](const base::Vector3&) { return true; }), 6);
  EXPECT_EQ(unknowns([](const base::Vector3& x) { return x[0] == 0.0; }), 5);  // a line
  EXPECT_EQ(unknowns([](const base::Vector3& x) { return x[0] == 0.0 && x[1] == 0.0; }), 3);
  EXPECT_EQ(unknowns([](const base::Vector3& x) { return x[0] == x[1]; }), 5);  // a diagonal
}

/// Unknowns of the macro problem of a bar of 1 x 1 on another one, joined along their length.
int unknownsAlong(double length, int cells, const std::string& law, bool isConsistent = false) {
  BoxAssembly bars(
      {{"lower", {0, 0, 0}, {length, 1, 1}, {cells, 1, 1}}, {"upper", {0, 0, 1}, {length, 1, 2}, {cells, 1, 1}}});
  bars.hold("end", "lower_xmin", laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}),
            isConsistent);
  bars.join("seam", "lower_zmax", "upper_zmin", laws::makeLaw(law), isConsistent);
  base::Timers timers;
  return FixedPoint(bars.assembly(), {}, self(), timers).linearStage().macroUnknowns();
}

// Patches of 5 x 1; no more than sixteen, none of fewer than twelve pairs, and none where nothing bonds.
TEST(MacroProblem, BalancesSlenderFacesPatchByPatch) {
  EXPECT_EQ(unknownsAlong(15.0, 60, "Perfect"), 6);
  EXPECT_EQ(unknownsAlong(40.0, 80, "Perfect"), 8 * 6);
  EXPECT_EQ(unknownsAlong(40.0, 40, "Perfect"), 4 * 6);
  EXPECT_EQ(unknownsAlong(600.0, 200, "Perfect"), 16 * 6);
  EXPECT_EQ(unknownsAlong(40.0, 80, "Unilateral Contact"), 6);
  EXPECT_EQ(unknownsAlong(40.0, 80, "Perfect", true), 6);
}

TEST(MacroProblem, HasThreeUnknownsInThePlane) {
  for (bool onePoint : {false, true}) {
    BoxAssembly boxes({{"lower", {0, 0}, {1, 1}, {2, 2}, mesh::ElementType::quad4},
                       {"upper", {0, 1}, {1, 2}, {2, 2}, mesh::ElementType::quad4}});
    boxes.hold("bottom", "lower_ymin", clamp());
    boxes.join("joint", "lower_ymax", "upper_ymin", laws::makeLaw("Perfect"));
    boxes.hold("top", "upper_ymax", laws::makeLaw("Symmetry"));
    if (onePoint) restrictJoint(boxes.assembly(), 1, [](const base::Vector3& x) { return x[0] == 0.0; });
    base::Timers timers;
    const FixedPoint fixedPoint(boxes.assembly(), {}, self(), timers);
    EXPECT_EQ(fixedPoint.linearStage().macroUnknowns(), onePoint ? 2 : 3);
  }
}

TEST(MacroProblem, NamesWhatFloats) {
  BoxAssembly cubes({{"held", {0, 0, 0}, {1, 1, 1}, {1, 1, 1}},
                     {"first", {0, 0, 2}, {1, 1, 3}, {1, 1, 1}},
                     {"second", {0, 0, 3}, {1, 1, 4}, {1, 1, 1}}});
  cubes.hold("bottom", "held_zmin", clamp());
  cubes.join("joint", "first_zmax", "second_zmin", laws::makeLaw("Perfect"));
  cubes.hold("pull", "second_zmax", laws::makeLaw("Prescribed Traction", {{"Z", 1.0}}));
  base::Timers timers;
  try {
    const FixedPoint fixedPoint(cubes.assembly(), {}, self(), timers);
    FAIL();
  } catch (const base::Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.code(), base::ExitCode::noEquilibrium);
    EXPECT_NE(message.find("\"first\""), std::string::npos) << message;
    EXPECT_NE(message.find("\"second\""), std::string::npos) << message;
    EXPECT_EQ(message.find("\"held\""), std::string::npos) << message;
  }
}

/// So many bodies, 40 times as long as thick, glued to each other one above the other, the last one by `last`; the
/// lowest is held, or not.
BoxAssembly mast(int bodies, bool isHeld, const std::string& last = "Perfect") {
  std::vector<mesh::Box> boxes;
  for (int i = 0; i < bodies; ++i)
    boxes.push_back({std::to_string(i), {0, 0, 40.0 * i}, {1, 1, 40.0 * (i + 1)}, {1, 1, 40}});
  BoxAssembly mast(boxes);
  if (isHeld) mast.hold("bottom", "0_zmin", clamp());
  for (int i = 1; i < bodies; ++i) {
    mast.join("joint " + std::to_string(i), std::to_string(i - 1) + "_zmax", std::to_string(i) + "_zmin",
              laws::makeLaw(i + 1 < bodies ? "Perfect" : last));
  }
  mast.hold("top", std::to_string(bodies - 1) + "_zmax", laws::makeLaw("Prescribed Traction", {{"X", 1.0}}));
  return mast;
}

// Its numbers look like those of one that nothing holds, see noStiffness.
TEST(MacroProblem, HoldsALongChain) {
  BoxAssembly held = mast(170, true);
  base::Timers timers;
  EXPECT_GT(FixedPoint(held.assembly(), {}, self(), timers).linearStage().softness(), 1e13);
  for (const char* last : {"Perfect", "Unilateral Contact"}) {
    BoxAssembly loose = mast(170, false, last);
    try {
      const FixedPoint fixedPoint(loose.assembly(), {}, self(), timers);
      FAIL();
    } catch (const base::Error& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("nothing holds part(s)"), std::string::npos) << message;
      EXPECT_NE(message.find(" more: "), std::string::npos) << message;
    }
  }
}

// Its macro problem is as regular whatever the laws of its joints.
TEST(MacroProblem, HoldsALongChainThatAContactOrAPointHolds) {
  base::Timers timers;
  BoxAssembly touching = mast(170, true, "Unilateral Contact");
  EXPECT_GT(FixedPoint(touching.assembly(), {}, self(), timers).linearStage().softness(), 1e13);
  BoxAssembly inAPoint = mast(170, false);
  holdFace(inAPoint, {"0_zmin"}, laws::makeLaw("Remote Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}));
  EXPECT_GT(FixedPoint(inAPoint.assembly(), {}, self(), timers).linearStage().softness(), 1e13);
}

// A body between two interfaces that touches nothing else, and a scene whose interfaces all are boundaries.
TEST(MacroProblem, TakesBodiesWithoutBoundariesAndWithoutInterfaces) {
  BoxAssembly cubes({{"a", {0, 0, 0}, {1, 1, 1}, {1, 1, 1}},
                     {"b", {0, 0, 1}, {1, 1, 2}, {1, 1, 1}},
                     {"c", {0, 0, 2}, {1, 1, 3}, {1, 1, 1}}});
  cubes.hold("bottom", "a_zmin", clamp());
  cubes.join("ab", "a_zmax", "b_zmin", laws::makeLaw("Perfect"));
  cubes.join("bc", "b_zmax", "c_zmin", laws::makeLaw("Perfect"));
  base::Timers timers;
  EXPECT_EQ(FixedPoint(cubes.assembly(), {}, self(), timers).linearStage().macroUnknowns(), 12);

  BoxAssembly alone({{"a", {0, 0, 0}, {1, 1, 1}, {1, 1, 1}}});
  alone.hold("bottom", "a_zmin", clamp());
  EXPECT_EQ(FixedPoint(alone.assembly(), {}, self(), timers).linearStage().macroUnknowns(), 0);
}

// Responses are kept where loads have acted at first only.
TEST(MacroProblem, TakesLoadsThatActElsewhereThanAtFirst) {
  BoxAssembly cubes = twoCubes(laws::makeLaw("Perfect"), laws::makeLaw("Prescribed Traction", {{"Z", 1.0}}));
  const assembly::Assembly& assembly = cubes.assembly();
  base::Timers timers;
  FixedPoint fixedPoint(assembly, {}, self(), timers);
  const TraceLayout& layout = fixedPoint.layout();
  std::vector<base::Matrix> loads, held;
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    loads.emplace_back(3 * static_cast<int>(assembly.bodies[b].nodes.size()), 1);
    held.push_back(loads.back());
    randomize(loads.back(), static_cast<unsigned>(b));
  }
  fixedPoint.setLoads(loads, held);
  base::Matrix alpha(layout.rows(), 1), beta(alpha);
  fixedPoint.solveLinear(alpha, beta);
  base::Vector3 sum{}, size{};
  for (int side = 0; side < 2; ++side) {
    for (int row = 0; row < 3 * assembly.interfaces[1].pairs(); ++row) {
      const double traction = fixedPoint.linearStage().traction()[0][layout.begin(1, side) + row];
      sum[row % 3] += assembly.interfaces[1].area[row / 3] * traction;
      size[row % 3] += assembly.interfaces[1].area[row / 3] * std::abs(traction);
    }
  }
  for (int c = 0; c < 3; ++c) {
    EXPECT_GT(size[c], 0.1);
    EXPECT_NEAR(sum[c], 0.0, 1e-11);
  }
}

}  // namespace
}  // namespace harmos::latin
