// What rigid statics says of the loads of assemblies before they are iterated.
#include <gtest/gtest.h>

#include <harmos/latin/LoadBalance.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"
#include "Faces.hpp"

namespace harmos::latin {
namespace {

using Law = std::shared_ptr<const laws::InterfaceLaw>;

Law contact() {
  return laws::makeLaw("Unilateral Contact");
}
Law friction(double mu) {
  return laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", mu}});
}
Law push(double x, double z) {
  return laws::makeLaw("Prescribed Traction", {{"X", x}, {"Z", z}});
}

/// Does not say what it can carry.
struct Silent {
  static constexpr const char* name = "Silent";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;
  laws::LocalState solve(const laws::LocalLine&, const laws::NodeContext&, const double*, double*) const { return {}; }
};

struct Answers {
  explicit Answers(const assembly::Assembly& assembly, int step = 0) {
    base::Timers timers;
    LoadBalance balance(assembly, *self(), timers);
    contradiction = balance.contradiction(step).value_or("");
    isSure = balance.isSure(step);
    hasForces = balance.hasForces(step);
  }
  std::string contradiction;  // "": none
  bool isSure = false, hasForces = false;
};

Answers answers(const Law& joint, const Law& top) {
  BoxAssembly cubes = twoCubes(joint, top);
  return Answers(cubes.assembly());
}

// The lower cube is clamped; the upper one moves by itself unless it is bonded.
TEST(LoadBalance, KnowsWhatMovesAsOne) {
  base::Timers timers;
  const auto bodiesOf = [&](const Law& joint) {
    BoxAssembly cubes = twoCubes(joint, push(0.0, -2.0));
    return LoadBalance(cubes.assembly(), *self(), timers).rigidBodies();
  };
  EXPECT_EQ(bodiesOf(contact()), (std::vector<int>{-1, 0}));
  EXPECT_EQ(bodiesOf(laws::makeLaw("Perfect")), (std::vector<int>{-1, -1}));
  BoxAssembly three({{"lower", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}},
                     {"middle", {0, 0, 1}, {1, 1, 2}, {2, 2, 2}},
                     {"upper", {0, 0, 2}, {1, 1, 3}, {2, 2, 2}}});
  three.hold("bottom", "lower_zmin", clamp());
  three.join("contact", "lower_zmax", "middle_zmin", contact());
  three.join("bond", "middle_zmax", "upper_zmin", laws::makeLaw("Perfect"));
  EXPECT_EQ(LoadBalance(three.assembly(), *self(), timers).rigidBodies(), (std::vector<int>{-1, 0, 0}));
}

// What moves as one is called by its parts, whatever pieces these are cut into.
TEST(LoadBalance, NamesPartsAndNotTheirPieces) {
  BoxAssembly three({{"lower", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}},
                     {"upper.1", {0, 0, 1}, {1, 1, 2}, {2, 2, 2}},
                     {"upper.2", {0, 0, 2}, {1, 1, 3}, {2, 2, 2}}});
  three.hold("bottom", "lower_zmin", clamp());
  three.join("contact", "lower_zmax", "upper.1_zmin", friction(0.2));
  three.join("cut", "upper.1_zmax", "upper.2_zmin", laws::makeLaw("Perfect"));
  three.hold("top", "upper.2_zmax", push(0.41, -2.0));
  assembly::Assembly assembly = three.assembly();
  EXPECT_NE(Answers(assembly).contradiction.find("parts \"upper.1\", \"upper.2\""), std::string::npos)
      << Answers(assembly).contradiction;
  for (const std::size_t piece : {1U, 2U}) assembly.bodies[piece].part = "upper";
  EXPECT_NE(Answers(assembly).contradiction.find("part \"upper\""), std::string::npos)
      << Answers(assembly).contradiction;
}

