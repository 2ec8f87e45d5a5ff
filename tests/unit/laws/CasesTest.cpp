// What each law describes, by hand; and the limits in which one law becomes another.
#include <cmath>

#include <gtest/gtest.h>

#include "LawSamples.hpp"

namespace harmos::laws {
namespace {

constexpr double roundOff = 1e-14;

TEST(Perfect, ClosesTheJump) {
  const auto law = makeLaw("Perfect");
  const LocalLine line{{0.2, -0.4, 0.6}, 0.5};
  const LocalState state = Node(*law).solve(line);
  for (double jump : line.jump(state.traction)) EXPECT_NEAR(jump, 0.0, roundOff);
  EXPECT_NEAR(state.traction[1], -0.8, roundOff);
  EXPECT_EQ(state.status, Status::bonded);
}

TEST(UnilateralContact, OpensAndCloses) {
  const auto law = makeLaw("Unilateral Contact", {{"Gap", 0.1}});
  Node node(*law, 0.2);  // 0.3 in all
  const LocalState open = node.solve({{-0.25, 1.0, 1.0}, 2.0});
  EXPECT_EQ(open.traction, base::Vector3{});
  EXPECT_EQ(open.status, Status::open);
  const LocalLine line{{-0.5, 1.0, 1.0}, 2.0};
  const LocalState closed = node.solve(line);
  EXPECT_NEAR(closed.traction[0], -0.1, roundOff);
  EXPECT_NEAR(line.jump(closed.traction)[0], -0.3, roundOff);
  EXPECT_EQ(closed.traction[1], 0.0);
  EXPECT_EQ(closed.status, Status::slip);
}

TEST(UnilateralContact, InterferencePushes) {
  const auto law = makeLaw("Unilateral Contact", {{"Gap", -0.1}});
  EXPECT_NEAR(Node(*law).solve({{0.0, 0.0, 0.0}, 2.0}).traction[0], -0.05, roundOff);
}

TEST(CoulombFriction, SticksUntilTheCone) {
  const auto law = makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.5}});
  Node node(*law);
  const LocalLine sticking{{-4.0, 0.6, -0.8}, 2.0};  // pressure 2, limit 1
  const LocalState stick = node.solve(sticking);
  EXPECT_EQ(stick.status, Status::stick);
  EXPECT_NEAR(stick.traction[1], 0.3, roundOff);
  EXPECT_NEAR(stick.traction[2], -0.4, roundOff);
  EXPECT_NEAR(tangentialNorm(sticking.jump(stick.traction)), 0.0, roundOff);

  const LocalLine sliding{{-4.0, 6.0, -8.0}, 2.0};
  const LocalState slip = node.solve(sliding);
  EXPECT_EQ(slip.status, Status::slip);
  EXPECT_NEAR(slip.traction[1], 0.6, roundOff);
  EXPECT_NEAR(slip.traction[2], -0.8, roundOff);
  const base::Vector3 jump = sliding.jump(slip.traction);
  EXPECT_NEAR(jump[1], 4.8, roundOff);
  EXPECT_NEAR(jump[2], -6.4, roundOff);
}

// Only the slip of the load step counts: after sliding out, the way back starts by sticking where the node is.
TEST(CoulombFriction, RemembersWhereItStopped) {
  const auto law = makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.5}});
  Node node(*law);
  const LocalLine out{{-4.0, 5.0, 0.0}, 2.0};
  const LocalState sliding = node.solve(out);
  EXPECT_NEAR(out.jump(sliding.traction)[1], 3.0, roundOff);
  node.accept();
  const LocalLine back{{-4.0, 2.0, 0.0}, 2.0};
  const LocalState sticking = node.solve(back);
  EXPECT_EQ(sticking.status, Status::stick);
  EXPECT_NEAR(sticking.traction[1], -0.5, roundOff);
  EXPECT_NEAR(back.jump(sticking.traction)[1], 3.0, roundOff);
}

// An open node forgets nothing of its motion: it sticks where it lands.
TEST(CoulombFriction, SticksWhereItLands) {
  const auto law = makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.5}});
  Node node(*law);
  node.solve({{1.0, 7.0, 3.0}, 2.0});
  node.accept();
  const LocalState landed = node.solve({{-4.0, 7.0, 3.0}, 2.0});
  EXPECT_EQ(landed.status, Status::stick);
  EXPECT_NEAR(tangentialNorm(landed.traction), 0.0, roundOff);
}

