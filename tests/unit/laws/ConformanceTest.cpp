// What every interface law must do, whatever it describes. A law that is added to the list of built-ins is tested here
// without an edit: its parameters come from its own declaration.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include <gtest/gtest.h>

#include "LawSamples.hpp"
#include "TestedLaws.hpp"

namespace harmos::laws {
namespace {

constexpr int samples = 40;
constexpr double roundOff = 1e-13;  // a few hundred units in the last place: laws are short formulas

class Conformance : public testing::TestWithParam<std::string> {
 protected:
  Conformance() : registry_(testedLaws()) {
    for (const auto& form : registry_.forms()) {
      if (form.name() == GetParam()) spec_ = &form;
    }
  }

  std::unique_ptr<InterfaceLaw> draw() {
    drawParameters();
    return registry_.create(parameters_);
  }

  /// Of those that a law allows beside each other.
  void drawParameters() {
    for (int i = 0; i < 1000; ++i) {
      parameters_ = randomParameters(*spec_, random_);
      input::ErrorList errors;
      registry_.check(parameters_, errors);
      if (errors.count() == 0) return;
    }
    FAIL() << "no parameters are allowed";
  }

  /// The largest of the parameters and of their ratios: the slope of a law's graph is of this order at most.
  double largestParameter() const {
    double largest = 1.0, least = 1.0;
    const auto include = [&](double number) {
      largest = std::max(largest, std::abs(number));
      if (number != 0.0) least = std::min(least, std::abs(number));
    };
    for (const auto& entry : spec_->entries()) {
      if (entry->type == input::ParameterType::number) include(parameters_.number(entry->name));
      if (entry->type == input::ParameterType::numbers) {
        for (const double number : parameters_.numbers(entry->name)) include(number);
      }
    }
    return largest / least;
  }

  /// The traction's round-off on a line: what the law adds and multiplies may be larger than what is left.
  double tolerance(const LocalLine& line, const LocalState& state, double gap = 0.0) const {
    const double lengths = norm(line.freeJump) + std::abs(gap) + largestParameter();
    return roundOff * (norm(state.traction) + lengths / line.compliance) * largestParameter();
  }

  /// What the law carries along the surface depends on the pressure.
  bool hasCone(const InterfaceLaw& law) const {
    const auto admissible = law.admissibleTractions(0);
    return (admissible && admissible->friction > 0.0) || parameters_.has("Friction Coefficient");
  }

