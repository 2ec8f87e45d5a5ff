// A certificate sees one search direction only: laws are asked again for what does not depend on it.
#include <cmath>
#include <cstdint>
#include <cstring>

#include <gtest/gtest.h>

#include <harmos/latin/LatinSolver.hpp>
#include <harmos/laws/CoupledLaw.hpp>
#include <harmos/laws/PointwiseLaw.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"
#include "Faces.hpp"

namespace harmos::latin {
namespace {

constexpr double stiffness = 40.0, strength = 0.5;

/// Glue that takes a share of the compliance of its line for the whole: 1 is right.
struct Glue {
  static constexpr const char* name = "Own Glue";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;
  explicit Glue(double shareOfCompliance) : share(shareOfCompliance) {}
  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext&, const double*, double*) const {
    laws::LocalState state;
    state.traction = (stiffness / (1.0 + stiffness * share * line.compliance)) * line.freeJump;
    return state;
  }
  double share;
};

/// Glue that is torn above a jump, which a monotone law is not.
struct Torn {
  static constexpr const char* name = "Torn";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;
  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext&, const double*, double*) const {
    laws::LocalState state;
    state.traction = (stiffness / (1.0 + stiffness * line.compliance)) * line.freeJump;
    if (norm(line.jump(state.traction)) > 0.02) state.traction = 0.1 * state.traction;
    return state;
  }
};

/// Glue whose traction falls by `fall` per jump beyond a peak, and says that it falls by `says`: a little less than
/// lines need to meet it once.
struct Falling {
  static constexpr const char* name = "Falling";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;
  Falling(double falls, double claim) : fall(falls), says(claim) {}
  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext&, const double*, double*) const {
    constexpr double peak = 0.01;
    laws::LocalState state;
    for (std::size_t c = 0; c < 3; ++c) {
      const double free = std::abs(line.freeJump[c]);
      double traction = stiffness * free / (1.0 + stiffness * line.compliance);
      if (traction > stiffness * peak) {
        traction = (stiffness * peak - fall * (free - peak)) / (1.0 - fall * line.compliance);
      }
      state.traction[c] = std::copysign(traction, line.freeJump[c]);
    }
    return state;
  }
  double lowestSlope() const { return -says; }
  double fall, says;
};

/// In [-1, 1], the same for the same number, and of no period: places at even distances would meet a wave as a smooth
/// function where they keep step with it.
double scatterOf(double number) {
  std::uint64_t bits = 0;
  static_assert(sizeof bits == sizeof number);
  std::memcpy(&bits, &number, sizeof bits);
  for (const std::uint64_t factor : {0xbf58476d1ce4e5b9U, 0x94d049bb133111ebU}) bits = (bits ^ bits >> 30U) * factor;
  return std::ldexp(static_cast<double>(bits >> 11U), -52) - 1.0;
}

double wave(double number) {
  return std::sin(1e13 * number);
}

/// Glue whose tractions scatter by a share of themselves: of a kind that a line meets alike each time.
struct Scattering {
  static constexpr const char* name = "Scattering";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;
  explicit Scattering(double shareOfTraction, double (*ofNumber)(double) = scatterOf)
      : share(shareOfTraction), scatter(ofNumber) {}
  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext&, const double*, double*) const {
    laws::LocalState state;
    for (std::size_t c = 0; c < 3; ++c) {
      const double free = line.freeJump[c];
      state.traction[c] = stiffness * free / (1.0 + stiffness * line.compliance) * (1.0 + share * scatter(free));
    }
    return state;
  }
  double share;
  double (*scatter)(double);
};

/// A spring and a slider along n. What it stores is `stored` times right, what it keeps `kept` times.
struct Slider {
  static constexpr const char* name = "Own Slider";
  static constexpr int historySize = 1;  // slip
  static constexpr laws::Sides sides = laws::Sides::two;
  static constexpr bool dissipates = true;
  Slider(double keptShare, double storedShare) : kept(keptShare), stored(storedShare) {}
  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext&, const double* old, double* now) const {
    laws::LocalState state;
    for (std::size_t c = 0; c < 3; ++c)
      state.traction[c] =
          stiffness * (line.freeJump[c] - (c == 0 ? old[0] : 0.0)) / (1.0 + stiffness * line.compliance);
    now[0] = old[0];
    if (state.traction[0] > strength) {
      state.traction[0] = strength;
      now[0] = line.jump(state.traction)[0] - strength / stiffness;
    }
    return state;
  }
  double keptWork(const laws::PairStep& step) const {
    return kept * (step.work() - step.traction[0] * (step.history[0] - step.oldHistory[0]));
  }
  double storedEnergy(const laws::PairStep& step) const {
    return stored * dot(step.traction, step.traction) / (2.0 * stiffness);
  }
  double kept, stored;
};