// Friction that falls from step to step: the same slip costs less, and what stuck before slides.
TEST(CoulombFriction, FollowsACoefficientThatFalls) {
  const auto law = makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.5}}, {{"Friction Coefficient", {1.0, 0.1}}});
  Node node(*law);
  const LocalLine line{{-4.0, 1.0, 0.0}, 2.0};
  EXPECT_EQ(node.solve(line, 0).status, Status::stick);
  node.accept();
  const LocalState later = node.solve(line, 1);
  EXPECT_EQ(later.status, Status::slip);
  EXPECT_NEAR(later.traction[1], 0.1, roundOff);
}

TEST(CoulombFriction, WithoutFrictionIsUnilateralContact) {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const double gap = uniform(random, -1.0, 1.0), opening = uniform(random, -1.0, 1.0);
    const auto friction = makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.0}, {"Gap", gap}});
    const auto contact = makeLaw("Unilateral Contact", {{"Gap", gap}});
    Node node(*friction, opening), other(*contact, opening);
    for (int step = 0; step < 3; ++step) {
      const LocalLine line = randomLine(random);
      const LocalState found = node.solve(line), expected = other.solve(line);
      EXPECT_EQ(found.traction, expected.traction);
      EXPECT_EQ(found.status, expected.status);
      node.accept();
      other.accept();
    }
  }
}

TEST(CoulombFriction, WithUnlimitedFrictionSticks) {
  const auto law = makeLaw("Coulomb Friction", {{"Friction Coefficient", 1e12}});
  const auto perfect = makeLaw("Perfect");
  const LocalLine line{{-1e-3, 5.0, -3.0}, 0.7};
  const LocalState state = Node(*law).solve(line);
  EXPECT_EQ(state.status, Status::stick);
  EXPECT_NEAR(norm(state.traction - Node(*perfect).solve(line).traction), 0.0, roundOff * 10.0);
}

// A sliding node loses mu p times its way, whatever the path's pieces.
TEST(CoulombFriction, LosesTheWorkOfSliding) {
  const auto law = makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}});
  Node node(*law);
  double work = 0.0, old = 0.0;
  for (double target : {1.0, 3.0, 2.0, -1.0}) {
    // Pressure 1 on a line with H = 1; the free jump lies mu p H beyond the way that the node shall go.
    const LocalLine line{{-1.0, target + (target > old ? 0.3 : -0.3), 0.0}, 1.0};
    const LocalState state = node.solve(line);
    const double jump = line.jump(state.traction)[1];
    EXPECT_NEAR(jump, target, roundOff * 10.0);
    work += state.traction[1] * (jump - old);
    old = jump;
    node.accept();
  }
  EXPECT_NEAR(work, 0.3 * (1.0 + 2.0 + 1.0 + 3.0), 1e-13);
}

TEST(PreloadJump, DrawsTheFacesTogether) {
  const auto law = makeLaw("Preload Jump", {{"Jump", 0.05}});
  const LocalLine line{{0.0, 0.0, 0.0}, 0.1};
  const LocalState state = Node(*law).solve(line);
  EXPECT_NEAR(state.traction[0], 0.5, roundOff);  // tension
  EXPECT_NEAR(line.jump(state.traction)[0], -0.05, roundOff);
  const auto none = makeLaw("Preload Jump", {{"Jump", 0.0}});
  const LocalLine any{{0.3, -0.2, 0.1}, 0.1};
  EXPECT_EQ(Node(*none).solve(any).traction, Node(*makeLaw("Perfect")).solve(any).traction);
}

TEST(LinearElastic, IsASpringInEachDirection) {
  const auto law = makeLaw("Linear Elastic", {{"Normal Stiffness", 2.0}, {"Tangential Stiffness", 0.5}});
  const LocalLine line{{0.4, -0.6, 0.8}, 3.0};
  const LocalState state = Node(*law).solve(line);
  const base::Vector3 jump = line.jump(state.traction);
  EXPECT_NEAR(state.traction[0], 2.0 * jump[0], roundOff);
  EXPECT_NEAR(state.traction[1], 0.5 * jump[1], roundOff);
  EXPECT_NEAR(state.traction[2], 0.5 * jump[2], roundOff);
}