  LawRegistry registry_;
  const input::ParameterSpec* spec_ = nullptr;
  Random random_{20240405};
  input::Parameters parameters_;
};

TEST_P(Conformance, DeclaresItself) {
  EXPECT_FALSE(spec_->summary().empty());
  for (const auto& entry : spec_->entries()) {
    EXPECT_FALSE(entry->description.empty()) << entry->name;
    if (entry->type == input::ParameterType::number) {
      EXPECT_FALSE(entry->unitName.empty()) << entry->name;
    }
  }
  const auto law = draw();
  EXPECT_EQ(law->name(), GetParam());
  EXPECT_GE(law->historySize(), 0);
  if (law->prescribesTraction()) {
    EXPECT_EQ(law->sides(), Sides::one);
  }
}

// The graph t = R(delta) belongs to the law and the line to the solver: any other line through the point that was found
// must lead to the same point.
TEST_P(Conformance, FindsPointsOfOneGraph) {
  for (int i = 0; i < samples; ++i) {
    const auto law = draw();
    const double gap = uniform(random_, -1.0, 1.0);
    Node node(*law, gap);
    for (int step = 0; step < 6; ++step) {
      const LocalLine line = randomLine(random_, *law);
      const LocalState state = node.solve(line);
      const base::Vector3 jump = line.jump(state.traction);
      for (double ratio : {1e-3, 0.1, 1.0, 10.0, 1e3}) {
        LocalLine other;
        other.compliance = std::min(ratio * line.compliance, 0.95 * complianceLimit(*law));
        other.freeJump = jump + other.compliance * state.traction;
        const LocalState again = node.solve(other);
        // The jump carries the round-off of the first line.
        const double error = tolerance(other, state, gap) + tolerance(line, state, gap) / std::min(ratio, 1.0);
        EXPECT_LE(norm(again.traction - state.traction), error);
      }
      node.solve(line);
      node.accept();
    }
  }
}

// No traction lies outside of what the law says that it can carry, wherever it is led; where nothing is said of a
// component, it is asked for all.
TEST_P(Conformance, StaysWithinWhatItAdmits) {
  for (int i = 0; i < samples; ++i) {
    const auto law = draw();
    const auto admissible = law->admissibleTractions(0);
    if (!admissible) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_LE(admissible->lower[c], 0.0);
      EXPECT_GE(admissible->upper[c], 0.0);
    }
    const double gap = uniform(random_, -1.0, 1.0);
    Node node(*law, gap);
    for (int step = 0; step < 6; ++step) {
      const LocalLine line = randomLine(random_, *law);
      const LocalState state = node.solve(line);
      const double error = tolerance(line, state, gap);
      base::Vector3 beyond{};
      for (std::size_t c = 0; c < 3; ++c) {
        beyond[c] = std::max({0.0, admissible->lower[c] - state.traction[c], state.traction[c] - admissible->upper[c]});
      }
      EXPECT_LE(beyond[0], error);
      EXPECT_LE(tangentialNorm(beyond), admissible->friction * std::max(0.0, -state.traction[0]) + error);
      node.accept();
    }
  }
}

// Pulled along a component that takes any value, the law answers with more and more, both ways.
TEST_P(Conformance, ReachesWhatItAdmits) {
  for (int i = 0; i < samples; ++i) {
    const auto law = draw();
    const auto admissible = law->admissibleTractions(0);
    if (!admissible) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      for (const double sign : {-1.0, 1.0}) {
        const double limit = sign < 0.0 ? -admissible->lower[c] : admissible->upper[c];
        if (limit != AdmissibleTractions::unlimited) continue;
        LocalLine line;
        line.compliance = 1.0;
        line.freeJump[c] = sign * 1e12;
        EXPECT_GT(sign * Node(*law).solve(line).traction[c], 1e6);
      }
    }
  }
}

// With its history given, the graph of a law falls nowhere more than it says; where it does not, it is monotone, so
// that its resolvent is firmly non-expansive: LATIN converges. Softening is looked at along rays. A cone of friction is
// looked at under one pressure.
TEST_P(Conformance, FallsNoMoreThanItSays) {
  for (double exponent : {-12.0, -6.0, 0.0, 6.0, 12.0}) {
    for (int i = 0; i < samples; ++i) {
      const auto law = draw();
      const double slope = law->lowestSlope();
      EXPECT_LE(slope, 0.0);
      Node node(*law);
      for (int step = 0; step < i % 4; ++step) {
        node.solve(randomLine(random_, *law));
        node.accept();
      }
      LocalLine a = randomLine(random_, *law);
      if (slope == 0.0) a.compliance *= std::pow(10.0, exponent);
      LocalLine b = randomLine(random_);
      b.compliance = a.compliance;
      if (slope < 0.0) b.freeJump = uniform(random_, 0.0, 3.0) * a.freeJump;
      if (hasCone(*law)) b.freeJump[0] = a.freeJump[0];
      const LocalState atA = node.solve(a), atB = node.solve(b);
      const base::Vector3 difference = atA.traction - atB.traction;
      const base::Vector3 distance = a.freeJump - b.freeJump;
      const base::Vector3 jump = a.jump(atA.traction) - b.jump(atB.traction);
      EXPECT_LE(a.compliance * dot(difference, difference),
                dot(difference, distance) - slope * dot(jump, jump) +
                    roundOff * a.compliance * (dot(atA.traction, atA.traction) + dot(atB.traction, atB.traction)) +
                    roundOff * norm(distance) * (norm(atA.traction) + norm(atB.traction)));
    }
  }
}

// t_i is an affine function of the free jump's component i alone, the same one at all nodes.
TEST_P(Conformance, IsAffineWhereItSaysSo) {
  for (int i = 0; i < samples; ++i) {
    const auto law = draw();
    if (!law->isAffine()) return;
    EXPECT_EQ(law->historySize(), 0);
    LocalLine all = randomLine(random_), rest = all;
    rest.freeJump = {};
    const base::Vector3 offset = Node(*law).solve(rest).traction;
    EXPECT_EQ(Node(*law, 0.3).solve(rest).traction, offset);
    const LocalState together = Node(*law).solve(all);
    for (std::size_t c = 0; c < 3; ++c) {
      LocalLine axis = rest;
      axis.freeJump[c] = all.freeJump[c];
      const base::Vector3 change = Node(*law).solve(axis).traction - offset;
      const double error = tolerance(all, together) + roundOff * norm(offset);
      base::Vector3 along{};
      along[c] = together.traction[c] - offset[c];
      EXPECT_LE(norm(change - along), error);
      axis.freeJump[c] *= 3.0;
      EXPECT_LE(norm(Node(*law).solve(axis).traction - offset - 3.0 * change), 3.0 * error);
    }
  }
}

