#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/latin/PointwiseLocalStage.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

constexpr double roundOff = 1e-12;

std::shared_ptr<const laws::InterfaceLaw> friction(double mu) {
  return laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", mu}});
}

/// Local stage of two cubes with an interface in a frame that is nowhere along the axes.
struct Stage {
  explicit Stage(const std::shared_ptr<const laws::InterfaceLaw>& law, int steps,
                 Formulation formulation = Formulation::displacement)
      : cubes(twoCubes(law, laws::makeLaw("Symmetry"), steps)),
        k(prepared(), 1.0, *self()),
        eliminated(cubes.assembly(), k, Elimination::none, {}),
        layout(cubes.assembly(), k, eliminated, self()),
        local(cubes.assembly(), k, layout, formulation),
        beta(layout.rows(), steps),
        traction(layout.rows(), steps) {
    local.select(allSteps(steps));
  }

  const assembly::Assembly& prepared() {
    const double a = 0.6, b = 0.8;
    for (auto& frame : cubes.assembly().interfaces[1].frame) frame = {{{0, b, a}, {1, 0, 0}, {0, a, -b}}};
    return cubes.assembly();
  }

  double stiffness(int pair) const { return k.of(1)[pair]; }

  /// Components in the interface's frame.
  base::Vector3 inFrame(const base::Vector3& v, int pair) const {
    const base::Frame& frame = cubes_().frame[pair];
    base::Vector3 components{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) components[i] += frame[i][j] * v[j];
    }
    return components;
  }
  const assembly::Interface& cubes_() const { return const_cast<BoxAssembly&>(cubes).assembly().interfaces[1]; }

  base::Vector3 at(const base::Matrix& field, int side, int pair, int column) const {
    const double* from = field[column] + layout.begin(1, side) + 3 * pair;
    return {from[0], from[1], from[2]};
  }
  /// w^ = (f^ - beta) / k, which is E+ with beta = f - k w; in the velocity form, the increment of the step.
  base::Vector3 hattedTrace(int side, int pair, int column) const {
    base::Vector3 w = at(traction, side, pair, column);
    const base::Vector3 b = at(beta, side, pair, column);
    for (std::size_t c = 0; c < 3; ++c) w[c] = (w[c] - b[c]) / stiffness(pair);
    return w;
  }
  base::Vector3 hattedJump(int pair, int column) const {
    base::Vector3 jump = hattedTrace(1, pair, column);
    const base::Vector3 w1 = hattedTrace(0, pair, column);
    for (std::size_t c = 0; c < 3; ++c) jump[c] -= w1[c];
    return inFrame(jump, pair);
  }

  BoxAssembly cubes;
  assembly::SearchDirection k;
  EliminatedBoundaries eliminated;
  TraceLayout layout;
  PointwiseLocalStage local;
  base::Matrix beta, traction;
};

TEST(LocalStage, BalancesBothSidesOnEveryLine) {
  Stage stage(friction(0.3), 3);
  randomize(stage.beta);
  stage.local.solve(stage.beta, stage.traction);
  for (int t = 0; t < 3; ++t) {
    for (int p = 0; p < stage.cubes_().pairs(); ++p) {
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_EQ(stage.at(stage.traction, 0, p, t)[c], -stage.at(stage.traction, 1, p, t)[c]);
    }
  }
}

// With both ascent directions fulfilled by construction, the hatted jump and traction must be a point of the law.
TEST(LocalStage, PutsPerfectJointsTogether) {
  Stage stage(laws::makeLaw("Perfect"), 2);
  randomize(stage.beta);
  stage.local.solve(stage.beta, stage.traction);
  for (int p = 0; p < stage.cubes_().pairs(); ++p) {
    for (double jump : stage.hattedJump(p, 1)) EXPECT_NEAR(jump * stage.stiffness(p), 0.0, roundOff);
  }
}

TEST(LocalStage, ObeysCoulombsLawInTheFrameOfTheNodes) {
  constexpr double mu = 1.0;
  Stage stage(friction(mu), 3);
  randomize(stage.beta);
  stage.local.solve(stage.beta, stage.traction);
  int statuses[3] = {};
  for (int p = 0; p < stage.cubes_().pairs(); ++p) {
    base::Vector3 old{};
    for (int t = 0; t < 3; ++t) {
      const base::Vector3 f = stage.inFrame(stage.at(stage.traction, 0, p, t), p);
      const base::Vector3 jump = stage.hattedJump(p, t);
      const double k = stage.stiffness(p);
      EXPECT_LE(f[0], roundOff);
      EXPECT_GE(jump[0] * k, -roundOff);
      EXPECT_NEAR(f[0] * jump[0] * k, 0.0, roundOff);
      const double tangential = std::hypot(f[1], f[2]), limit = -mu * f[0];
      EXPECT_LE(tangential, limit + roundOff);
      const base::Vector3 slip{0.0, jump[1] - old[1], jump[2] - old[2]};
      const auto status =
          stage.local
              .states(1)[static_cast<std::size_t>(t) * static_cast<std::size_t>(stage.cubes_().pairs()) +
                         static_cast<std::size_t>(p)]
              .status;
      ++statuses[static_cast<int>(status)];
      if (status == laws::Status::stick) {
        EXPECT_NEAR(k * std::hypot(slip[1], slip[2]), 0.0, roundOff);
      }
      if (status == laws::Status::slip) {
        EXPECT_NEAR(tangential, limit, roundOff);
        EXPECT_NEAR(k * (slip[1] * f[2] - slip[2] * f[1]), 0.0, roundOff);
        EXPECT_GE(slip[1] * f[1] + slip[2] * f[2], 0.0);
      }
      old = jump;
    }
  }
  // The test is worth something only when it met all of them.
  EXPECT_GT(statuses[0], 0);
  EXPECT_GT(statuses[1], 0);
  EXPECT_GT(statuses[2], 0);
}