TEST(LinearElastic, BetweenFreeAndPerfect) {
  const LocalLine line{{0.4, -0.6, 0.8}, 3.0};
  const base::Vector3 perfect = Node(*makeLaw("Perfect")).solve(line).traction;
  for (double stiffness : {1e6, 1e12, 1e300}) {
    const auto law = makeLaw("Linear Elastic", {{"Normal Stiffness", stiffness}, {"Tangential Stiffness", stiffness}});
    EXPECT_LE(norm(Node(*law).solve(line).traction - perfect), norm(perfect) / stiffness + roundOff);
  }
  for (double stiffness : {0.0, 1e-12, 1e-300}) {
    const auto law = makeLaw("Linear Elastic", {{"Normal Stiffness", stiffness}, {"Tangential Stiffness", stiffness}});
    EXPECT_LE(norm(Node(*law).solve(line).traction), 1.1 * stiffness);
  }
}

TEST(ElasticFoundation, PullsBackToTheGround) {
  const auto law = makeLaw("Elastic Foundation", {{"Normal Stiffness", 2.0}, {"Tangential Stiffness", 0.0}});
  // The ground is side 2: a body that moved by w1 = -0.5 along n has the jump 0.5.
  const LocalLine line{{0.5, 0.5, 0.0}, 1e-12};
  const LocalState state = Node(*law).solve(line);
  EXPECT_NEAR(state.traction[0], 1.0, 1e-11);
  EXPECT_EQ(state.traction[1], 0.0);
  const auto rigid = makeLaw("Elastic Foundation", {{"Normal Stiffness", 1e300}, {"Tangential Stiffness", 0.0}});
  const LocalLine any{{0.3, -0.2, 0.1}, 2.0};
  EXPECT_NEAR(norm(Node(*rigid).solve(any).traction - Node(*makeLaw("Symmetry")).solve(any).traction), 0.0, roundOff);
}

TEST(Symmetry, HoldsTheNormalOnly) {
  const auto law = makeLaw("Symmetry");
  const LocalLine line{{0.3, -0.2, 0.1}, 2.0};
  const LocalState state = Node(*law).solve(line);
  EXPECT_NEAR(line.jump(state.traction)[0], 0.0, roundOff);
  EXPECT_EQ(state.traction[1], 0.0);
  EXPECT_EQ(state.traction[2], 0.0);
}

TEST(PrescribedDisplacement, MovesWhatIsGivenAndFreesTheRest) {
  const auto law = makeLaw("Prescribed Displacement", {{"X", 0.2}, {"Z", 0.0}});
  EXPECT_EQ(law->frame(), Frame::global);
  const LocalLine line{{0.3, -0.2, 0.1}, 2.0};
  const LocalState state = Node(*law).solve(line);
  const base::Vector3 jump = line.jump(state.traction);
  EXPECT_NEAR(-jump[0], 0.2, roundOff);  // w1 = -jump
  EXPECT_EQ(state.traction[1], 0.0);
  EXPECT_NEAR(-jump[2], 0.0, roundOff);
}

TEST(PrescribedTraction, IsWhatItSays) {
  const auto law = makeLaw("Prescribed Traction", {{"X", 1.0}, {"Y", 2.0}, {"Z", -3.0}});
  EXPECT_TRUE(law->prescribesTraction());
  EXPECT_EQ(Node(*law).solve({}).traction, (base::Vector3{1.0, 2.0, -3.0}));
}

TEST(Pressure, PushesAgainstTheOutwardNormal) {
  const auto law = makeLaw("Pressure", {{"Pressure", 4.0}});
  EXPECT_TRUE(law->prescribesTraction());
  EXPECT_EQ(law->frame(), Frame::interface);
  EXPECT_EQ(Node(*law).solve({}).traction, (base::Vector3{-4.0, 0.0, 0.0}));
}

/// A host's law with nothing but what must be given.
struct Sparse {
  static constexpr const char* name = "Sparse";
  static constexpr int historySize = 1;
  static constexpr Sides sides = Sides::any;
  explicit Sparse(double f) : factor(f) {}
  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    now[0] = old[0] + 1.0;
    return {{factor * line.freeJump[0] + at.gap, old[0], static_cast<double>(at.step)}, Status::broken};
  }
  double factor;
};