// A kink makes the second difference fall as slowly as the step; a smooth function has one that falls faster.
TEST_P(Conformance, IsSmoothWhereItSaysSo) {
  for (int i = 0; i < samples; ++i) {
    const auto law = draw();
    if (!law->isSmooth()) return;
    Node node(*law);
    node.solve(randomLine(random_, *law));
    node.accept();
    const LocalLine from = randomLine(random_, *law);
    const base::Vector3 way = randomVector(random_) - from.freeJump;
    const auto sharpest = [&](int moves) {
      double largest = 0.0;
      std::array<base::Vector3, 3> last{};
      for (int m = 0; m < moves; ++m) {
        LocalLine line = from;
        line.freeJump = line.freeJump + (static_cast<double>(m) / moves) * way;
        last = {last[1], last[2], node.solve(line).traction};
        if (m > 1) largest = std::max(largest, moves * norm(last[2] - 2.0 * last[1] + last[0]));
      }
      return largest;
    };
    const double error = tolerance(from, node.solve(from));
    EXPECT_LE(sharpest(4000), 0.5 * sharpest(400) + 4e4 * error);
  }
}

// Through opening, closing, sticking, sliding: many small moves make small changes only.
TEST_P(Conformance, IsContinuous) {
  constexpr int moves = 500;
  for (int i = 0; i < samples; ++i) {
    const auto law = draw();
    Node node(*law);
    node.solve(randomLine(random_, *law));
    node.accept();
    const LocalLine from = randomLine(random_, *law);
    const base::Vector3 move = (1.0 / moves) * (randomVector(random_) - from.freeJump);
    const double slope = 4.0 * largestParameter() / from.compliance;
    LocalLine line = from;
    LocalState before = node.solve(line);
    for (int m = 0; m < moves; ++m) {
      line.freeJump = line.freeJump + move;
      const LocalState state = node.solve(line);
      EXPECT_LE(norm(state.traction - before.traction), slope * norm(move) + tolerance(line, state));
      before = state;
    }
  }
}

// The frame's t1, t2 are arbitrary. A turn by 180 degrees is the exchange of the two sides.
TEST_P(Conformance, TurnsWithTheTangents) {
  for (int i = 0; i < samples; ++i) {
    const auto law = draw();
    if (law->frame() != Frame::interface) return;
    const double angle = i == 0 ? std::acos(-1.0) : uniform(random_, 0.0, 6.3);
    const auto turned = [angle](const base::Vector3& v) {
      const double c = std::cos(angle), s = std::sin(angle);
      return base::Vector3{v[0], c * v[1] - s * v[2], s * v[1] + c * v[2]};
    };
    base::Frame frame{};
    for (std::size_t c = 0; c < 3; ++c) {
      base::Vector3 axis{};
      axis[c] = 1.0;
      axis = turned(axis);
      for (std::size_t row = 0; row < 3; ++row) frame[row][c] = axis[row];
    }
    Node node(*law), other(*law, 0.0, frame);
    double error = 0.0;
    for (int step = 0; step < 6; ++step) {
      const LocalLine line = randomLine(random_, *law);
      const LocalState state = node.solve(line);
      const LocalState found = other.solve({turned(line.freeJump), line.compliance});
      // Histories carry the round-off of all steps so far.
      error += tolerance(line, state);
      EXPECT_LE(norm(found.traction - turned(state.traction)), error * (1.0 + 1.0 / line.compliance));
      node.accept();
      other.accept();
    }
  }
}

