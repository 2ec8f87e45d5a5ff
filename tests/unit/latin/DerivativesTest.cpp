#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/latin/Derivatives.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/latin/detail/DerivativeKinks.hpp>
#include <harmos/laws/PointwiseLaw.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

using Values = std::map<std::string, double>;

/// Two cubes on one another, pressed together and sheared to and fro: nodes stick, slip, and stick again, so that later
/// load steps depend on what earlier ones have left.
class Rubbing {
 public:
  explicit Rubbing(Values values, bool isConsistent = false, int across = 2)
      : values_(std::move(values)), cubes_(twoCubes(joint(), top(), steps, isConsistent, across)) {
    if (Tpetra::getDefaultComm()->getSize() > 1) cubes_.assembly().owner = {0, 1};
    for (std::size_t i = 0; i < assembly().interfaces.size(); ++i) {
      const assembly::Interface& interface = assembly().interfaces[i];
      (interface.sides() == 2 ? joint_ : interface.law->prescribesTraction() ? top_ : clamp_) = static_cast<int>(i);
    }
    install();
  }

  assembly::Assembly& assembly() { return cubes_.assembly(); }

  ModelParameter parameter(const std::string& name, ModelParameter::Side side = ModelParameter::Side::both) {
    return {name, values_.at(name), 1e-6 * values_.at(name),
            [this, name](double value) {
              values_[name] = value;
              install();
            },
            side};
  }

  /// Of a parameter: its value, or that of the cubes where it is 0.
  double sizeOf(const std::string& name) const { return values_.at(name) == 0.0 ? 1.0 : values_.at(name); }

  std::vector<std::shared_ptr<const Response>> responses() const {
    const base::Vector3 x{1, 0.2, -0.5}, y{0, 1, 0};
    return {std::make_shared<DisplacementResponse>(
                "u", std::vector<DisplacementResponse::Node>{{1, 3, 0.5}, {1, 20, 0.5}}, x),
            std::make_shared<ResultantResponse>("moment", std::vector<int>{joint_}, std::vector<base::Vector3>{y},
                                                std::vector<base::Vector3>{{0.1, 0.2, 0.3}}),
            std::make_shared<ResultantResponse>("reaction", std::vector<int>{clamp_}, std::vector<base::Vector3>{x}),
            std::make_shared<DissipationResponse>("lost", std::vector<int>{joint_}),
            std::make_shared<MaximumResponse>("slip", std::vector<int>{joint_}, MaximumResponse::Field::slip)};
  }

  static constexpr int steps = 5;

 private:
  std::shared_ptr<const laws::InterfaceLaw> joint() const {
    return laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", values_.at("mu")}});
  }
  std::shared_ptr<const laws::InterfaceLaw> top() const {
    return laws::makeLaw("Prescribed Traction", {{"X", values_.at("shear")}, {"Z", -values_.at("pressure")}},
                         {{"X", {0.3, 1.0, 0.2, -0.8, 0.4}}});
  }
  void install() {
    assembly().interfaces[joint_].law = joint();
    assembly().interfaces[top_].law = top();
    assembly().interfaces[clamp_].law =
        laws::makeLaw("Prescribed Displacement", {{"X", values_.at("ground")}, {"Y", 0.0}, {"Z", 0.0}});
  }

  Values values_;
  BoxAssembly cubes_;
  int joint_ = 0, top_ = 0, clamp_ = 0;
};

const Values usual{{"mu", 0.3}, {"shear", 0.9}, {"pressure", 4.0}, {"ground", 0.0}};

LatinOptions precise() {
  LatinOptions options;
  options.accuracy = 1e-11;
  return options;
}

/// All responses at all load steps.
std::vector<std::vector<double>> solve(const Values& values, bool isConsistent) {
  Rubbing model(values, isConsistent);
  base::Timers timers;
  LatinSolver solver(model.assembly(), precise(), Tpetra::getDefaultComm(), timers);
  for (const auto& response : model.responses()) solver.addResponse(response);
  const LatinResult result = solver.solve();
  EXPECT_EQ(result.outcome, Outcome::certified) << result.reason;
  std::vector<std::vector<double>> all;
  for (const ResponseResult& response : result.responses) all.push_back(response.values);
  return all;
}