TEST(PointwiseLaw, HandsEachNodeWhatBelongsToIt) {
  const PointwiseLaw<Sparse> law(2.0);
  EXPECT_EQ(law.frame(), Frame::interface);
  EXPECT_FALSE(law.prescribesTraction());
  EXPECT_FALSE(law.dissipates());
  const std::vector<LocalLine> lines{{{1.0, 0.0, 0.0}, 1.0}, {{10.0, 0.0, 0.0}, 1.0}};
  const std::vector<double> gaps{0.5, 0.25}, old{3.0, 4.0};
  std::vector<double> now(2);
  std::vector<LocalState> states(2);
  law.solve(7, {2, lines.data(), gaps.data(), old.data(), now.data(), states.data()});
  EXPECT_EQ(states[0].traction, (base::Vector3{2.5, 3.0, 7.0}));
  EXPECT_EQ(states[1].traction, (base::Vector3{20.25, 4.0, 7.0}));
  EXPECT_EQ(now, (std::vector<double>{4.0, 5.0}));
}

/// A host's law that looks at all that there is, with a memory that its constructor chooses.
struct Curious {
  static constexpr const char* name = "Curious";
  static constexpr Sides sides = Sides::any;
  explicit Curious(int n) : numbers(n) {}
  int historySize() const { return numbers; }
  LocalState solve(const LocalLine&, const NodeContext& at, const double* old, double* now) const {
    for (int i = 0; i < numbers; ++i) now[i] = old[i] + at.number();
    return {{at.time() + at.area(), at.duration() + at.position()[2], at.frame()[0][1]}, Status::stick};
  }
  double lowestSlope() const { return -3.0; }
  static std::vector<OutputField> outputs() { return {{"sum", "length", "of its memory"}}; }
  void output(const PairStep& step, double* values) const {
    values[0] = step.at.time();
    for (int i = 0; i < numbers; ++i) values[0] += step.history[i];
  }
  int numbers;
};

TEST(PointwiseLaw, TellsWhereAndWhen) {
  const PointwiseLaw<Curious> law(2);
  EXPECT_EQ(law.historySize(), 2);
  EXPECT_EQ(law.lowestSlope(), -3.0);
  EXPECT_FALSE(law.isSmooth());
  ASSERT_EQ(law.outputs().size(), 1U);
  EXPECT_EQ(law.outputs()[0].unit, "length");
  const std::vector<LocalLine> lines(2);
  const std::vector<double> gaps(2, 0.0), old{1.0, 2.0, 3.0, 4.0}, areas{0.5, 0.25};
  const std::vector<base::Vector3> places{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
  const base::Vector3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};
  const std::vector<base::Frame> frames{{x, y, z}, {y, z, x}};
  const std::vector<int> numbers{7, 9};
  std::vector<double> now(4);
  std::vector<LocalState> states(2);
  const NodeArrays nodes{2,
                         lines.data(),
                         gaps.data(),
                         old.data(),
                         now.data(),
                         states.data(),
                         places.data(),
                         frames.data(),
                         areas.data(),
                         numbers.data(),
                         10.0,
                         2.0};
  law.solve(0, nodes);
  EXPECT_EQ(states[0].traction, (base::Vector3{10.5, 5.0, 0.0}));
  EXPECT_EQ(states[1].traction, (base::Vector3{10.25, 8.0, 1.0}));
  EXPECT_EQ(now, (std::vector<double>{8.0, 9.0, 12.0, 13.0}));
  PairStep step;
  step.history = now.data() + 2;
  step.at = NodeContext(0, nodes, 1);
  double value = 0.0;
  law.output(step, &value);
  EXPECT_EQ(value, 10.0 + 25.0);
}

TEST(StoredEnergy, IsThatOfSprings) {
  const auto glue = makeLaw("Linear Elastic", {{"Normal Stiffness", 10.0}, {"Tangential Stiffness", 4.0}});
  PairStep step;
  step.jump = {0.5, 1.0, 0.0};
  step.traction = {5.0, 4.0, 0.0};
  EXPECT_DOUBLE_EQ(glue->storedEnergy(step), 0.5 * (10.0 * 0.25 + 4.0));
  EXPECT_EQ(makeLaw("Unilateral Contact")->storedEnergy(step), 0.0);
}

TEST(LawRegistry, RefusesANameTwice) {
  LawRegistry laws = builtInLaws();
  EXPECT_THROW(laws.add(input::ParameterSpec("Perfect"), nullptr), base::Error);
}

}  // namespace
}  // namespace harmos::laws