// beta = f - k dw in the velocity form: the law still sees jumps, the sums of the increments.
TEST(LocalStage, AddsUpIncrementsInTheVelocityForm) {
  constexpr double mu = 0.3, gap = 0.05;
  Stage stage(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", mu}, {"Gap", gap}}), 4,
              Formulation::velocity);
  randomize(stage.beta);
  stage.local.solve(stage.beta, stage.traction);
  for (int p = 0; p < stage.cubes_().pairs(); ++p) {
    base::Vector3 jump{};
    for (int t = 0; t < 4; ++t) {
      const base::Vector3 f = stage.inFrame(stage.at(stage.traction, 0, p, t), p);
      const base::Vector3 increment = stage.hattedJump(p, t);
      for (std::size_t c = 0; c < 3; ++c) jump[c] += increment[c];
      EXPECT_GE(jump[0] + gap, -roundOff);
      EXPECT_NEAR(f[0] * (jump[0] + gap), 0.0, roundOff);
      EXPECT_LE(std::hypot(f[1], f[2]), -mu * f[0] + roundOff);
    }
  }
}

TEST(LocalStage, MovesABoundaryAsPrescribed) {
  Stage stage(laws::makeLaw("Perfect"), 2);
  stage.cubes.assembly().interfaces[0].law =
      laws::makeLaw("Prescribed Displacement", {{"Y", 0.5}}, {{"Y", {1.0, 3.0}}});
  PointwiseLocalStage local(stage.cubes.assembly(), stage.k, stage.layout, Formulation::displacement);
  local.select(allSteps(2));
  randomize(stage.beta);
  local.solve(stage.beta, stage.traction);
  const double k = stage.k.of(0)[0];
  const int row = stage.layout.begin(0, 0);
  EXPECT_EQ(stage.traction[1][row], 0.0);
  EXPECT_NEAR((stage.traction[0][row + 1] - stage.beta[0][row + 1]) / k, 0.5, roundOff);
  EXPECT_NEAR((stage.traction[1][row + 1] - stage.beta[1][row + 1]) / k, 1.5, roundOff);
}

TEST(LocalStage, SolvesAChoiceOfLoadSteps) {
  Stage stage(laws::makeLaw("Preload Jump", {{"Jump", 1.0}}, {{"Jump", {1.0, 2.0, 3.0, 4.0}}}), 4);
  randomize(stage.beta);
  stage.local.solve(stage.beta, stage.traction);
  base::Matrix beta(stage.beta.numRows(), 2), traction(stage.beta.numRows(), 2);
  for (int row = 0; row < beta.numRows(); ++row) {
    beta(row, 0) = stage.beta(row, 1);
    beta(row, 1) = stage.beta(row, 3);
  }
  stage.local.select({1, 3});
  stage.local.solve(beta, traction);
  for (int row = 0; row < beta.numRows(); ++row) {
    EXPECT_EQ(traction(row, 0), stage.traction(row, 1));
    EXPECT_EQ(traction(row, 1), stage.traction(row, 3));
  }
}

/// Breaks at the third load step.
struct Broken {
  static constexpr const char* name = "Broken";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;
  laws::LocalState solve(const laws::LocalLine&, const laws::NodeContext& at, const double*, double*) const {
    laws::LocalState state;
    if (at.step == 2) state.traction[1] = value;
    return state;
  }
  double value = std::numeric_limits<double>::quiet_NaN();
};

TEST(LocalStage, NamesInterfaceStepAndLawOfWhatIsNotANumber) {
  for (double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Stage stage(std::make_shared<laws::PointwiseLaw<Broken>>(Broken{value}), 4);
    try {
      stage.local.solve(stage.beta, stage.traction);
      FAIL();
    } catch (const base::Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(error.code(), base::ExitCode::notConverged);
      for (const char* part : {"\"joint\"", "load step 3", "\"Broken\""})
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }
  }
}

TEST(LocalStage, RefusesInputThatIsNotANumber) {
  Stage stage(friction(0.3), 1);
  stage.beta.putScalar(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(stage.local.solve(stage.beta, stage.traction), base::Error);
}

}  // namespace
}  // namespace harmos::latin