// In 2-D the third component is not there; it must not come into being.
TEST_P(Conformance, StaysInThePlane) {
  for (int i = 0; i < samples; ++i) {
    auto law = draw();
    if (parameters_.has("Axis")) {
      std::vector<double> axis = parameters_.numbers("Axis");
      axis[2] = 0.0;
      parameters_.set("Axis", axis);
      law = registry_.create(parameters_);
    }
    if (law->frame() != Frame::interface) return;
    Node node(*law);
    for (int step = 0; step < 6; ++step) {
      LocalLine line = randomLine(random_);
      line.freeJump[2] = 0.0;
      EXPECT_EQ(node.solve(line).traction[2], 0.0);
      node.accept();
    }
  }
}

// Work along a closed path of jumps from the unloaded start is lost or zero, never gained.
TEST_P(Conformance, Dissipates) {
  constexpr double stiff = 1e-6;  // compliance of lines on which the jump is as good as given
  for (int i = 0; i < samples; ++i) {
    const auto law = draw();
    if (!law->dissipates()) return;
    Node node(*law);
    std::vector<base::Vector3> path;
    for (int point = 0; point < 8; ++point) path.push_back(randomVector(random_));
    path.push_back({});
    double work = 0.0, error = 0.0;
    base::Vector3 old{};
    for (int cycle = 0; cycle < 3; ++cycle) {
      for (const base::Vector3& target : path) {
        const LocalLine line{target, stiff};
        const base::Vector3 traction = node.solve(line).traction;
        const base::Vector3 jump = line.jump(traction);
        const double done = traction[1] * (jump[1] - old[1]) + traction[2] * (jump[2] - old[2]);
        work += done;
        error += roundOff * norm(traction) * (norm(target) + norm(jump) + norm(old));
        old = jump;
        node.accept();
      }
      EXPECT_GE(work, -error);
    }
  }
}

// A load step without duration in which nothing happens changes nothing.
TEST_P(Conformance, StaysWhenTheLoadStays) {
  for (int i = 0; i < samples; ++i) {
    const auto law = draw();
    Node node(*law);
    for (int step = 0; step < 4; ++step) {
      const LocalLine line = randomLine(random_, *law);
      const LocalState state = node.solve(line);
      node.accept();
      const LocalState again = node.solve(line, 0, 0.0);
      node.accept();
      EXPECT_LE(norm(again.traction - state.traction), tolerance(line, state));
    }
  }
}

TEST_P(Conformance, WritesItsHistoryAndReadsTheOldOne) {
  for (int i = 0; i < samples; ++i) {
    const auto law = draw();
    Node node(*law);
    for (int step = 0; step < 6; ++step) {
      const LocalLine line = randomLine(random_, *law);
      const std::vector<double> before = node.oldHistory();
      const LocalState state = node.solve(line);
      const std::vector<double> history = node.newHistory();
      for (double value : history) EXPECT_TRUE(std::isfinite(value));
      EXPECT_EQ(node.oldHistory(), before);
      // An iteration that met another line in between leaves no trace.
      node.solve(randomLine(random_, *law));
      EXPECT_EQ(node.solve(line).traction, state.traction);
      EXPECT_EQ(node.newHistory(), history);
      node.accept();
    }
  }
}

TEST_P(Conformance, SolvesManyNodesAsOne) {
  constexpr std::size_t count = 7;
  const auto law = draw();
  const auto size = static_cast<std::size_t>(law->historySize());
  std::vector<LocalLine> lines;
  std::vector<double> gaps, oldHistory, newHistory(count * size);
  std::vector<LocalState> states(count), single;
  std::vector<double> singleHistory;
  for (std::size_t n = 0; n < count; ++n) {
    gaps.push_back(uniform(random_, -0.1, 0.1));
    Node node(*law, gaps.back());
    node.solve(randomLine(random_, *law));
    node.accept();
    oldHistory.insert(oldHistory.end(), node.oldHistory().begin(), node.oldHistory().end());
    lines.push_back(randomLine(random_, *law));
    single.push_back(node.solve(lines.back()));
    singleHistory.insert(singleHistory.end(), node.newHistory().begin(), node.newHistory().end());
  }
  NodeArrays nodes{static_cast<int>(count), lines.data(),      gaps.data(),
                   oldHistory.data(),       newHistory.data(), states.data()};
  nodes.time = nodes.duration = 1.0;
  const std::vector<base::Vector3> places(count, base::Vector3{1.0, 2.0, 3.0});
  nodes.position = places.data();
  const std::vector<double> areas(count, 1.0);
  nodes.area = areas.data();
  law->solve(0, nodes);
  for (std::size_t n = 0; n < count; ++n) {
    EXPECT_EQ(states[n].traction, single[n].traction);
    EXPECT_EQ(states[n].status, single[n].status);
  }
  EXPECT_EQ(newHistory, singleHistory);
  law->solve(0, {0, nullptr, nullptr, nullptr, nullptr, nullptr});
}