void compareWithDifferences(bool isConsistent) {
  Rubbing model(usual, isConsistent);
  base::Timers timers;
  LatinSolver solver(model.assembly(), precise(), Tpetra::getDefaultComm(), timers);
  solver.solve();
  const auto responses = model.responses();
  std::vector<std::string> names{"mu", "shear", "pressure", "ground"};
  if (Tpetra::getDefaultComm()->getSize() > 1) names.resize(2);  // their exchanges take time
  std::vector<ModelParameter> parameters;
  for (const std::string& name : names) parameters.push_back(model.parameter(name));
  Derivatives derivatives(solver.fixedPoint(), responses);
  const auto found = derivatives.compute(solver.state(), parameters);
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_LE(found[i].residuals.back(), 1e-7) << names[i];
    Values more = usual, less = usual;
    const double h = 1e-4 * model.sizeOf(names[i]);
    more[names[i]] += h;
    less[names[i]] -= h;
    const auto above = solve(more, isConsistent), below = solve(less, isConsistent);
    for (std::size_t j = 0; j < responses.size(); ++j) {
      double largest = 0.0, size = 0.0;
      std::vector<double> difference;
      for (int t = 0; t < Rubbing::steps; ++t) {
        difference.push_back((above[j][t] - below[j][t]) / (2.0 * h));
        largest = std::max(largest, std::abs(difference.back()));
        size = std::max(size, std::abs(above[j][t]));
      }
      for (int t = 0; t < Rubbing::steps; ++t) {
        // What equilibrium alone determines has the derivative 0, but for round-off.
        EXPECT_NEAR(found[i].responses[j][t], difference[t], 1e-5 * largest + 1e-7 * size / model.sizeOf(names[i]))
            << responses[j]->name() << " by " << names[i] << " at load step " << t;
      }
    }
  }
}

// Loads that go to and fro: without the history of earlier load steps the later ones would be wrong.
TEST(Derivatives, AreThoseOfDifferencesOfSolutions) {
  compareWithDifferences(false);
}

TEST(Derivatives, AreThoseOfDifferencesWithAConsistentMass) {
  compareWithDifferences(true);
}

// Each load step needs directions of its own, all together more than are kept: they had been at an end after some
// steps.
TEST(Derivatives, FindDirectionsForEveryLoadStep) {
  Rubbing model(usual, false, 8);
  base::Timers timers;
  LatinSolver solver(model.assembly(), precise(), Tpetra::getDefaultComm(), timers);
  ASSERT_EQ(solver.solve().outcome, Outcome::certified);
  const auto responses = model.responses();
  Derivatives derivatives(solver.fixedPoint(), responses);
  const auto found = derivatives.compute(solver.state(), {model.parameter("mu"), model.parameter("shear")});
  for (const auto& one : found) EXPECT_LE(one.residuals.back(), 1e-8);
  EXPECT_LT(derivatives.directions(), 600);
}

// At the least or largest value that is admissible: the same where there is no kink.
TEST(Derivatives, CanBeThoseOfOneSide) {
  Rubbing model(usual);
  base::Timers timers;
  LatinSolver solver(model.assembly(), precise(), Tpetra::getDefaultComm(), timers);
  ASSERT_EQ(solver.solve().outcome, Outcome::certified);
  const base::Matrix state = Derivatives::stateOf(solver.state());
  const auto responses = model.responses();
  Derivatives derivatives(solver.fixedPoint(), responses);
  using Side = ModelParameter::Side;
  for (const std::string name : {"mu", "pressure"}) {
    const auto both = derivatives.compute(state, {model.parameter(name)});
    for (const Side side : {Side::above, Side::below}) {
      double last = usual.at(name);
      ModelParameter parameter = model.parameter(name, side);
      const auto set = parameter.set;
      parameter.set = [&](double value) {
        if (side == Side::above ? value < usual.at(name) : value > usual.at(name)) ADD_FAILURE() << value;
        last = value;
        set(value);
      };
      const auto one = derivatives.compute(state, {parameter});
      EXPECT_EQ(last, usual.at(name));
      EXPECT_TRUE(one[0].missing.empty());
      for (std::size_t j = 0; j < responses.size(); ++j) {
        for (int t = 0; t < Rubbing::steps; ++t) {
          const double expected = both[0].responses[j][t];
          // One digit more of round-off than in the middle of two sides.
          EXPECT_NEAR(one[0].responses[j][t], expected, 1e-5 * std::abs(expected) + 1e-7) << name << j << ", " << t;
        }
      }
    }
  }
}

