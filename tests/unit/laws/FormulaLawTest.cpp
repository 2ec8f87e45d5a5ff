// The law "Formula" against laws with a closed form, and what it refuses.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/laws/FaceLaw.hpp>
#include <harmos/laws/FieldFollower.hpp>
#include <harmos/laws/NoIntersection.hpp>

#include "LawSamples.hpp"

namespace harmos::laws {
namespace {

struct Texts {
  std::string n = "0", t1 = "0", t2 = "0";
  std::map<std::string, double> constants = {};
  std::vector<std::pair<std::string, std::string>> history = {};
  double lowestSlope = 0.0;
  std::vector<std::string> fields = {};
};

std::unique_ptr<InterfaceLaw> formula(const Texts& texts) {
  input::Parameters constants("Constants"), law("law");
  for (const auto& [name, value] : texts.constants) constants.set(name, value);
  law.set("Type", std::string("Formula")).set("Lowest Slope", texts.lowestSlope).set("Dissipates", false);
  law.set("Normal Traction", texts.n).set("Tangential Traction 1", texts.t1).set("Tangential Traction 2", texts.t2);
  law.setList("Constants", constants);
  if (!texts.fields.empty()) law.set("Fields", texts.fields);
  for (const auto& [name, text] : texts.history) {
    law.addNamed("History", input::Parameters(name).set("Formula", text).set("Unit", std::string("-")));
  }
  return builtInLaws().create(law);
}

void expectRefused(const Texts& texts, const std::string& words) {
  try {
    formula(texts);
    FAIL() << "accepted: " << texts.n;
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

void expectSame(const InterfaceLaw& law, const InterfaceLaw& closed, double digits, int steps = 1) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const double gap = uniform(random, -1.0, 1.0);
    Node node(law, gap), other(closed, gap);
    for (int step = 0; step < steps; ++step) {
      const LocalLine line = randomLine(random);
      const base::Vector3 expected = other.solve(line).traction;
      const double scale = norm(expected) + norm(line.freeJump) / line.compliance;
      EXPECT_LE(norm(node.solve(line).traction - expected), digits * scale);
      node.accept();
      other.accept();
    }
  }
}

/// Place and load step tell its value.
struct Ramp final : SpatialField {
  bool varies() const override { return true; }
  double at(int step, const base::Vector3& place) const override {
    if (place[0] > 10.0) throw base::Error("too far", base::ExitCode::input);
    return place[0] + step;
  }
};

TEST(FormulaLaw, SeesFieldsByTheirNames) {
  Texts texts;
  texts.n = "k * coating * jump_n";
  texts.constants = {{"k", 2.0}};
  texts.fields = {"coating"};
  const std::shared_ptr<const InterfaceLaw> law = formula(texts), other = formula(texts);
  const auto& follower = dynamic_cast<const FieldFollower&>(*law);
  EXPECT_THROW(follower.prepare({{1.0, 0.0, 0.0}}), base::Error);  // no field is known yet
  follower.bind(std::make_shared<const SpatialFields>(SpatialFields{{"coating", std::make_shared<Ramp>()}}));
  follower.prepare({{1.0, 0.0, 0.0}, {3.0, 0.0, 0.0}});
  EXPECT_THROW(follower.prepare({{11.0, 0.0, 0.0}}), base::Error);
  inPlaceOf(*law, other);  // has its fields and places
  EXPECT_EQ(dynamic_cast<const FieldFollower&>(*other).places(), follower.places());
  const LocalLine line{{3.0, 1.0, -1.0}, 0.25};
  for (const InterfaceLaw* each : {law.get(), other.get()}) {
    for (const double x : {1.0, 3.0}) {
      for (const int step : {0, 2}) {
        const double k = 2.0 * (x + step);
        Node node(*each, 0.0, Node::axes, 1.0, {x, 0.0, 0.0});
        EXPECT_NEAR(node.solve(line, step).traction[0], 3.0 * k / (1.0 + 0.25 * k), 1e-14 * k);
      }
    }
  }
}

TEST(FormulaLaw, RefusesFieldsThatCannotStandInAFormula) {
  Texts texts;
  texts.fields = {"my coating"};
  expectRefused(texts, "\"my coating\" cannot stand in a formula");
  texts.fields = {"gap"};
  expectRefused(texts, "\"gap\" means something else already");
}

TEST(FormulaLaw, IsSpringsWhereItSaysSo) {
  const Texts springs{"k_n * jump_n", "k_t * jump_1", "k_t * jump_2", {{"k_n", 30.0}, {"k_t", 0.7}}};
  const auto closed = makeLaw("Linear Elastic", {{"Normal Stiffness", 30.0}, {"Tangential Stiffness", 0.7}});
  expectSame(*formula(springs), *closed, 1e-15);
  // The same by Newton's method: to the formula, all components hang together.
  Texts coupled = springs;
  coupled.n += " + 0 * jump_1";
  expectSame(*formula(coupled), *closed, 1e-12);
}

// Kinks and jumps, in which no derivative helps: contact by a stiff penalty, and a traction that is switched.
TEST(FormulaLaw, GivesNothingWhereAProductIsZero) {
  Texts texts;
  texts.n = "k * jump_n";
  texts.t1 = "(k - 2) * jump_1 + 0 * opened * x";
  texts.t2 = "k * jump_2 + 0 * t";
  texts.history = {{"opened", "max(opened_old, jump_n)"}};
  texts.constants = {{"k", 0.0}};
  EXPECT_EQ(formula(texts)->givesNothing(), (std::array<bool, 3>{true, false, true}));
  texts.constants = {{"k", 2.0}};
  EXPECT_EQ(formula(texts)->givesNothing(), (std::array<bool, 3>{false, true, false}));
}

TEST(FormulaLaw, BracketsWhatHasKinks) {
  const auto law = formula({"jump_n + gap < 0 ? 1e9 * (jump_n + gap) : 0"});
  const auto contact = makeLaw("Unilateral Contact");
  expectSame(*law, *contact, 1e-6);
  const auto sign = formula({"jump_n < 0.25 ? -3 : 2"});
  EXPECT_DOUBLE_EQ(Node(*sign).solve({{-1.0, 0.0, 0.0}, 0.1}).traction[0], -3.0);
  EXPECT_DOUBLE_EQ(Node(*sign).solve({{1.0, 0.0, 0.0}, 0.1}).traction[0], 2.0);
  EXPECT_NEAR(Node(*sign).solve({{0.3, 0.0, 0.0}, 0.1}).traction[0], 0.5, 1e-12);
}

TEST(FormulaLaw, CouplesComponents) {
  const std::string square = "(jump_n^2 + jump_1^2 + jump_2^2)";
  const auto law =
      formula({"jump_n * (2 + " + square + ")", "jump_1 * (2 + " + square + ")", "jump_2 * (2 + " + square + ")"});
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const LocalLine line = randomLine(random);
    const base::Vector3 t = Node(*law).solve(line).traction, jump = line.jump(t);
    const double lost = 1e-12 * (norm(line.freeJump) + line.compliance * norm(t));
    EXPECT_LE(norm(t - (2.0 + dot(jump, jump)) * jump), (2.0 + 3.0 * dot(jump, jump)) * lost);
  }
}

// The slider keeps where it was left: k clip(delta - p), with p as history, is plasticity in one component.
// Digits that such terms leave are those of the terms: of 1 - exp(-1e-9) there are seven.
TEST(FormulaLaw, MeetsLinesWhereTermsCancel) {
  const double strength = 5.0, length = 0.01, coupling = 10.0;
  const std::map<std::string, double> constants{{"s", strength}, {"d", length}, {"c", coupling}};
  const Texts texts{"s * (1 - exp(-jump_n / d)) + c * jump_1", "s * (exp(jump_1 / d) - 1) + c * jump_n",
                    "s * (exp(jump_2 / d) - exp(-jump_2 / d)) / 2", constants};
  const Texts alone{"s * (1 - exp(-jump_n / d))", "s * (exp(jump_1 / d) - 1)", "s * (exp(jump_2 / d) - 1)", constants};
  const auto law = formula(texts), uncoupled = formula(alone);
  Random random(7);
  for (const double size : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15, 1e-17, 1e-20}) {
    for (int i = 0; i < 200; ++i) {
      LocalLine line = randomLine(random);
      line.compliance = std::pow(10.0, uniform(random, -5.0, -1.0));
      line.freeJump = size * line.freeJump;
      for (const auto* one : {&law, &uncoupled}) {
        Node node(**one, 0.0);
        const base::Vector3 t = node.solve(line).traction, jump = line.jump(t);
        const double along = one == &law ? coupling : 0.0;
        const base::Vector3 expected{
            -strength * std::expm1(-jump[0] / length) + along * jump[1],
            strength * std::expm1(jump[1] / length) + along * jump[0],
            one == &law ? strength * std::sinh(jump[2] / length) : strength * std::expm1(jump[2] / length)};
        EXPECT_LE(norm(t - expected), 1e-13 * strength + 1e-11 * norm(expected)) << size << ", " << i;
      }
    }
  }
}