TEST_P(Conformance, OpenCarriesNothing) {
  for (int i = 0; i < samples; ++i) {
    const auto law = draw();
    Node node(*law, uniform(random_, -1.0, 1.0));
    for (int step = 0; step < 6; ++step) {
      const LocalState state = node.solve(randomLine(random_, *law));
      if (state.status == Status::open) {
        EXPECT_EQ(state.traction, base::Vector3{});
      }
      node.accept();
    }
  }
}

// A number that varies over the load steps has at each step the effect of a constant.
TEST_P(Conformance, FollowsSchedules) {
  const std::vector<double> multipliers{1.0, 0.25, 0.0, 0.75};
  for (const auto& entry : spec_->entries()) {
    if (!entry->varies) continue;
    for (int i = 0; i < samples; ++i) {
      draw();
      const double value = parameters_.number(entry->name);
      input::Histories histories;
      histories.add("ramp", multipliers);
      input::Parameters varying = parameters_;
      varying.set(entry->name + " History", std::string("ramp"));
      varying.attach(std::make_shared<input::Histories>(histories));
      const auto law = registry_.create(varying);
      for (std::size_t step = 0; step < multipliers.size(); ++step) {
        if (!entry->allows(multipliers[step] * value)) continue;
        input::Parameters constant = parameters_;
        constant.set(entry->name, multipliers[step] * value);
        const auto expected = registry_.create(constant);
        const LocalLine line = randomLine(random_, *law);
        EXPECT_EQ(Node(*law).solve(line, static_cast<int>(step)).traction, Node(*expected).solve(line).traction)
            << entry->name << " at step " << step;
      }
    }
  }
}

/// Factor of a unit such as "stress/length" or "energy/length^2" when lengths are multiplied by 2^l, stresses by 2^s
/// and times by 2^t; powers of two change no digit.
double unitFactor(const std::string& unit, int l, int s, int t) {
  int exponent = 0, sign = 1;
  for (std::size_t begin = 0; begin < unit.size();) {
    const std::size_t end = std::min(unit.find_first_of("*/ ", begin), unit.size());
    std::string base = unit.substr(begin, end - begin);
    int power = 1;
    if (const std::size_t hat = base.find('^'); hat != std::string::npos) {
      power = std::stoi(base.substr(hat + 1));
      base.erase(hat);
    }
    if (base == "length") {
      exponent += sign * power * l;
    } else if (base == "stress") {
      exponent += sign * power * s;
    } else if (base == "force") {
      exponent += sign * power * (s + 2 * l);
    } else if (base == "energy") {
      exponent += sign * power * (s + 3 * l);
    } else if (base == "time") {
      exponent += sign * power * t;
    } else if (base != "-" && base != "1") {
      ADD_FAILURE() << "unit \"" << unit << "\": \"" << base << "\" is none of length, stress, force, energy, time, -";
    }
    if (end < unit.size()) sign = unit[end] == '/' ? -1 : 1;
    begin = end + 1;
  }
  return std::ldexp(1.0, exponent);
}

// Millimetres or metres, the digits are the same: no law hides a tolerance with a unit. The scales make H, stiffnesses
// and lengths differ by up to 1e-12 .. 1e12.
TEST_P(Conformance, KnowsNoUnits) {
  for (const auto& [l, s, t] :
       {std::tuple{10, 20, 3}, std::tuple{-10, -20, -3}, std::tuple{40, 0, 30}, std::tuple{0, -40, 0}}) {
    for (int i = 0; i < samples; ++i) {
      const auto law = draw();
      const auto scale = [l = l, s = s, t = t](const input::ParameterEntry& entry) {
        return unitFactor(entry.unitName, l, s, t);
      };
      const auto other = registry_.create(scaled(*spec_, parameters_, scale));
      const double length = std::ldexp(1.0, l), stress = std::ldexp(1.0, s);
      const double gap = uniform(random_, -1.0, 1.0);
      Node node(*law, gap), otherNode(*other, length * gap, Node::axes, length * length, length * Node::somewhere);
      for (int step = 0; step < 6; ++step) {
        const LocalLine line = randomLine(random_, *law);
        const LocalState state = node.solve(line);
        const LocalState found =
            otherNode.solve({length * line.freeJump, line.compliance * length / stress}, 0, std::ldexp(1.0, t));
        EXPECT_LE(norm((1.0 / stress) * found.traction - state.traction), roundOff * norm(state.traction));
        EXPECT_EQ(found.status, state.status);
        node.accept();
        otherNode.accept();
      }
    }
  }
}