// 2 mu carries what is below it.
TEST(LoadBalance, KnowsTheLimitOfFriction) {
  const Answers below = answers(friction(0.2), push(0.39, -2.0));
  EXPECT_EQ(below.contradiction, "");
  EXPECT_TRUE(below.hasForces);
  EXPECT_FALSE(below.isSure);
  const Answers above = answers(friction(0.2), push(0.41, -2.0));
  EXPECT_NE(above.contradiction, "");
  EXPECT_FALSE(above.hasForces);
}

TEST(LoadBalance, IsSureWithoutFriction) {
  for (const Law& joint : {contact(), friction(0.0), friction(0.5), Law(laws::makeLaw("Perfect"))}) {
    const Answers pressed = answers(joint, push(0.0, -2.0));
    EXPECT_EQ(pressed.contradiction, "") << joint->name();
    EXPECT_TRUE(pressed.isSure) << joint->name();
  }
  EXPECT_TRUE(answers(laws::makeLaw("Perfect"), push(3.0, 2.0)).isSure);
}

// One programme answers for a ramp and for loads that stay, not for what turns them round.
TEST(LoadBalance, AsksOfLikeLoadsOnce) {
  const std::vector<double> factors = {0.0, 0.5, 1.0, 1.0, 0.7, -1.0, -1.0};
  BoxAssembly cubes = twoCubes(friction(0.2), laws::makeLaw("Prescribed Traction", {{"X", 0.1}}, {{"X", factors}}), 7);
  base::Timers timers;
  const LoadBalance balance(cubes.assembly(), *self(), timers);
  std::vector<int> like;
  for (int t = 0; t < 7; ++t) like.push_back(balance.largestLike(t));
  EXPECT_EQ(like, (std::vector<int>{-1, 2, 2, 2, 2, 5, 5}));
}

// Of loads that go round and come back with the factors 1, 2 and 3 the largest answers. That many load steps, compared
// with each other, would take hours.
TEST(LoadBalance, FindsLikeLoadsAmongManyLoadSteps) {
  const int ways = 50000, steps = 3 * ways;
  std::vector<double> x, z;
  for (int t = 0; t < steps; ++t) {
    const int round = t / ways;
    const double angle = 3.0 * (t % ways) / ways, factor = 1.0 + round;
    x.push_back(factor * std::cos(angle));
    z.push_back(factor * std::sin(angle));
  }
  const Law top = laws::makeLaw("Prescribed Traction", {{"X", 1.0}, {"Z", 1.0}}, {{"X", x}, {"Z", z}});
  BoxAssembly cubes({{"lower", {0, 0, 0}, {1, 1, 1}, {1, 1, 1}}, {"upper", {0, 0, 1}, {1, 1, 2}, {1, 1, 1}}}, steps);
  cubes.hold("bottom", "lower_zmin", clamp());
  cubes.join("contact", "lower_zmax", "upper_zmin", friction(0.2));
  cubes.hold("top", "upper_zmax", top);
  base::Timers timers;
  const LoadBalance balance(cubes.assembly(), *self(), timers);
  int others = 0;
  for (int t = 0; t < steps; ++t) others += balance.largestLike(t) == 2 * ways + t % ways ? 0 : 1;
  EXPECT_EQ(others, 0);
}

// A bolt that is tightened pulls at both sides with its force, and bears everything else.
TEST(LoadBalance, CountsForcesOfBolts) {
  const Law bolt = laws::makeLaw("Pretension", {{"Force", 2.0}});
  const Answers lifted = answers(bolt, push(0.0, 0.0));
  EXPECT_NE(lifted.contradiction.find("unbalanced force (0, 0, -2)"), std::string::npos) << lifted.contradiction;
  EXPECT_FALSE(lifted.hasForces);
  const Answers pulled = answers(bolt, push(0.0, 2.0));
  EXPECT_EQ(pulled.contradiction, "");
  EXPECT_TRUE(pulled.isSure);
  // With shear and the moment that it makes.
  EXPECT_EQ(answers(bolt, push(0.5, 2.0)).contradiction, "");
  EXPECT_NE(answers(bolt, push(0.5, 1.9)).contradiction, "");
}