// Without friction at first: the slope towards more of it, against one-sided differences of solutions.
TEST(Derivatives, OfNoFrictionAreThoseOfALittle) {
  // Held by springs, since nothing else holds the upper cube along the joint.
  BoxAssembly cubes =
      twoCubes(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.0}}),
               laws::makeLaw("Elastic Foundation", {{"Normal Stiffness", 50.0}, {"Tangential Stiffness", 1.0}}));
  assembly::Assembly& assembly = cubes.assembly();
  std::size_t bottom = 0, joint = 0;
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    if (assembly.interfaces[i].name == "bottom") bottom = i;
    if (assembly.interfaces[i].name == "joint") joint = i;
  }
  assembly.interfaces[bottom].law = laws::makeLaw("Prescribed Displacement", {{"X", 0.1}, {"Y", 0.0}, {"Z", 0.05}});
  const auto friction = [&](double mu) {
    assembly.interfaces[joint].law = laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", mu}});
  };
  const std::vector<std::shared_ptr<const Response>> responses{std::make_shared<ResultantResponse>(
      "force", std::vector<int>{static_cast<int>(joint)}, std::vector<base::Vector3>{{1, 0, 0}})};
  const auto force = [&](double mu) {
    friction(mu);
    base::Timers timers;
    LatinSolver solver(assembly, precise(), self(), timers);
    EXPECT_EQ(solver.solve().outcome, Outcome::certified);
    return responses[0]->evaluate(solver.state())[0];
  };
  const double h = 1e-3;
  const double slope = (-3.0 * force(0.0) + 4.0 * force(h) - force(2.0 * h)) / (2.0 * h);
  friction(0.0);
  base::Timers timers;
  LatinSolver solver(assembly, precise(), self(), timers);
  ASSERT_EQ(solver.solve().outcome, Outcome::certified);
  const auto found = Derivatives(solver.fixedPoint(), responses)
                         .compute(solver.state(), {{"mu", 0.0, 0.0, friction, ModelParameter::Side::above}});
  EXPECT_GT(std::abs(slope), 0.1);
  EXPECT_NEAR(found[0].responses[0][0], slope, 1e-4 * std::abs(slope));
}

// A friction coefficient of 0 has no value a little less.
TEST(Derivatives, NameRunsThatAreAdmissible) {
  using Side = ModelParameter::Side;
  const auto remark = [](Side side) {
    return missingFrom(1, {"mu", 0.0, 0.0, {}, side}, "contact", NoDerivative::kink);
  };
  EXPECT_NE(remark(Side::both).find("a little more and a little less of it tell both slopes"), std::string::npos);
  EXPECT_NE(remark(Side::above).find("; a run with a little more of it tells the slope"), std::string::npos);
  EXPECT_EQ(remark(Side::above).find("less"), std::string::npos);
  EXPECT_NE(remark(Side::below).find("; a run with a little less of it tells the slope"), std::string::npos);
  EXPECT_EQ(remark(Side::below).find("more"), std::string::npos);
}

// Two pairs share the largest value, and change otherwise: a kink of the response, not of the state.
TEST(Derivatives, AreNotThoseOfResponsesAtAKink) {
  struct Larger final : PairResponse {
    Larger() : PairResponse("larger", Quantity::stress, {1}) {}
    void include(const assembly::Interface&, const PairFields&, std::vector<double>&) const override {}
    std::vector<double> finish(std::vector<double> values) const override {
      for (double& value : values) value = std::max(4.0, 4.0 + now - 0.9);
      return values;
    }
    double now = 0.9;
  };
  Rubbing model(usual);
  base::Timers timers;
  LatinSolver solver(model.assembly(), precise(), Tpetra::getDefaultComm(), timers);
  ASSERT_EQ(solver.solve().outcome, Outcome::certified);
  const auto larger = std::make_shared<Larger>();
  ModelParameter shear = model.parameter("shear");
  const auto set = shear.set;
  shear.set = [&](double value) {
    larger->now = value;
    set(value);
  };
  const std::vector<std::shared_ptr<const Response>> responses{larger, model.responses()[0]};
  const auto found = Derivatives(solver.fixedPoint(), responses).compute(solver.state(), {shear});
  ASSERT_EQ(found[0].missing.size(), static_cast<std::size_t>(Rubbing::steps));
  EXPECT_NE(found[0].missing[0].find("\"larger\""), std::string::npos) << found[0].missing[0];
  for (int t = 0; t < Rubbing::steps; ++t) {
    EXPECT_TRUE(std::isnan(found[0].responses[0][t]));
    EXPECT_FALSE(std::isnan(found[0].responses[1][t]));
  }
}

