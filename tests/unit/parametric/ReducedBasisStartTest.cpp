#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/parametric/MarchBatch.hpp>

#include "../latin/Chains.hpp"

namespace harmos::parametric {
namespace {

constexpr int steps = 4;
constexpr ConfigurationIteration::Remembered remembered{3, 24, 10};

/// Two chains pressed together and dragged to and fro; the parameter multiplies friction, pressure or way.
class Dragged : public testing::Test {
 protected:
  Dragged()
      : assembly_(latin::twoChains(friction(0.3), drag(1.0), steps)),
        fixedPoint_(assembly_, {}, latin::self(), timers_),
        solver_(fixedPoint_, substructure::Precision::exact),
        states_(20) {}

  static std::shared_ptr<const laws::InterfaceLaw> friction(double coefficient) {
    return laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", coefficient}});
  }
  static std::shared_ptr<const laws::InterfaceLaw> drag(double way) {
    return laws::makeLaw("Prescribed Displacement", {{"X", -0.15}, {"Y", 0.1 * way}, {"Z", 0.02 * way}},
                         {{"Y", {0.2, 1.0, 0.8, -1.0}}});
  }
  base::Matrix zero() const { return base::Matrix(fixedPoint_.layout().rows(), steps); }
  double residualAt(const base::Matrix& alpha) {
    base::Matrix image(zero());
    fixedPoint_.apply(alpha, image);
    image -= alpha;
    return fixedPoint_.metric().norm(image);
  }
  /// Iterates to round-off and stores the solution.
  base::Matrix solve(int id, double value) {
    base::Matrix alpha(zero()), image(zero());
    for (int i = 0; i < 2000; ++i) {
      fixedPoint_.apply(alpha, image);
      for (int t = 0; t < steps; ++t) {
        for (int row = 0; row < alpha.numRows(); ++row) alpha(row, t) = 0.5 * (alpha(row, t) + image(row, t));
      }
    }
    const latin::Iterate& iterate = fixedPoint_.apply(alpha, image);
    states_.widen({value});
    states_.add(id, {value}, alpha, iterate.beta());
    return alpha;
  }

  /// What the reduced basis gives for all load steps without a solve; expects the states that it is made of.
  base::Matrix startOf(const std::vector<int>& states, double value, int neighbours) {
    const base::Matrix offset(zero());
    base::Matrix alpha(zero());
    ReducedBasisStart start(fixedPoint_, fixedPoint_.pointwiseStage(), 0);
    start.begin(states_, {value}, neighbours, offset);
    EXPECT_EQ(start.starts(), states);
    for (int t = 0; t < steps; ++t) {
      fixedPoint_.select({t});
      start.find(t, 0.0);
      std::copy_n(start.state()[0], alpha.numRows(), alpha[t]);
      base::Matrix traction(alpha.numRows(), 1);
      start.settle(t, start.state(), start.beta());
      fixedPoint_.pointwiseStage().begin();
      fixedPoint_.pointwiseStage().solveColumn(0, start.beta(), traction);
      fixedPoint_.pointwiseStage().accept();
      fixedPoint_.startFromHere();
    }
    fixedPoint_.startUnloaded();
    fixedPoint_.selectAll();
    return alpha;
  }