TEST(FormulaLaw, KeepsNumbersFromStepToStep) {
  const auto law = formula({"k * (jump_n - slip)",
                            "0",
                            "0",
                            {{"k", 10.0}, {"limit", 2.0}},
                            {{"slip", "min(max(slip_old, jump_n - limit / k), jump_n + limit / k)"}}});
  EXPECT_EQ(law->historySize(), 1);
  Node node(*law);
  const double compliance = 0.05;
  double slip = 0.0;
  for (const double free : {0.1, 0.9, 0.2, -1.0, 0.0, 2.0}) {
    const double trial = 10.0 * (free - slip) / (1.0 + 10.0 * compliance);
    const double expected = std::min(2.0, std::max(-2.0, trial));
    const double found = node.solve({{free, 0.0, 0.0}, compliance}).traction[0];
    EXPECT_NEAR(found, expected, 1e-13);
    slip = free - compliance * expected - expected / 10.0;
    EXPECT_NEAR(node.newHistory()[0], slip, 1e-13);
    node.accept();
  }
}

TEST(FormulaLaw, SeesPlaceAndTime) {
  // The sample lies at (1, 2, 3); its load steps take a second.
  const LocalLine line{{0.5, 0.0, 0.0}, 1.0};
  EXPECT_DOUBLE_EQ(Node(*formula({"100 * x + 10 * y + z"})).solve(line).traction[0], 123.0);
  EXPECT_DOUBLE_EQ(Node(*formula({"10 * t + dt"})).solve(line, 3).traction[0], 41.0);
  EXPECT_DOUBLE_EQ(Node(*formula({"gap"}), 0.25).solve(line).traction[0], 0.25);
}