// Lines and parameters 1e-12 .. 1e12 apart: no overflow, no division by zero, and the point stays where it was when the
// line is met again.
TEST_P(Conformance, SurvivesExtremeRatios) {
  for (double hardness : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
    for (double compliance : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
      for (int i = 0; i < 10; ++i) {
        drawParameters();
        const auto law = registry_.create(scaled(*spec_, parameters_, [&](const input::ParameterEntry& entry) {
          const bool isOne = entry.type == input::ParameterType::number;
          return isOne && !entry.allows(hardness * parameters_.number(entry.name)) ? 1.0 : hardness;
        }));
        Node node(*law);
        for (int step = 0; step < 3; ++step) {
          LocalLine line = randomLine(random_);
          line.compliance *= compliance;
          const LocalState state = node.solve(line);
          for (double t : state.traction) EXPECT_TRUE(std::isfinite(t));
          for (double value : node.newHistory()) EXPECT_TRUE(std::isfinite(value));
          LocalLine again = line;
          again.freeJump = line.jump(state.traction) + line.compliance * state.traction;
          EXPECT_LE(line.compliance * norm(node.solve(again).traction - state.traction),
                    1e-12 * largestParameter() *
                        (norm(line.freeJump) + line.compliance * norm(state.traction) + hardness * largestParameter()));
          node.solve(line);
          node.accept();
        }
      }
    }
  }
}

// The ends of the declared ranges, nodes at rest, gaps that just close: where 0/0 hides.
TEST_P(Conformance, SurvivesZeros) {
  drawParameters();
  const auto law = registry_.create(scaled(*spec_, parameters_, [](const input::ParameterEntry& entry) {
    return entry.type == input::ParameterType::number && entry.allows(0.0) ? 0.0 : 1.0;
  }));
  for (double gap : {0.0, -1.0, 1.0}) {
    for (const base::Vector3& jump :
         {base::Vector3{}, base::Vector3{1.0, 0.0, 0.0}, base::Vector3{-1.0, 0.0, 0.0}, base::Vector3{0.0, 1.0, 0.0}}) {
      Node node(*law, gap);
      for (int step = 0; step < 2; ++step) {
        for (double t : node.solve({jump, 1.0}).traction) EXPECT_TRUE(std::isfinite(t));
        for (double value : node.newHistory()) EXPECT_TRUE(std::isfinite(value));
        node.accept();
      }
    }
  }
}

// What it adds to the results has names and units, and numbers along every path.
TEST_P(Conformance, WritesWhatItAdds) {
  for (int i = 0; i < samples; ++i) {
    const auto law = draw();
    const std::vector<OutputField> outputs = law->outputs();
    for (const OutputField& field : outputs) {
      EXPECT_EQ(field.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string::npos) << field.name;
      EXPECT_TRUE(!field.name.empty() && field.name.size() <= 32 && !field.unit.empty() && !field.doc.empty());
      EXPECT_EQ(std::count_if(outputs.begin(), outputs.end(), [&](const auto& o) { return o.name == field.name; }), 1);
    }
    Node node(*law);
    for (int step = 0; step < 6; ++step) {
      node.solve(randomLine(random_, *law));
      const PairStep at = node.step();
      std::vector<double> values(outputs.size(), std::numeric_limits<double>::quiet_NaN());
      law->output(at, values.data());
      for (const double value : values) EXPECT_TRUE(std::isfinite(value));
      EXPECT_GE(law->storedEnergy(at), 0.0);
      EXPECT_TRUE(std::isfinite(law->keptWork(at)));
      node.accept();
    }
  }
}