  base::Timers timers_;
  assembly::Assembly assembly_;
  latin::FixedPoint fixedPoint_;
  StepSolver solver_;
  SolvedStates states_;
};

// While all stick the solution is affine in the way: two states span it.
TEST_F(Dragged, AreFoundInTheSpanOfTwo) {
  assembly_.interfaces[2].law = drag(0.01);
  solve(1, 0.01);
  assembly_.interfaces[2].law = drag(0.02);
  solve(2, 0.02);
  assembly_.interfaces[2].law = drag(0.04);
  const base::Matrix start = startOf({2, 1}, 0.04, 5);
  EXPECT_LT(residualAt(start), 1e-5 * fixedPoint_.metric().norm(start));  // states are kept in single precision
}

// With slip to and fro it is not; the start is no worse than the nearest state.
TEST_F(Dragged, HaveAStartBetterThanTheNearestState) {
  std::vector<base::Matrix> solutions;
  for (int id = 1; id <= 3; ++id) {
    assembly_.interfaces[1].law = friction(0.1 * id);
    solutions.push_back(solve(id, 0.1 * id));
  }
  assembly_.interfaces[1].law = friction(0.24);
  EXPECT_LT(residualAt(startOf({2, 3, 1}, 0.24, 3)), 0.5 * residualAt(solutions[1]));
}

// What has been solved for is known as states are: where it leads to the solution, no further solve is needed.
TEST_F(Dragged, AreImprovedAlongWhatWasSolvedFor) {
  const base::Matrix exact = solve(1, 1.0);
  const int rows = exact.numRows();
  base::Matrix alpha(zero()), linear(zero());
  states_.copy(0, alpha, linear);
  SolvedStates nothing(1);
  nothing.widen({1.0});
  const base::Matrix offset(zero()), column(rows, 1);
  nothing.add(1, {1.0}, offset, offset);
  ReducedBasisStart start(fixedPoint_, fixedPoint_.pointwiseStage(), 1);
  start.begin(nothing, {1.0}, 1, offset);
  fixedPoint_.select({0});
  start.find(0, 0.0);
  const auto error = [&] {
    base::Matrix difference(Teuchos::Copy, exact, rows, 1);
    difference -= start.state();
    return fixedPoint_.metric().norm(difference);
  };
  const double size = error();
  start.improve(column, column, 0.0);
  EXPECT_EQ(error(), size);
  start.remember({Teuchos::Copy, alpha, rows, 1}, {Teuchos::Copy, linear, rows, 1});
  start.improve(column, column, 0.0);
  EXPECT_LT(error(), 1e-6 * size);  // states are kept in single precision
  fixedPoint_.startUnloaded();
  fixedPoint_.selectAll();
}

// The way of the iteration: the error of an estimated response goes to 0 with its indicator, from a start or without.
TEST_F(Dragged, AreSolvedByAMarch) {
  for (int id = 1; id <= 3; ++id) {
    assembly_.interfaces[1].law = friction(0.1 * id);
    solve(id, 0.1 * id);
  }
  assembly_.interfaces[1].law = friction(0.24);
  const base::Matrix exact = solve(4, 0.24);
  const std::vector<std::shared_ptr<const latin::Response>> none;
  SolvedStates three(3), empty(1);
  three.widen({0.1});
  three.widen({0.3});
  base::Matrix alpha(zero()), linear(zero());
  for (int i = 0; i < 3; ++i) {
    states_.copy(i, alpha, linear);
    three.add(i + 1, {0.1 * (i + 1)}, alpha, linear);
  }
  ConfigurationIteration iteration(fixedPoint_, solver_, none, remembered, 1e-6, timers_);
  int stages[2];
  for (const bool isWarm : {false, true}) {
    iteration.begin(isWarm ? three : empty, {0.24});
    EXPECT_EQ(iteration.starts().size(), isWarm ? 3u : 0u);
    results::Indicators indicators;
    for (int i = 0; i < 5; ++i) indicators = iteration.march({1e-9, 1e-9});
    EXPECT_LT(indicators.force, 1e-8);
    EXPECT_LT(indicators.balance, 1e-8);
    base::Matrix error(iteration.alpha());
    error -= exact;
    EXPECT_LT(fixedPoint_.metric().norm(error), 1e-6 * fixedPoint_.metric().norm(exact));
    base::Matrix image(zero());
    const latin::Iterate& iterate = fixedPoint_.apply(iteration.alpha(), image);
    base::Matrix linearError(iteration.linear());
    linearError -= iterate.beta();
    EXPECT_LT(linearError.normInf(), 1e-9 * iterate.beta().normInf());
    iteration.begin(isWarm ? three : empty, {0.24});
    iteration.march({1e-3, 1e-3});
    stages[isWarm] = iteration.stages();
  }
  EXPECT_LT(stages[1], stages[0]);
}

// A march that is given too few linear stages comes to no end; given enough, it does.
TEST_F(Dragged, AreGivenUpAtTheLimit) {
  const std::vector<std::shared_ptr<const latin::Response>> none;
  ConfigurationIteration iteration(fixedPoint_, solver_, none, remembered, 1e-6, timers_);
  for (const bool isEnough : {false, true}) {
    iteration.begin(SolvedStates(1), {0.3});
    iteration.setLimit(isEnough ? 100.0 : 2.0);
    iteration.march({1e-6, 1e-6});
    EXPECT_EQ(iteration.isLost(), !isEnough);
    EXPECT_LE(iteration.stages(), isEnough ? 100 : 3);
  }
}

/// How often the phase has run.
int starts(const base::Timers& timers, const std::string& phase) {
  for (const base::Timers::Phase& one : timers.phases()) {
    if (one.name == phase) return one.starts;
  }
  return 0;
}

/// A law between two sides that answers to nothing.
class Refusal final : public laws::InterfaceLaw {
 public:
  explicit Refusal(int historySize) : historySize_(historySize) {}
  const char* name() const override { return "Refusal"; }
  int historySize() const override { return historySize_; }
  laws::Frame frame() const override { return laws::Frame::interface; }
  laws::Sides sides() const override { return laws::Sides::two; }
  bool prescribesTraction() const override { return false; }
  bool dissipates() const override { return true; }
  void solve(int /*step*/, const laws::NodeArrays& /*nodes*/) const override { throw base::Error("it refuses"); }