/// Two cubes of one element, one above the other at a distance, the lower one clamped at its bottom; their faces are
/// pulled together by a bolt of force 2 along z, and the upper one by `top`.
BoxAssembly boltedCubes(double distance, const Law& top) {
  BoxAssembly cubes({{"lower", {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {1, 1, 1}},
                     {"upper", {0.0, 0.0, 1.0 + distance}, {1.0, 1.0, 2.0 + distance}, {1, 1, 1}}});
  cubes.hold("bottom", "lower_zmin", laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}));
  cubes.hold("top", "upper_zmax", top);
  if (distance == 0.0) cubes.join("contact", "lower_zmax", "upper_zmin", contact());
  input::Parameters spring("law");
  spring.set("Type", std::string("Face Spring")).set("Point", std::vector<double>{0.5, 0.5, 1.0 + 0.5 * distance});
  spring.set("Axis", std::vector<double>{0, 0, 1}).set("Force", 2.0);
  holdFace(cubes, {"lower_zmax"}, laws::builtInLaws().create(spring), {"upper_zmin"});
  return cubes;
}

// A bolt between two faces that are apart does the same.
TEST(LoadBalance, CountsForcesOfBoltsBetweenFaces) {
  BoxAssembly pulled = boltedCubes(0.5, push(0.0, 0.0));
  const Answers nothing(pulled.assembly());
  EXPECT_NE(nothing.contradiction.find("unbalanced force (0, 0, -2)"), std::string::npos) << nothing.contradiction;
  EXPECT_FALSE(nothing.hasForces);
  BoxAssembly lifted = boltedCubes(0.5, push(0.0, 2.0));
  EXPECT_EQ(Answers(lifted.assembly()).contradiction, "");
  BoxAssembly pressed = boltedCubes(0.0, push(0.0, 0.0));
  EXPECT_EQ(Answers(pressed.assembly()).contradiction, "");
  EXPECT_TRUE(Answers(pressed.assembly()).isSure);
  BoxAssembly open = boltedCubes(0.0, push(0.0, 3.0));
  EXPECT_NE(Answers(open.assembly()).contradiction, "");
}

/// A cube whose lower face is held in a point, with more numbers of the law, under a traction on its upper face.
BoxAssembly heldInAPoint(std::map<std::string, double> held, const Law& top) {
  BoxAssembly cube({{"cube", {0, 0, 0}, {1, 1, 1}, {1, 1, 1}}});
  held.insert({{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}});
  holdFace(cube, {"cube_zmin"}, laws::makeLaw("Remote Displacement", held));
  cube.hold("top", "cube_zmax", top);
  return cube;
}

// Displacements held in a point, but not rotations, make a hinge: it bears what goes through the point.
TEST(LoadBalance, OfAFaceHeldInAPointKnowsItsHinge) {
  EXPECT_TRUE(Answers(heldInAPoint({}, push(0.0, 1.0)).assembly()).isSure);
  const std::string turns = Answers(heldInAPoint({}, push(0.1, 1.0)).assembly()).contradiction;
  for (const char* part : {"moment about its centre (0, 0.1, 0)", "turning about (0, 1, 0) through (0.5, 0.5, 0)",
                           "left free by \"on cube_zmin\""})
    EXPECT_NE(turns.find(part), std::string::npos) << turns;
  for (const auto& more : std::vector<std::map<std::string, double>>{
           {{"Rotation Y", 0.0}}, {{"Rotation Y Stiffness", 1e-6}}, {{"Moment Y", -0.1}}}) {
    const Answers held(heldInAPoint(more, push(0.1, 1.0)).assembly());
    EXPECT_EQ(held.contradiction, "") << more.begin()->first;
    EXPECT_TRUE(held.isSure) << more.begin()->first;
  }
  for (const auto& more : std::vector<std::map<std::string, double>>{
           {{"Rotation X", 0.0}}, {{"Rotation Y Stiffness", 0.0}}, {{"Moment Y", -0.05}}}) {
    EXPECT_NE(Answers(heldInAPoint(more, push(0.1, 1.0)).assembly()).contradiction, "") << more.begin()->first;
  }
}