// What is lost is never won back: not in a load step, whatever its way, and kept work is what the energy rises by, but
// for what a load step takes that is solved at its end.
TEST_P(Conformance, LosesInEveryStep) {
  for (int i = 0; i < samples; ++i) {
    const auto law = draw();
    if (!law->dissipates()) return;
    Node node(*law);
    for (int step = 0; step < 8; ++step) {
      const LocalLine line = randomLine(random_, *law);
      node.solve(line);
      const PairStep at = node.step();
      // The jump of what sticks is the round-off of its line.
      const double length = norm(at.jump) + norm(at.oldJump) + line.compliance * norm(at.traction);
      const double scale = norm(at.traction) * length + std::abs(law->keptWork(at));
      EXPECT_GE(at.work() - law->keptWork(at), -1e3 * roundOff * scale);
      node.accept();
    }
  }
}

// Work is stored or lost: from the end of a first load step on, what is kept of it is what the free energy rises by,
// the better the shorter the load steps. To and fro along straight ways, each in so many load steps of one duration in
// all.
TEST_P(Conformance, BalancesItsEnergy) {
  constexpr int pieces = 800;
  for (int i = 0; i < 10; ++i) {
    const auto law = draw();
    if (!law->dissipates()) return;
    std::vector<base::Vector3> corners{{}};
    for (int corner = 0; corner < 3; ++corner) corners.push_back(randomVector(random_));
    corners.push_back(corners[1]);
    const double compliance = randomLine(random_, *law).compliance;
    double work = 0.0, fastest = 0.0;
    const auto imbalance = [&](int parts) {
      Node node(*law);
      double kept = 0.0, stored = 0.0;
      work = 0.0;
      const auto go = [&](const base::Vector3& freeJump) {
        node.solve({freeJump, compliance}, 0, 1.0 / parts);
        const PairStep at = node.step();
        kept += law->keptWork(at);
        stored = law->storedEnergy(at);
        work += std::abs(at.work());
        node.accept();
        return norm(at.jump - at.oldJump);
      };
      go(corners.front());
      const double first = stored;
      kept = work = 0.0;
      for (std::size_t c = 1; c < corners.size(); ++c) {
        for (int part = 1; part <= parts; ++part) {
          const double moved = go(corners[c - 1] + (static_cast<double>(part) / parts) * (corners[c] - corners[c - 1]));
          fastest = std::max(fastest, parts * moved / norm(corners[c] - corners[c - 1]));
        }
      }
      return kept - (stored - first);
    };
    // The error of load steps is proportional to their length, but for the few in which a gap closes or a slider stops,
    // where it is of the second order.
    double events = 0.0;
    for (std::size_t c = 1; c < corners.size(); ++c) {
      const base::Vector3 move = (1.0 / pieces) * (corners[c] - corners[c - 1]);
      events += 4.0 * dot(move, move) / compliance;
    }
    const double coarse = imbalance(pieces), fine = imbalance(2 * pieces);
    // What snaps, as wear does that takes the pressure from friction, loses within one load step, however short.
    if (fastest > 20.0) continue;
    EXPECT_LE(std::abs(2.0 * fine - coarse), 1e-4 * work + events);
  }
}

// A value that is not a number must not be swallowed; the local stage turns it into an error.
TEST_P(Conformance, PassesOnWhatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < samples; ++i) {
    const auto law = draw();
    if (law->prescribesTraction()) return;
    const LocalState state = Node(*law).solve({{nan, nan, nan}, 1.0});
    EXPECT_FALSE(std::isfinite(state.traction[0] + state.traction[1] + state.traction[2]));
    const LocalState normal = Node(*law).solve({{nan, 0.1, 0.2}, 1.0});
    EXPECT_FALSE(std::isfinite(normal.traction[0] + normal.traction[1] + normal.traction[2]));
  }
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  const LawRegistry laws = testedLaws();
  const std::vector<std::string> untested = untestedLaws();
  for (const auto& form : laws.forms()) {
    if (std::find(untested.begin(), untested.end(), form.name()) == untested.end()) result.push_back(form.name());
  }
  return result;
}

INSTANTIATE_TEST_SUITE_P(Laws, Conformance, testing::ValuesIn(names()), [](const auto& test) {
  std::string name;
  std::copy_if(test.param.begin(), test.param.end(), std::back_inserter(name), [](char c) { return std::isalnum(c); });
  return name;
});

}  // namespace
}  // namespace harmos::laws
