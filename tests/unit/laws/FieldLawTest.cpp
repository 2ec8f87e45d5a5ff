// Numbers of laws that vary over the surface, against the law with the number of each place.
#include <algorithm>
#include <array>
#include <set>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/laws/FaceLaw.hpp>
#include <harmos/laws/FieldLaw.hpp>
#include <harmos/laws/NodalLaw.hpp>
#include <harmos/laws/TurnedLaw.hpp>

#include "LawSamples.hpp"

namespace harmos::laws {
namespace {

input::Parameters glue(const std::string& formula) {
  const auto histories = std::make_shared<input::Histories>(std::vector<double>{1.0, 3.0});
  histories->add("half", {1.0, 0.5});
  input::Parameters p("law");
  p.set("Type", std::string("Linear Elastic")).set("Normal Stiffness", 2.0).set("Tangential Stiffness", 5.0);
  p.set("Normal Stiffness History", std::string("half")).set("Normal Stiffness Formula", formula);
  p.attach(histories);
  return p;
}

input::Parameters friction(const std::string& formula) {
  input::Parameters p("law");
  p.set("Type", std::string("Coulomb Friction")).set("Gap", 0.0).set("Friction Coefficient", 0.3);
  p.set("Friction Coefficient Formula", formula);
  return p;
}

const std::vector<base::Vector3> places{{1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {2, 0, 0}};

/// All places at once.
struct Points {
  explicit Points(const InterfaceLaw& law) {
    const auto numbers = places.size() * static_cast<std::size_t>(law.historySize());
    old.resize(numbers);
    now.resize(numbers);
  }
  void solve(const InterfaceLaw& law, int step) {
    NodeArrays nodes;
    nodes.count = static_cast<int>(places.size());
    nodes.line = lines.data();
    nodes.gap = gaps.data();
    nodes.oldHistory = old.data();
    nodes.newHistory = now.data();
    nodes.state = states.data();
    nodes.position = places.data();
    law.solve(step, nodes);
    old.swap(now);
  }
  std::vector<LocalLine> lines = std::vector<LocalLine>(places.size(), LocalLine{{-1.0, 2.0, 0.5}, 0.25});
  std::vector<double> gaps = std::vector<double>(places.size(), 0.0), old, now;
  std::vector<LocalState> states = std::vector<LocalState>(places.size());
};

TEST(FieldLaw, HasAtEveryPlaceTheNumbersOfThisPlace) {
  const auto law = builtInLaws().create(glue("x * t"));
  Points points(*law);
  for (int step = 0; step < 2; ++step) {
    points.solve(*law, step);
    for (std::size_t p = 0; p < places.size(); ++p) {
      const double k = 2.0 * (step == 0 ? 1.0 : 0.5) * places[p][0] * (step == 0 ? 1.0 : 3.0);
      EXPECT_DOUBLE_EQ(points.states[p].traction[0], -k / (1.0 + 0.25 * k));
      EXPECT_DOUBLE_EQ(points.states[p].traction[1], 10.0 / (1.0 + 0.25 * 5.0));
    }
  }
}

TEST(FieldLaw, KeepsHistoriesApart) {
  const auto law = builtInLaws().create(friction("x / 2"));
  Points points(*law);
  for (int step = 0; step < 3; ++step) {
    for (LocalLine& line : points.lines) line.freeJump[1] += step;
    points.solve(*law, step);
  }
  for (std::size_t p = 0; p < places.size(); ++p) {
    const auto alone = makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.15 * places[p][0]}});
    Node node(*alone);
    LocalLine line{{-1.0, 2.0, 0.5}, 0.25};
    LocalState expected;
    for (int step = 0; step < 3; ++step) {
      line.freeJump[1] += step;
      expected = node.solve(line);
      node.accept();
    }
    EXPECT_EQ(points.states[p].traction, expected.traction);
    EXPECT_EQ(points.states[p].status, expected.status);
  }
}

TEST(FieldLaw, IsTheLawItselfWithoutFormula) {
  input::Parameters p = friction("1");
  EXPECT_NE(dynamic_cast<const FieldLaw*>(builtInLaws().create(p).get()), nullptr);
  p.remove("Friction Coefficient Formula");
  EXPECT_EQ(dynamic_cast<const FieldLaw*>(builtInLaws().create(p).get()), nullptr);
}

TEST(FieldLaw, ClaimsWhatHoldsEverywhere) {
  const auto uneven = builtInLaws().create(friction("x"));
  dynamic_cast<const FieldLaw&>(*uneven).prepare(places);
  ASSERT_TRUE(uneven->admissibleTractions(0));
  EXPECT_FALSE(uneven->admissibleTractions(0)->isCone) << "it is not the same everywhere";
  EXPECT_DOUBLE_EQ(uneven->admissibleTractions(0)->friction, 0.3 * 3.0);
  const auto even = builtInLaws().create(friction("x > 0 ? 1 : 2"));
  dynamic_cast<const FieldLaw&>(*even).prepare(places);
  ASSERT_TRUE(even->admissibleTractions(0));
  EXPECT_DOUBLE_EQ(even->admissibleTractions(0)->friction, 0.3);
  EXPECT_TRUE(even->admissibleTractions(0)->isCone);
  EXPECT_FALSE(builtInLaws().create(glue("x"))->isAffine());
}