// The history matters here: the derivative at the end by the load of the second step alone is not zero.
TEST(Derivatives, RememberEarlierLoadSteps) {
  Rubbing model(usual);
  base::Timers timers;
  LatinSolver solver(model.assembly(), precise(), Tpetra::getDefaultComm(), timers);
  solver.solve();
  const auto responses = model.responses();
  const int top = 2;
  ASSERT_TRUE(model.assembly().interfaces[top].law->prescribesTraction());
  const ModelParameter early{"early", 1.0, 1e-6, [&](double factor) {
                               model.assembly().interfaces[top].law =
                                   laws::makeLaw("Prescribed Traction", {{"X", 0.9}, {"Z", -4.0}},
                                                 {{"X", {0.3, factor, 0.2, -0.8, 0.4}}});
                             }};
  const auto found = Derivatives(solver.fixedPoint(), responses).compute(solver.state(), {early});
  EXPECT_EQ(found[0].responses[0][0], 0.0);
  const double largest = std::abs(found[0].responses[0][1]);
  EXPECT_GT(std::abs(found[0].responses[0][2]), 1e-3 * largest);
}

// The solver is as it was: another run gives the same numbers.
TEST(Derivatives, LeaveTheSolverAsItWas) {
  Rubbing model(usual);
  base::Timers timers;
  LatinSolver solver(model.assembly(), {}, Tpetra::getDefaultComm(), timers);
  const auto responses = model.responses();
  for (const auto& response : responses) solver.addResponse(response);
  const LatinResult before = solver.solve();
  Derivatives(solver.fixedPoint(), responses).compute(solver.state(), {model.parameter("mu")});
  const LatinResult after = solver.solve();
  for (std::size_t j = 0; j < before.responses.size(); ++j) {
    EXPECT_EQ(before.responses[j].values, after.responses[j].values);
  }
}

/// Answers each time otherwise, as a law that knows more than the pairs that it is asked for.
struct Moody {
  static constexpr const char* name = "Moody";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;
  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext&, const double*, double*) const {
    const double stiffness = 10.0 + 0.1 * calls;
    laws::LocalState state;
    for (std::size_t c = 0; c < 3; ++c) {
      state.traction[c] = stiffness * line.freeJump[c] / (1.0 + stiffness * line.compliance);
    }
    if (changes) ++calls;
    return state;
  }
  static inline bool changes = false;
  static inline int calls = 0;
};

TEST(Derivatives, RefuseLawsThatKnowMoreThanTheirPairs) {
  assembly::Assembly assembly =
      twoChains(std::make_shared<laws::PointwiseLaw<Moody>>(), laws::makeLaw("Prescribed Traction", {{"X", 1.0}}));
  base::Timers timers;
  LatinSolver solver(assembly, precise(), self(), timers);
  ASSERT_EQ(solver.solve().outcome, Outcome::certified);
  const base::Matrix state = Derivatives::stateOf(solver.state());
  const std::vector<std::shared_ptr<const Response>> none;
  const ModelParameter load{"load", 1.0, 1e-6, [&](double value) {
                              assembly.interfaces[2].law = laws::makeLaw("Prescribed Traction", {{"X", value}});
                            }};
  EXPECT_NO_THROW(Derivatives(solver.fixedPoint(), none).compute(state, {load}));
  Moody::changes = true;
  EXPECT_THROW(Derivatives(solver.fixedPoint(), none).compute(state, {load}), base::Error);
  Moody::changes = false;
}

/// Two cubes between a wall that moves and springs, drawn together by a bolt in the first load step, and locked.
class Bolted {
 public:
  Bolted(double force, double way)
      : values_{{"force", force}, {"way", way}},
        cubes_(twoCubes(bolt(),
                        laws::makeLaw("Elastic Foundation", {{"Normal Stiffness", 5.0}, {"Tangential Stiffness", 3.0}}),
                        3)) {
    for (const assembly::Interface& interface : assembly().interfaces) names_.push_back(interface.name);
    install();
  }
  assembly::Assembly& assembly() { return cubes_.assembly(); }
  ModelParameter parameter(const std::string& name) {
    return {name, values_.at(name), 1e-6 * values_.at(name), [this, name](double value) {
              values_[name] = value;
              install();
            }};
  }
  std::vector<std::shared_ptr<const Response>> responses() const {
    return {std::make_shared<ResultantResponse>("bolt", std::vector<int>{at("joint")},
                                                std::vector<base::Vector3>{{0, 0, 1}}),
            std::make_shared<DisplacementResponse>("u", std::vector<DisplacementResponse::Node>{{1, 3, 1.0}},
                                                   base::Vector3{0.2, 0, 1})};
  }