/// A spring between the mean motions of both sides, which takes a share of the compliance of its lines for the whole.
class MeanSpring : public laws::CoupledLaw {
 public:
  explicit MeanSpring(double shareOfCompliance) : share_(shareOfCompliance) {}
  const char* name() const override { return "Own Mean Spring"; }
  int historySize() const override { return 0; }
  laws::Frame frame() const override { return laws::Frame::interface; }
  laws::Sides sides() const override { return laws::Sides::two; }
  bool dissipates() const override { return false; }
  int sums() const override { return 5; }
  void addToSums(int /*step*/, const laws::NodeArrays& nodes, double* sums) const override {
    for (int p = 0; p < nodes.count; ++p) {
      for (std::size_t c = 0; c < 3; ++c) sums[c] += nodes.area[p] * nodes.line[p].freeJump[c];
      sums[3] += nodes.area[p] * nodes.line[p].compliance;
      sums[4] += nodes.area[p];
    }
  }
  void solvePoints(int step, const laws::NodeArrays& nodes, const double* sums) const override {
    solveTangent(step, nodes, sums);
  }
  void solveTangent(int /*step*/, const laws::NodeArrays& nodes, const double* sums) const override {
    for (int p = 0; p < nodes.count; ++p) {
      for (std::size_t c = 0; c < 3; ++c) {
        nodes.state[p].traction[c] = stiffness * sums[c] / (sums[4] + stiffness * share_ * sums[3]);
      }
    }
  }

 private:
  double share_;
};

LatinResult solve(std::shared_ptr<const laws::InterfaceLaw> joint, const LatinOptions& options = {}) {
  const std::shared_ptr<const laws::InterfaceLaw> drive =
      laws::makeLaw("Prescribed Displacement", {{"X", 0.3}, {"Y", 0.1}, {"Z", 0.0}},
                    {{"X", {0.3, 1.0, 0.2}}, {"Y", {0.1, 0.3, 0.2}}});
  const assembly::Assembly assembly = twoChains(std::move(joint), drive, 3);
  base::Timers timers;
  LatinSolver solver(assembly, options, self(), timers);
  solver.addResponse(std::make_shared<ResultantResponse>("force", std::vector<int>{1}, std::vector<base::Vector3>{}));
  return solver.solve();
}

/// Remarks on laws; others are on what nothing holds.
std::vector<std::string> onLaws(const LatinResult& result) {
  std::vector<std::string> found;
  for (const std::string& remark : result.remarks) {
    if (remark.rfind("law ", 0) == 0) found.push_back(remark);
  }
  return found;
}

template <class Law, class... Arguments>
std::shared_ptr<const laws::InterfaceLaw> own(Arguments... arguments) {
  return std::make_shared<laws::PointwiseLaw<Law>>(arguments...);
}

TEST(LawCheck, CertifiesALawThatSolvesItsEquations) {
  const LatinResult result = solve(own<Glue>(1.0));
  EXPECT_EQ(result.outcome, Outcome::certified) << result.reason;
  EXPECT_TRUE(onLaws(result).empty());
}

TEST(LawCheck, RefusesALawThatSolvesOtherEquations) {
  for (const double share : {0.5, 0.9, 1.1, 2.0}) {
    const LatinResult result = solve(own<Glue>(share));
    EXPECT_EQ(result.outcome, Outcome::iterationLimit) << share;
    EXPECT_NE(result.reason.find("interface \"joint\", load step "), std::string::npos) << result.reason;
    EXPECT_NE(result.reason.find("point 1: law \"Own Glue\" gives another traction at the same jump"),
              std::string::npos)
        << result.reason;
  }
}

// A law over a whole face is asked with the sums over all of it.
TEST(LawCheck, AsksLawsOverWholeFaces) {
  const LatinResult right = solve(std::make_shared<MeanSpring>(1.0));
  EXPECT_EQ(right.outcome, Outcome::certified) << right.reason;
  const LatinResult wrong = solve(std::make_shared<MeanSpring>(0.5));
  EXPECT_EQ(wrong.outcome, Outcome::iterationLimit);
  EXPECT_NE(wrong.reason.find("law \"Own Mean Spring\" gives another traction at the same jump"), std::string::npos)
      << wrong.reason;
}