TEST(FieldLaw, RefusesNumbersOutOfTheirRange) {
  const auto law = builtInLaws().create(friction("2 - x"));
  try {
    dynamic_cast<const FieldLaw&>(*law).prepare(places);
    FAIL() << "accepted";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    const std::string message = error.what();
    EXPECT_NE(message.find("the formula makes Friction Coefficient = -0.3 at (3, 0, 0)"), std::string::npos) << message;
    EXPECT_NE(message.find("Allowed: at least 0"), std::string::npos) << message;
  }
}

// Glue whose energy falls below what it takes to reach its strength would never fail.
TEST(FieldLaw, NamesThePlaceWhereNumbersDoNotGoTogether) {
  input::Parameters p("law");
  p.set("Type", std::string("Cohesive Zone")).set("Stiffness", 100.0).set("Softening", std::string("Bilinear"));
  p.set("Normal Strength", 2.0).set("Shear Strength", 2.0).set("Mixed Mode Exponent", 1.0);
  p.set("Mode I Fracture Energy", 0.05, "scene.xml:7").set("Mode II Fracture Energy", 0.05);
  p.set("Mode I Fracture Energy Formula", std::string("x > 2 ? 0.3 : 1"));
  const auto law = builtInLaws().create(p);
  try {
    dynamic_cast<const FieldLaw&>(*law).prepare(places);
    FAIL() << "accepted";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    const std::string message = error.what();
    EXPECT_NE(message.find("scene.xml:7: law / Mode I Fracture Energy: 0.015 is not more than the elastic energy"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("at (3, 0, 0)"), std::string::npos) << message;
  }
}

TEST(FieldLaw, IsPreparedForThePlacesOfWhatItReplaces) {
  const auto present = builtInLaws().create(friction("x"));
  dynamic_cast<const FieldLaw&>(*present).prepare(places);
  const std::shared_ptr<const InterfaceLaw> bad = builtInLaws().create(friction("2 - x"));
  EXPECT_THROW(inPlaceOf(*present, bad), base::Error);
  const std::shared_ptr<const InterfaceLaw> good = builtInLaws().create(friction("x / 4"));
  EXPECT_EQ(inPlaceOf(*present, good), good);
}

/// x at all load steps, or x times the number of the load step.
struct Ramp final : SpatialField {
  explicit Ramp(bool isMoving) : isMoving_(isMoving) {}
  bool varies() const override { return isMoving_; }
  double at(int step, const base::Vector3& place) const override {
    return isMoving_ ? (step + 1) * place[0] : place[0];
  }
  bool isMoving_;
};

TEST(FieldLaw, MultipliesByItsField) {
  for (const bool isMoving : {false, true}) {
    input::Parameters p = glue("x");
    p.set("Normal Stiffness Field", std::string("map"));
    const auto law = builtInLaws().create(p);
    const auto& field = dynamic_cast<const FieldLaw&>(*law);
    EXPECT_THROW(field.prepare(places), base::Error);  // no field is known yet
    field.bind(std::make_shared<const SpatialFields>(SpatialFields{{"map", std::make_shared<Ramp>(isMoving)}}));
    Points points(*law);
    for (int step = 0; step < 2; ++step) {
      points.solve(*law, step);
      for (std::size_t i = 0; i < places.size(); ++i) {
        const double x = places[i][0], k = 2.0 * (step == 0 ? 1.0 : 0.5) * x * x * (isMoving ? step + 1.0 : 1.0);
        EXPECT_DOUBLE_EQ(points.states[i].traction[0], -k / (1.0 + 0.25 * k));
      }
    }
    // What takes its place has its fields.
    const std::shared_ptr<const InterfaceLaw> other = builtInLaws().create(p);
    inPlaceOf(*law, other);
    EXPECT_EQ(dynamic_cast<const FieldLaw&>(*other).places().size(), field.places().size());
  }
}

TEST(FieldLaw, RefusesFieldsThatMoveUnderNumbersThatDoNot) {
  input::Parameters p("law");
  p.set("Type", std::string("Jenkins")).set("Tangential Stiffness", 1.0).set("Slip Limit", 1.0).set("Opens", false);
  p.set("Slip Limit Field", std::string("map"));
  const auto law = builtInLaws().create(p);
  const auto bind = [&](bool isMoving) {
    dynamic_cast<const FieldLaw&>(*law).bind(
        std::make_shared<const SpatialFields>(SpatialFields{{"map", std::make_shared<Ramp>(isMoving)}}));
  };
  EXPECT_NO_THROW(bind(false));
  EXPECT_THROW(bind(true), base::Error);
}

TEST(FieldLaw, RefusesFormulasOfNumbersThatAreNotGiven) {
  for (const std::string companion : {"Shear Limit Formula", "Shear Limit Field"}) {
    input::Parameters p("law");
    p.set("Type", std::string("Compliant Contact")).set("Normal Stiffness", 1.0).set(companion, std::string("x"));
    input::ErrorList errors;
    builtInLaws().check(p, errors);
    EXPECT_EQ(errors.count(), 1);
    p.set("Shear Limit", 2.0);
    input::ErrorList none;
    builtInLaws().check(p, none);
    EXPECT_EQ(none.count(), 0);
  }
}

input::Parameters gasket(const std::string& entry, const std::string& formula) {
  input::Parameters p("law");
  p.set("Type", std::string("Tabulated Contact")).set("Gap", 0.0).set("Friction Coefficient", 0.0);
  p.set("Tangential Stiffness", 1.0).set("Overclosures", std::vector<double>{0.0, 0.1, 0.3});
  p.set("Pressures", std::vector<double>{0.0, 1.0, 8.0}).set(entry + " Formula", formula);
  return p;
}

TEST(FieldLaw, MultipliesAllNumbersOfAList) {
  for (const std::string entry : {"Overclosures", "Pressures"}) {
    const auto law = builtInLaws().create(gasket(entry, "1 + x"));
    Points points(*law);
    points.solve(*law, 0);
    for (std::size_t i = 0; i < places.size(); ++i) {
      input::Parameters p = gasket(entry, "1");
      std::vector<double> numbers = p.numbers(entry);
      for (double& number : numbers) number *= 1.0 + places[i][0];
      p.set(entry, numbers).remove(entry + " Formula");
      const auto alone = builtInLaws().create(p);
      ASSERT_EQ(dynamic_cast<const FieldLaw*>(alone.get()), nullptr);
      EXPECT_EQ(points.states[i].traction, Node(*alone).solve(points.lines[i]).traction);
    }
  }
}

TEST(FieldLaw, RefusesListsThatAreNoneAtOnePlace) {
  const auto message = [](const std::string& entry, const std::string& formula) {
    try {
      const auto law = builtInLaws().create(gasket(entry, formula));
      dynamic_cast<const FieldLaw&>(*law).prepare(places);
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ExitCode::input);
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  for (const auto& [entry, formula, expected] :
       {std::array{"Pressures", "2.5 - x", "the formula makes number 2 of Pressures = -0.5 at (3, 0, 0)"},
        std::array{"Overclosures", "2.5 - x", "is not above the one before"},
        std::array{"Overclosures", "t", "\"Overclosures\" does not vary over the load steps"}}) {
    const std::string found = message(entry, formula);
    EXPECT_NE(found.find(expected), std::string::npos) << found;
  }
}

// The axes of a tool and how it moves are those of a rigid body; what rubs on it need not be the same everywhere.
TEST(FieldLaw, IsWhatItsLawIsBesides) {
  input::Parameters p("law");
  p.set("Type", std::string("Rigid Sphere")).set("Centre", std::vector<double>{0.0, 0.0, 5.0}).set("Radius", 4.0);
  p.set("Part Inside", false).set("Interference", 0.0).set("Friction Coefficient", 0.3);
  for (const char* component : {"X", "Y", "Z"}) p.set(component, 0.0);
  const auto plain = builtInLaws().create(p);
  const auto law = builtInLaws().create(p.set("Friction Coefficient Formula", std::string("x")));
  ASSERT_NE(roleOf<TurnedLaw>(*law), nullptr);
  EXPECT_EQ(dynamic_cast<const TurnedLaw*>(law.get()), nullptr);
  EXPECT_EQ(roleOf<TurnedLaw>(*law)->axesAt(places[2]), roleOf<TurnedLaw>(*plain)->axesAt(places[2]));
  EXPECT_EQ(roleOf<NodalLaw>(*law), nullptr);
  const LawRegistry laws = builtInLaws();
  const auto spec = std::find_if(laws.forms().begin(), laws.forms().end(),
                                 [](const input::ParameterSpec& form) { return form.name() == "Rigid Sphere"; });
  std::set<std::string> names;
  for (const auto& entry : spec->entries()) names.insert(entry->name);
  EXPECT_EQ(names.count("Friction Coefficient Field"), 1U);
  for (const char* none : {"X Formula", "Radius Formula", "Centre Formula", "Interference Field"}) {
    EXPECT_EQ(names.count(none), 0U) << none;
  }
}

}  // namespace
}  // namespace harmos::laws