 private:
  int at(const std::string& name) const {
    return static_cast<int>(std::find(names_.begin(), names_.end(), name) - names_.begin());
  }
  std::shared_ptr<const laws::InterfaceLaw> bolt() const {
    input::Parameters parameters("law");
    parameters.set("Type", std::string("Pretension")).set("Force", values_.at("force")).set("Locked From", 1.0);
    parameters.attach(std::make_shared<input::Histories>(std::vector<double>{1.0, 2.0, 3.0}));
    return laws::builtInLaws().create(parameters);
  }
  void install() {
    assembly().interfaces[at("joint")].law = bolt();
    assembly().interfaces[at("bottom")].law = laws::makeLaw(
        "Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", values_.at("way")}}, {{"Z", {0.0, 1.0, -0.5}}});
  }

  Values values_;
  BoxAssembly cubes_;
  std::vector<std::string> names_;
};

// A law over a whole face, and what it keeps from the load step in which it was locked.
TEST(Derivatives, KnowLawsOverWholeFaces) {
  constexpr double force = 2.0, way = 0.3;
  const auto solve = [&](double f, double w) {
    Bolted model(f, w);
    base::Timers timers;
    LatinSolver solver(model.assembly(), precise(), self(), timers);
    for (const auto& response : model.responses()) solver.addResponse(response);
    return solver.solve().responses;
  };
  Bolted model(force, way);
  base::Timers timers;
  LatinSolver solver(model.assembly(), precise(), self(), timers);
  ASSERT_EQ(solver.solve().outcome, Outcome::certified);
  const auto responses = model.responses();
  const auto found = Derivatives(solver.fixedPoint(), responses)
                         .compute(solver.state(), {model.parameter("force"), model.parameter("way")});
  const double h = 1e-3;
  const auto more = solve(force + h, way), less = solve(force - h, way);
  const auto further = solve(force, way + h), nearer = solve(force, way - h);
  for (std::size_t j = 0; j < responses.size(); ++j) {
    for (std::size_t t = 0; t < 3; ++t) {
      const double byForce = (more[j].values[t] - less[j].values[t]) / (2.0 * h);
      const double byWay = (further[j].values[t] - nearer[j].values[t]) / (2.0 * h);
      EXPECT_NEAR(found[0].responses[j][t], byForce, 1e-5 * std::abs(byForce) + 1e-8) << j << ", " << t;
      EXPECT_NEAR(found[1].responses[j][t], byWay, 1e-5 * std::abs(byWay) + 1e-8) << j << ", " << t;
    }
  }
  EXPECT_NEAR(std::abs(found[0].responses[0][2]), 1.0, 0.5);  // the force is kept, but for what it pulls along
}

// A spring of the ground that stands in the operator cannot change; where it does not, it has a derivative.
TEST(Derivatives, RefuseWhatStandsInOperators) {
  const auto spring = [](double k) {
    return laws::makeLaw("Elastic Foundation", {{"Normal Stiffness", k}, {"Tangential Stiffness", 2.0}});
  };
  BoxAssembly cube({{"cube", {0, 0, 0}, {1, 1, 1}, {1, 1, 1}}});
  cube.hold("ground", "cube_zmin", spring(5.0));
  cube.hold("end", "cube_zmax", laws::makeLaw("Prescribed Traction", {{"Z", 1.0}}));
  assembly::Assembly& assembly = cube.assembly();
  const std::vector<std::shared_ptr<const Response>> responses{std::make_shared<DisplacementResponse>(
      "u", std::vector<DisplacementResponse::Node>{{0, 0, 1.0}}, base::Vector3{0, 0, 1})};
  ASSERT_EQ(assembly.interfaces[0].name, "ground");
  const ModelParameter k{"k", 5.0, 5e-6, [&](double value) { assembly.interfaces[0].law = spring(value); }};
  for (const auto elimination : {Elimination::affine, Elimination::rigid}) {
    base::Timers timers;
    LatinOptions options = precise();
    options.stages.elimination = elimination;
    LatinSolver solver(assembly, options, self(), timers);
    solver.solve();
    Derivatives derivatives(solver.fixedPoint(), responses);
    if (elimination == Elimination::affine) {
      EXPECT_THROW(derivatives.compute(solver.state(), {k}), base::Error);
    } else {
      const double u = responses[0]->evaluate(solver.state())[0];
      const double found = derivatives.compute(solver.state(), {k})[0].responses[0][0];
      EXPECT_LT(found, -0.03);  // -1/k^2, but for the bottom that bends
      assembly.interfaces[0].law = spring(5.001);
      LatinSolver softer(assembly, options, self(), timers);
      softer.solve();
      EXPECT_NEAR(found, (responses[0]->evaluate(softer.state())[0] - u) / 0.001, 1e-3 * std::abs(found));
      assembly.interfaces[0].law = spring(5.0);
    }
  }
}

}  // namespace
}  // namespace harmos::latin