 private:
  int historySize_;
};

// Side by side each goes the way that it goes alone, at other laws and under other loads; solves are fewer. One whose
// law throws disturbs none.
TEST_F(Dragged, MarchSideBySideAsAlone) {
  const std::vector<std::shared_ptr<const latin::Response>> none;
  for (int id = 1; id <= 3; ++id) {
    assembly_.interfaces[1].law = friction(0.1 * id);
    solve(id, 0.1 * id);
  }
  struct Case {
    std::shared_ptr<const laws::InterfaceLaw> friction, drag;
  };
  const std::vector<Case> cases = {{friction(0.24), drag(1.0)},
                                   {std::make_shared<Refusal>(friction(0.2)->historySize()), drag(1.0)},
                                   {friction(0.13), drag(0.7)},
                                   {friction(0.28), drag(1.2)}};
  const auto put = [&](const Case& one) {
    assembly_.interfaces[1].law = one.friction;
    assembly_.interfaces[2].law = one.drag;
  };
  const results::Indicators target = {1e-9, 1e-9};
  std::vector<base::Matrix> alone;
  std::vector<std::unique_ptr<ConfigurationIteration>> iterations;
  std::vector<MarchBatch::Member> members;
  int solves = 0, stages = 0;
  for (const Case& one : cases) {
    put(one);
    fixedPoint_.updateLaws();
    iterations.push_back(
        std::make_unique<ConfigurationIteration>(fixedPoint_, solver_, none, remembered, 1e-6, timers_));
    ConfigurationIteration& iteration = *iterations.back();
    const bool isRefused = &one == &cases[1];
    if (isRefused) {
      iteration.begin(SolvedStates(1), {0.2});
    } else {
      iteration.begin(states_, {0.2});
    }
    if (isRefused) {
      alone.emplace_back();
    } else {
      const int before = starts(timers_, "block solve");
      iteration.march(target);
      solves += starts(timers_, "block solve") - before;
      stages += iteration.stages();
      alone.push_back(iteration.alpha());
      iteration.begin(states_, {0.2});
    }
    iteration.startMarch(target);
    members.push_back({&iteration, [&put, &one] { put(one); }});
  }
  const int before = starts(timers_, "block solve");
  const auto waits = [](const MarchBatch::Member& member) { return member.waits; };
  while (std::any_of(members.begin(), members.end(), waits)) {
    MarchBatch(fixedPoint_, solver_).run(members, [] { return false; });
  }
  int together = starts(timers_, "block solve") - before;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_EQ(members[i].error.empty(), i != 1) << members[i].error;
    if (i == 1) continue;
    put(cases[i]);
    fixedPoint_.updateLaws();
    iterations[i]->endMarch();
    ++together;
    stages -= iterations[i]->stages();
    base::Matrix difference(iterations[i]->alpha());
    difference -= alone[i];
    // Round-off, which a march to 1e-9 makes larger.
    EXPECT_LT(difference.normInf(), 1e-9 * alone[i].normInf()) << i;
  }
  EXPECT_EQ(stages, 0);
  EXPECT_LT(together, solves - 5);
}

// Tangents of the start are those of its image: a small step along each changes residual and image as they say.
TEST_F(Dragged, HaveTangentsOfTheirImage) {
  for (int id = 1; id <= 3; ++id) {
    assembly_.interfaces[1].law = friction(0.1 * id);
    solve(id, 0.1 * id);
  }
  assembly_.interfaces[1].law = friction(0.24);
  ReducedBasisStart start(fixedPoint_, fixedPoint_.pointwiseStage(), 0);
  const base::Matrix offset(zero());
  start.begin(states_, {0.24}, 3, offset);
  fixedPoint_.select({0});
  start.find(0, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(start.hasTangents());
  start.differentiate();
  ASSERT_TRUE(start.hasTangents());
  // The columns are the differences of the image less those of the residual, which is measured in the metric.
  const int rows = start.state().numRows(), count = start.residualTangents().numCols();
  const std::vector<double>& scale = fixedPoint_.metric().scale();
  base::Matrix here(rows, 1), there(rows, 1), beta(start.beta());
  const auto imageAt = [&](const base::Matrix& linear, base::Matrix& image) {
    fixedPoint_.pointwiseStage().begin();
    fixedPoint_.pointwiseStage().solveColumn(0, linear, image);
    for (int row = 0; row < rows; ++row) image[0][row] = 2.0 * image[0][row] - linear[0][row];
  };
  imageAt(beta, here);
  int moving = 0;
  for (int j = 0; j < count; ++j) {
    base::Matrix column(rows, 1), unused(rows, 1), unloaded(rows, 1);
    double size = 0.0;
    for (int row = 0; row < rows; ++row) {
      column[0][row] = start.imageTangents()[j][row] - start.residualTangents()[j][row] / scale[row];
      size = std::max(size, std::abs(column[0][row]));
    }
    if (size == 0.0) continue;
    ++moving;
    const double length = 1e-6 * start.state().normInf() / size;
    column.scale(length);
    const base::Matrix linear(fixedPoint_.apply(column, unused).beta());
    for (int row = 0; row < rows; ++row) beta[0][row] = start.beta()[0][row] + linear[0][row];
    imageAt(beta, there);
    for (int row = 0; row < rows; ++row) {
      EXPECT_NEAR((there[0][row] - here[0][row]) / length, start.imageTangents()[j][row], 1e-4 * size) << j;
    }
  }
  EXPECT_GE(moving, 3);
  fixedPoint_.selectAll();
}

// A gauge knows the imbalance of a load step alone.
TEST_F(Dragged, ShowTheImbalanceOfASingleStep) {
  const std::vector<std::shared_ptr<const latin::Response>> none;
  Gauge gauge(fixedPoint_, none);
  base::Matrix alpha = solve(1, 0.3), image(zero());
  alpha.scale(1.1);
  const latin::Iterate& iterate = fixedPoint_.apply(alpha, image);
  const results::Indicators disturbed = gauge.measure(iterate, alpha, image);
  double largest = 0.0;
  for (int t = 0; t < steps; ++t) {
    const auto column = [&](const base::Matrix& field) {
      return base::Matrix(Teuchos::Copy, field, alpha.numRows(), 1, 0, t);
    };
    largest =
        std::max(largest, gauge.imbalance(column(alpha), column(iterate.beta()), column(iterate.hattedTraction())));
  }
  EXPECT_NEAR(largest, disturbed.balance * gauge.forces()[0], 1e-12 * gauge.forces()[0]);
}

// The gap between f and f^ at a point: body "left" carries what the joint does not balance.
TEST_F(Dragged, ShowTheirImbalance) {
  const std::vector<std::shared_ptr<const latin::Response>> responses = {
      std::make_shared<latin::ResultantResponse>("force", std::vector<int>{1}, std::vector<base::Vector3>{})};
  base::Matrix alpha = solve(1, 0.3), image(zero());
  Gauge gauge(fixedPoint_, responses);
  const results::Indicators solved = gauge.measure(fixedPoint_.apply(alpha, image), alpha, image);
  EXPECT_LT(solved.force, 1e-8);
  EXPECT_LT(solved.responses[0], 1e-8);
  alpha.scale(1.1);
  const latin::Iterate& iterate = fixedPoint_.apply(alpha, image);
  const results::Indicators disturbed = gauge.measure(iterate, alpha, image);
  EXPECT_GT(disturbed.force, 1e-3);
  double largest = 0.0;
  for (int t = 0; t < steps; ++t) {
    for (const auto& [first, second] :
         {std::pair(fixedPoint_.layout().begin(0, 0), fixedPoint_.layout().begin(1, 0)),
          std::pair(fixedPoint_.layout().begin(1, 1), fixedPoint_.layout().begin(2, 0))}) {
      std::array<double, 3> sum{};
      for (int c = 0; c < 3; ++c) {
        for (int row : {first + c, second + c}) {
          sum[c] += iterate.hattedTraction()(row, t) - iterate.traction()(row, t);
        }
      }
      largest = std::max(largest, std::hypot(sum[0], sum[1], sum[2]));
    }
  }
  double size = 0.0;
  for (double value : responses[0]->evaluate(iterate)) size = std::max(size, std::abs(value));
  EXPECT_NEAR(disturbed.responses[0], largest / size, 1e-12);
}

// A force by its own size, what is lost beside what forces do; in balance it is the residual that shows its error.
TEST_F(Dragged, MeasureEachResponseByItsSize) {
  const std::vector<std::shared_ptr<const latin::Response>> responses = {
      std::make_shared<latin::ResultantResponse>("force", std::vector<int>{1}, std::vector<base::Vector3>{}),
      std::make_shared<latin::DissipationResponse>("lost", std::vector<int>{1})};
  Gauge gauge(fixedPoint_, responses);
  base::Matrix alpha = solve(1, 0.3), image(zero());
  const double lost = responses[1]->evaluate(fixedPoint_.apply(alpha, image)).back();
  ASSERT_GT(lost, 0.0);
  alpha.scale(1.01);
  const latin::Iterate& iterate = fixedPoint_.apply(alpha, image);
  const results::Indicators measured = gauge.measure(iterate, alpha, image);
  const std::vector<double> forces = gauge.forces();
  ASSERT_EQ(forces.size(), 3u);
  const latin::NaturalSizes sizes(iterate);
  const double natural = sizes.natural(latin::Quantity::energy, forces[0]);
  EXPECT_GT(natural, 0.0);
  EXPECT_LE(natural, forces[0] * sizes.natural(latin::Quantity::displacement, forces[0]) * (1.0 + 1e-12));
  EXPECT_NEAR(forces[2], forces[0] * std::clamp(responses[1]->evaluate(iterate).back() / natural, 1e-3, 1.0),
              1e-12 * forces[0]);
  const double imbalance = measured.balance * forces[0];
  EXPECT_NEAR(measured.responses[0], imbalance / forces[1], 1e-12);
  EXPECT_NEAR(measured.responses[1], std::max(imbalance, measured.force * forces[0] / 3.0) / forces[2], 1e-12);
  // What is measured is just allowed where it is the target.
  const results::Indicators none = {1.0, 1.0, {1.0, measured.responses[1]}};
  EXPECT_GE(gauge.allowedForce(none, forces), measured.force * (1.0 - 1e-12));
  EXPECT_GE(gauge.allowedImbalance(none, forces), imbalance * (1.0 - 1e-12));
  EXPECT_NEAR(gauge.allowedForce(none, forces) * forces[0] / 3.0, measured.responses[1] * forces[2], 1e-12 * forces[0]);
  EXPECT_TRUE(std::isinf(gauge.allowedImbalance(none, {})));
}

// Where all stick nothing is lost, and no accuracy of it is asked for.
TEST_F(Dragged, AskForNothingOfAResponseThatIsZero) {
  assembly_.interfaces[1].law = friction(100.0);
  fixedPoint_.updateLaws();
  const std::vector<std::shared_ptr<const latin::Response>> responses = {
      std::make_shared<latin::DissipationResponse>("lost", std::vector<int>{1})};
  Gauge gauge(fixedPoint_, responses);
  base::Matrix alpha = solve(1, 100.0), image(zero());
  alpha.scale(1.01);
  const results::Indicators measured = gauge.measure(fixedPoint_.apply(alpha, image), alpha, image);
  EXPECT_GT(measured.force, 1e-4);
  EXPECT_EQ(measured.responses[0], 0.0);
  EXPECT_EQ(gauge.allowedForce({1e-3, 1e-3, {1e-9}}, gauge.forces()), 1e-3);
}

}  // namespace
}  // namespace harmos::parametric