// All six held are a clamp, however it is given.
TEST(LoadBalance, OfAFaceHeldInAPointKnowsWhatIsClamped) {
  base::Timers timers;
  const std::map<std::string, double> all{{"Rotation X", 0.0}, {"Rotation Y", 0.0}, {"Rotation Z", 0.0}};
  EXPECT_EQ(LoadBalance(heldInAPoint(all, push(1.0, 1.0)).assembly(), *self(), timers).rigidBodies(),
            std::vector<int>{-1});
  EXPECT_EQ(LoadBalance(heldInAPoint({{"Rotation X", 0.0}}, push(1.0, 1.0)).assembly(), *self(), timers).rigidBodies(),
            std::vector<int>{0});
}

/// Two cubes beside each other at a distance of 1 whose lower faces are one face that is clamped in a point, under
/// forces along z of which the second is given.
BoxAssembly clampedTogether(const std::string& kind, double second) {
  BoxAssembly cubes({{"a", {0, 0, 0}, {1, 1, 1}, {1, 1, 1}}, {"b", {2, 0, 0}, {3, 1, 1}, {1, 1, 1}}});
  input::Parameters law("law");
  law.set("Type", std::string("Remote Displacement")).set("Kind", kind);
  for (const char* held : {"X", "Y", "Z", "Rotation X", "Rotation Y", "Rotation Z"}) law.set(held, 0.0);
  holdFace(cubes, {"a_zmin", "b_zmin"}, laws::builtInLaws().create(law));
  cubes.hold("on a", "a_zmax", push(0.0, 1.0));
  cubes.hold("on b", "b_zmax", push(0.0, second));
  return cubes;
}

// The mean motion of two bodies is held, not each of them; a face that is rigid holds both.
TEST(LoadBalance, OfAFaceOfTwoBodiesKnowsItsKind) {
  EXPECT_EQ(Answers(clampedTogether("Rigid", -3.0).assembly()).contradiction, "");
  EXPECT_NE(Answers(clampedTogether("Distributing", -3.0).assembly()).contradiction, "");
}

// Springs that are left out leave the joint between two faces free.
TEST(LoadBalance, OfAJointBetweenFacesKnowsWhatItLeavesFree) {
  const auto contradictionOf = [](const std::map<std::string, double>& springs, const Law& top) {
    BoxAssembly cubes({{"lower", {0, 0, 0}, {1, 1, 1}, {1, 1, 1}}, {"upper", {0, 0, 2}, {1, 1, 3}, {1, 1, 1}}});
    cubes.hold("bottom", "lower_zmin", laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}));
    holdFace(cubes, {"lower_zmax"},
             laws::makeLaw("Face Spring", springs, {}, {{"Point", {0.5, 0.5, 1.5}}, {"Axis", {0.0, 0.0, 1.0}}}),
             {"upper_zmin"});
    cubes.hold("top", "upper_zmax", top);
    return Answers(cubes.assembly()).contradiction;
  };
  EXPECT_EQ(contradictionOf({}, push(1.0, 1.0)), "");
  EXPECT_EQ(contradictionOf({{"Bending Stiffness", 1e-6}}, push(1.0, 1.0)), "");
  EXPECT_EQ(contradictionOf({{"Bending Stiffness", 0.0}}, push(0.0, 1.0)), "");
  const std::string turns = contradictionOf({{"Bending Stiffness", 0.0}}, push(1.0, 1.0));
  for (const char* part : {"part \"upper\"", "turning about (0, 1, 0) through (0.5, 0.5, 1.5)", "left free by"})
    EXPECT_NE(turns.find(part), std::string::npos) << turns;
  EXPECT_EQ(contradictionOf({{"Axial Stiffness", 0.0}}, push(1.0, 0.0)), "");
  EXPECT_NE(contradictionOf({{"Axial Stiffness", 0.0}}, push(1.0, 1.0)), "");
}