TEST(LawCheck, AsksLawsInVelocityForm) {
  LatinOptions options;
  options.stages.formulation = Formulation::velocity;
  const LatinResult right = solve(own<Glue>(1.0), options);
  EXPECT_EQ(right.outcome, Outcome::certified) << right.reason;
  const LatinResult slider = solve(own<Slider>(1.0, 1.0), options);
  EXPECT_EQ(slider.outcome, Outcome::certified) << slider.reason;
  EXPECT_TRUE(onLaws(slider).empty());
  const LatinResult wrong = solve(own<Glue>(0.5), options);
  EXPECT_EQ(wrong.outcome, Outcome::iterationLimit);
  EXPECT_NE(wrong.reason.find("gives another traction at the same jump"), std::string::npos) << wrong.reason;
}

TEST(LawCheck, RefusesALawThatFallsAndDoesNotSay) {
  const LatinResult result = solve(own<Torn>());
  EXPECT_NE(result.outcome, Outcome::certified);
}

// No line tells, since it meets each once.
TEST(LawCheck, RemarksOnALawThatFallsAndDoesNotSay) {
  const LatinResult silent = solve(own<Falling>(0.2, 0.0));
  EXPECT_EQ(silent.outcome, Outcome::certified) << silent.reason;
  ASSERT_EQ(onLaws(silent).size(), 1U);
  EXPECT_NE(onLaws(silent)[0].find("law \"Falling\" of interface \"joint\" says that its traction never falls"),
            std::string::npos)
      << onLaws(silent)[0];
  EXPECT_TRUE(onLaws(solve(own<Falling>(0.2, 0.2))).empty());
  EXPECT_TRUE(onLaws(solve(own<Falling>(0.0, 0.0))).empty());
}

TEST(LawCheck, RemarksOnEnergiesThatDoNotGoTogether) {
  EXPECT_TRUE(onLaws(solve(own<Slider>(1.0, 1.0))).empty());
  const LatinResult kept = solve(own<Slider>(3.0, 1.0));
  EXPECT_EQ(kept.outcome, Outcome::certified) << kept.reason;
  ASSERT_EQ(onLaws(kept).size(), 1U);
  EXPECT_NE(onLaws(kept)[0].find("law \"Own Slider\" of interface \"joint\" keeps more work than is done on it"),
            std::string::npos)
      << onLaws(kept)[0];
  const LatinResult stored = solve(own<Slider>(0.0, 1.0));
  EXPECT_EQ(stored.outcome, Outcome::certified) << stored.reason;
  ASSERT_EQ(onLaws(stored).size(), 1U);
  EXPECT_NE(onLaws(stored)[0].find("stores more energy than the work that it keeps"), std::string::npos)
      << onLaws(stored)[0];
}

// Whether it comes to an end or not, nothing is certified beyond the digits of the law.
TEST(LawCheck, RefusesAnAccuracyThatALawHasNotTheDigitsFor) {
  LatinOptions options;
  for (const double accuracy : {1e-4, 1e-6, 1e-8}) {
    options.accuracy = accuracy;
    // A thousandth of it may keep corrections from coming to their end, and so may this where it has no period.
    const LatinResult accepted = solve(own<Scattering>(1e-5 * accuracy, wave), options);
    EXPECT_EQ(accepted.outcome, Outcome::certified) << accuracy << ": " << accepted.reason;
    EXPECT_EQ(solve(own<Falling>(0.0, 0.0), options).outcome, Outcome::certified) << accuracy;
    const LatinResult refused = solve(own<Scattering>(50.0 * accuracy), options);
    EXPECT_NE(refused.outcome, Outcome::certified) << accuracy;
    EXPECT_LE(refused.linearStages, 210) << accuracy << refused.reason;  // its digits are looked at every 100 stages
    EXPECT_NE(refused.reason.find("law \"Scattering\" of interface \"joint\""), std::string::npos) << refused.reason;
  }
}