// Under pressure it falls from -0.5 to above 0, so that the point lies beyond the free jump.
TEST(FormulaLaw, MeetsLinesWhereItFallsNoMoreThanItSays) {
  for (const char* coupling : {"", " + 0 * jump_1"}) {
    Texts falling{std::string("(jump_n < -0.1 ? -0.5 - 10 * (jump_n + 0.1) : 5 * jump_n)") + coupling};
    falling.lowestSlope = -10.0;
    const LocalLine line{{-1.0, 0.0, 0.0}, 0.05};
    const LocalState state = Node(*formula(falling)).solve(line);
    // delta + 0.05 (-1.5 - 10 delta) = -1
    EXPECT_NEAR(line.jump(state.traction)[0], -1.85, 1e-12);
    EXPECT_NEAR(state.traction[0], 17.0, 1e-11);
  }
}

TEST(FormulaLaw, SaysWhereItFalls) {
  const auto law = formula({"-10 * jump_n"});
  try {
    Node(*law).solve({{1.0, 0.0, 0.0}, 1.0});
    FAIL() << "found a point";
  } catch (const NoIntersection& error) {
    EXPECT_NE(std::string(error.what()).find("place (1, 2, 3)"), std::string::npos) << error.what();
  }
}

TEST(FormulaLaw, HandsOnWhatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(Node(*formula({"jump_n"})).solve({{nan, 0.0, 0.0}, 1.0}).traction[0]));
}

TEST(FormulaLaw, RefusesNamesAndTextsThatAreNone) {
  expectRefused({"k * jump_m", "0", "0", {{"k", 1.0}}},
                "uses \"jump_m\", which is no quantity of this law.\n  Did you mean \"jump_n\"?");
  expectRefused({"2 *"}, "\"2 *\" is not a formula");
  expectRefused({"0", "0", "0", {{"sin", 1.0}}}, "\"sin\" cannot stand in a formula");
  expectRefused({"0", "0", "0", {{"gap", 1.0}}}, "\"gap\" means something else already");
  expectRefused({"0", "0", "0", {}, {{"a", "b"}, {"b", "jump_n"}}}, "uses \"b\" before it has a value");
}

}  // namespace
}  // namespace harmos::laws