// What a joint between two faces that move together does not feel is free.
TEST(LoadBalance, OfAJointBetweenFacesKnowsThatBothMoveTogether) {
  const auto contradictionOf = [](const std::map<std::string, double>& springs, const Law& right) {
    BoxAssembly bar({{"left", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {"right", {1, 0, 0}, {2, 1, 1}, {2, 2, 2}}});
    holdFace(bar, {"left_xmin"},
             laws::makeLaw("Remote Displacement", {{"Y", 0.0}, {"Z", 0.0}, {"Rotation Y", 0.0}, {"Rotation Z", 0.0}}));
    holdFace(bar, {"left_xmax"},
             laws::makeLaw("Face Spring", springs, {}, {{"Point", {1.0, 0.5, 0.5}}, {"Axis", {1.0, 0.0, 0.0}}}),
             {"right_xmin"});
    bar.hold("end", "right_xmax", right);
    return Answers(bar.assembly()).contradiction;
  };
  for (const auto& springs : std::vector<std::map<std::string, double>>{
           {}, {{"Axial Stiffness", 500.0}}, {{"Shear Stiffness", 500.0}, {"Torsion Stiffness", 500.0}}}) {
    const std::string pulled = contradictionOf(springs, push(1.0, 0.0));
    EXPECT_NE(pulled.find("parts \"left\", \"right\" along (1, 0, 0), left free by"), std::string::npos) << pulled;
    EXPECT_EQ(contradictionOf(springs, push(0.0, 1.0)), "");
  }
}

// A piece whose share of a rigid face is nearly a line is joined to the others by its cut, and moves with them.
TEST(LoadBalance, OfARigidFaceKnowsWhatItLeavesOfPieces) {
  const auto contradictionOf = [](const std::map<std::string, double>& more) {
    BoxAssembly part({{"left", {0, 0, 0}, {1, 1, 1}, {1, 1, 1}}, {"right", {1, 0, 0}, {2, 1, 1}, {1, 1, 1}}});
    part.deform("right", [](const base::Vector3& x) {
      return base::Vector3{1.0 + (x[0] - 1.0) * std::max(x[2], 1e-7), x[1], x[2]};
    });
    part.join("cut", "left_xmax", "right_xmin", laws::makeLaw("Perfect"));
    input::Parameters law("law");
    law.set("Type", std::string("Remote Displacement")).set("Kind", std::string("Rigid"));
    for (const char* held : {"X", "Y", "Z", "Rotation Z"}) law.set(held, 0.0);
    for (const auto& [name, value] : more) law.set(name, value);
    holdFace(part, {"left_zmin", "right_zmin"}, laws::builtInLaws().create(law));
    part.hold("end", "right_zmax", push(0.0, 1.0));
    return Answers(part.assembly()).contradiction;
  };
  EXPECT_EQ(contradictionOf({{"Rotation X", 0.0}, {"Rotation Y", 0.0}}), "");
  const std::string turns = contradictionOf({{"Rotation X", 0.0}});
  EXPECT_NE(turns.find("turning about (0, -1, 0) through (0.5, 0.5, 0)"), std::string::npos) << turns;
}

TEST(LoadBalance, NamesPartLoadStepAndMotion) {
  const Answers lifted = answers(friction(0.5), push(0.0, 2.0));
  for (const char* part : {"load step 1", "unbalanced force (0, 0, ", "along (0, 0, 1), leaving"})
    EXPECT_NE(lifted.contradiction.find(part), std::string::npos) << lifted.contradiction;
  const Answers pushed = answers(contact(), push(0.1, -2.0));
  for (const char* part : {"along (1, 0, 0), sliding along"})
    EXPECT_NE(pushed.contradiction.find(part), std::string::npos) << pushed.contradiction;
}

// The same cubes: only the third load step has a pull.
TEST(LoadBalance, LooksAtEveryLoadStepByItself) {
  const Law growing = laws::makeLaw("Prescribed Traction", {{"Z", 2.0}}, {{"Z", {-1.0, 0.0, 1.0}}});
  BoxAssembly cubes = twoCubes(contact(), growing, 3);
  EXPECT_EQ(Answers(cubes.assembly(), 0).contradiction, "");
  EXPECT_EQ(Answers(cubes.assembly(), 1).contradiction, "");
  EXPECT_NE(Answers(cubes.assembly(), 2).contradiction, "");
}

TEST(LoadBalance, ClaimsNothingOfLawsThatAreSilent) {
  const Answers silent = answers(std::make_shared<laws::PointwiseLaw<Silent>>(), push(3.0, 2.0));
  EXPECT_EQ(silent.contradiction, "");
  EXPECT_FALSE(silent.isSure);
  EXPECT_FALSE(silent.hasForces);
}

// A formula does not say what it can carry, but where it is 0 that it carries nothing.
TEST(LoadBalance, KnowsWhereAFormulaGivesNothing) {
  const auto springs = [](const std::string& along) {
    input::Parameters law("law");
    law.set("Type", std::string("Formula")).set("Normal Traction", std::string("100 * jump_n"));
    law.set("Tangential Traction 1", along).set("Tangential Traction 2", along);
    law.set("Lowest Slope", 0.0).set("Dissipates", false);
    return Law(laws::builtInLaws().create(law));
  };
  for (const std::string nothing : {"0", "0 * jump_1", "-(1 - 1) * max(jump_1, jump_2)"}) {
    EXPECT_EQ(answers(springs(nothing), push(0.0, 1.0)).contradiction, "") << nothing;
    const std::string slides = answers(springs(nothing), push(1.0, 1.0)).contradiction;
    EXPECT_NE(slides.find("along (1, 0, 0), sliding along"), std::string::npos) << nothing << ": " << slides;
  }
  for (const std::string little : {"1e-30 * jump_1", "max(0, jump_1 - 1e9)", "jump_1 > 1e9 ? jump_1 - 1e9 : 0"})
    EXPECT_EQ(answers(springs(little), push(1.0, 1.0)).contradiction, "") << little;
}

// Tipping: the pressure on the top beside the base of a cube that leans over by more than its width.
TEST(LoadBalance, KnowsWhatTipsOver) {
  for (const double lean : {0.4, 1.6}) {
    BoxAssembly cubes({{"lower", {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {1, 1, 1}},
                       {"upper", {0.0, 0.0, 1.0}, {1.0, 1.0, 2.0}, {1, 1, 1}}});
    cubes.deform("upper", [lean](const base::Vector3& x) { return x + base::Vector3{lean * (x[2] - 1.0), 0.0, 0.0}; });
    const Law all = laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}});
    cubes.join("contact", "lower_zmax", "upper_zmin", friction(100.0));
    cubes.hold("bottom", "lower_zmin", all);
    cubes.hold("top", "upper_zmax", push(0.0, -1.0));
    const std::string contradiction = Answers(cubes.assembly()).contradiction;
    EXPECT_EQ(contradiction.empty(), lean < 0.5) << contradiction;
    EXPECT_EQ(contradiction.find("turning about (0, ") != std::string::npos, lean > 0.5) << contradiction;
  }
}

// The chains resist turns and bear no moment of the joint; along x they are free.
TEST(LoadBalance, LeavesToAMatrixWhatItResists) {
  EXPECT_NE(Answers(twoChains(contact(), push(2.5, 0.0))).contradiction, "");
  assembly::Assembly grounded = twoChains(contact(), push(2.5, 0.0));
  const substructure::CrsView free = substructure::viewOf(*grounded.bodies[1].stiffness, "right");
  std::vector<std::size_t> pointers(free.rowPointers, free.rowPointers + free.rows + 1);
  std::vector<int> columns(free.columns, free.columns + pointers.back());
  std::vector<double> values(free.values, free.values + pointers.back());
  for (std::size_t at = pointers[0]; at < pointers[1]; ++at) {
    if (columns[at] == 0) values[at] *= 1.001;
  }
  grounded.bodies[1].stiffness = substructure::makeCrsMatrix(pointers, columns, values);
  EXPECT_EQ(Answers(grounded).contradiction, "");
}

}  // namespace
}  // namespace harmos::latin