// Corrections that come to no end in the round-off of a law are told from others.
TEST(LawCheck, NamesTheLawWhoseRoundOffKeepsCorrectionsFromAnEnd) {
  LatinOptions options;
  options.accuracy = 1e-6;
  options.maximumIterations = 150;
  const LatinResult result = solve(own<Scattering>(0.1 * options.accuracy), options);
  ASSERT_EQ(result.outcome, Outcome::iterationLimit);
  EXPECT_NE(result.reason.find("law \"Scattering\" of interface \"joint\" leaves its tractions no digits below"),
            std::string::npos)
      << result.reason;
  options.maximumIterations = 5;
  const LatinResult other = solve(own<Falling>(0.0, 0.0), options);
  ASSERT_EQ(other.outcome, Outcome::iterationLimit);
  EXPECT_EQ(other.reason.find("digits"), std::string::npos) << other.reason;
}

/// Remarks on a joint that is pressed and then pulled along.
std::vector<std::string> remarksOn(const std::shared_ptr<const laws::InterfaceLaw>& joint) {
  const std::shared_ptr<const laws::InterfaceLaw> drive =
      laws::makeLaw("Prescribed Displacement", {{"X", -0.3}, {"Y", 0.1}, {"Z", 0.07}},
                    {{"X", {0.31, 0.7, 1.0}}, {"Y", {0.3, 0.7, 0.1}}, {"Z", {0.1, 0.5, 0.3}}});
  const assembly::Assembly assembly = twoChains(joint, drive, 3);
  base::Timers timers;
  LatinSolver solver(assembly, {}, self(), timers);
  solver.addResponse(std::make_shared<ResultantResponse>("force", std::vector<int>{1}, std::vector<base::Vector3>{}));
  const LatinResult result = solver.solve();
  EXPECT_EQ(result.outcome, Outcome::certified) << result.reason;
  return onLaws(result);
}

// What sticks does no work but that of round-off, and its largest jump is one of round-off, too.
TEST(LawCheck, TakesRoundOffForNoEnergy) {
  for (const double friction : {0.7, 1.0, 2.0, 10.0}) {
    const auto remarks = remarksOn(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", friction}}));
    EXPECT_TRUE(remarks.empty()) << friction << ": " << remarks[0];
  }
}

// A gap that grows while it is pressed does work on the bodies, which the law keeps nothing of.
TEST(LawCheck, ExpectsNoBalanceOfLawsThatAreDriven) {
  const auto remarks = remarksOn(
      laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.2}, {"Gap", -0.02}}, {{"Gap", {0.0, 1.0, 3.0}}}));
  EXPECT_TRUE(remarks.empty()) << remarks[0];
}

TEST(LawCheck, RemarksOnEnergiesThatAreNotFinite) {
  const LatinResult result = solve(own<Slider>(1.0, std::nan("")));
  EXPECT_EQ(result.outcome, Outcome::certified) << result.reason;
  ASSERT_EQ(onLaws(result).size(), 1U);
  EXPECT_NE(onLaws(result)[0].find("gives energies that are not finite"), std::string::npos) << onLaws(result)[0];
}

// Of softening laws only steeper lines are asked.
TEST(LawCheck, LeavesSofteningLawsInPeace) {
  const LatinResult result = solve(softGlue(2.0));
  EXPECT_EQ(result.outcome, Outcome::certified) << result.reason;
}

// A face that moves far leaves the other one of its law no more digits than it has itself.
TEST(LawCheck, CertifiesALawBetweenAFaceThatMovesFarAndOneThatDoesNot) {
  BoxAssembly bar({{"left", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {"right", {1, 0, 0}, {2, 1, 1}, {2, 2, 2}}});
  std::map<std::string, double> spring{{"X Stiffness", 1e-3}};
  for (const char* held : {"Y", "Z", "Rotation X", "Rotation Y", "Rotation Z"}) spring[held] = 0.0;
  holdFace(bar, {"left_xmin"}, laws::makeLaw("Remote Displacement", spring));
  holdFace(bar, {"left_xmax"},
           laws::makeLaw("Face Spring", {{"Axial Stiffness", 0.0}, {"Shear Stiffness", 1e6}}, {},
                         {{"Point", {1.0, 0.5, 0.5}}, {"Axis", {1.0, 0.0, 0.0}}}),
           {"right_xmin"});
  bar.hold("load", "left_ymax", laws::makeLaw("Prescribed Traction", {{"X", 2.0}}));
  base::Timers timers;
  LatinSolver solver(bar.assembly(), {}, self(), timers);
  const LatinResult result = solver.solve();
  EXPECT_EQ(result.outcome, Outcome::certified) << result.reason;
}

}  // namespace
}  // namespace harmos::latin
