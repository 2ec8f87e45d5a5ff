#include <gtest/gtest.h>

#include <harmos/study/Indicators.hpp>
#include <harmos/study/ReducedBasisStart.hpp>

#include "../latin/Chains.hpp"

namespace harmos::study {
namespace {

constexpr int steps = 4;

/// Two chains pressed together and dragged to and fro; the parameter multiplies friction, pressure or way.
class Dragged : public testing::Test {
 protected:
  Dragged()
      : assembly_(latin::twoChains(friction(0.3), drag(1.0), steps)),
        fixedPoint_(assembly_, {}, latin::self(), timers_),
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
    fixedPoint_.apply(alpha, image);
    states_.widen({value});
    states_.add(id, {value}, alpha, fixedPoint_.beta());
    return alpha;
  }

  base::Timers timers_;
  interface::Assembly assembly_;
  latin::FixedPoint fixedPoint_;
  SolvedStates states_;
};

// While all stick the solution is affine in the way: two states span it.
TEST_F(Dragged, AreFoundInTheSpanOfTwo) {
  assembly_.interfaces[2].law = drag(0.01);
  solve(1, 0.01);
  assembly_.interfaces[2].law = drag(0.02);
  solve(2, 0.02);
  assembly_.interfaces[2].law = drag(0.04);
  ReducedBasisStart start(fixedPoint_);
  start.find(states_, {0.04}, 5, zero());
  EXPECT_EQ(start.starts(), (std::vector<int>{2, 1}));
  const double size = fixedPoint_.metric().norm(start.state());
  EXPECT_LT(start.residual(), 1e-5 * size);  // states are kept in single precision
  EXPECT_NEAR(residualAt(start.state()), start.residual(), 1e-5 * size);
}

// With slip to and fro it is not; the start is no worse than the nearest state and its image is what a stage gives.
TEST_F(Dragged, HaveAStartBetterThanTheNearestState) {
  std::vector<base::Matrix> solutions;
  for (int id = 1; id <= 3; ++id) {
    assembly_.interfaces[1].law = friction(0.1 * id);
    solutions.push_back(solve(id, 0.1 * id));
  }
  assembly_.interfaces[1].law = friction(0.24);
  ReducedBasisStart start(fixedPoint_);
  start.find(states_, {0.24}, 3, zero());
  EXPECT_EQ(start.starts().size(), 3u);
  EXPECT_LT(start.residual(), 0.5 * residualAt(solutions[1]));
  base::Matrix image(zero());
  fixedPoint_.apply(start.state(), image);
  image -= start.image();
  EXPECT_LT(fixedPoint_.metric().norm(image), 1e-5 * fixedPoint_.metric().norm(start.image()));
}

// The gap between f and f^ at a point: body "left" carries what the joint does not balance.
TEST_F(Dragged, ShowTheirImbalance) {
  const std::vector<std::shared_ptr<const latin::Response>> responses = {
      std::make_shared<latin::ResultantResponse>("force", std::vector<int>{1}, std::vector<mesh::Point>{})};
  base::Matrix alpha = solve(1, 0.3), image(zero());
  fixedPoint_.apply(alpha, image);
  const Indicators solved = indicatorsOf(fixedPoint_, alpha, image, responses);
  EXPECT_LT(solved.force, 1e-8);
  EXPECT_LT(solved.response, 1e-8);
  alpha.scale(1.1);
  fixedPoint_.apply(alpha, image);
  const Indicators disturbed = indicatorsOf(fixedPoint_, alpha, image, responses);
  EXPECT_GT(disturbed.force, 1e-3);
  double largest = 0.0;
  for (int t = 0; t < steps; ++t) {
    for (const auto& [first, second] :
         {std::pair(fixedPoint_.layout().begin(0, 0), fixedPoint_.layout().begin(1, 0)),
          std::pair(fixedPoint_.layout().begin(1, 1), fixedPoint_.layout().begin(2, 0))}) {
      std::array<double, 3> sum{};
      for (int c = 0; c < 3; ++c) {
        for (int row : {first + c, second + c}) {
          sum[static_cast<std::size_t>(c)] += fixedPoint_.hattedTraction()(row, t) - fixedPoint_.traction()(row, t);
        }
      }
      largest = std::max(largest, std::hypot(sum[0], sum[1], sum[2]));
    }
  }
  double size = 0.0;
  for (double value : responses[0]->evaluate(fixedPoint_)) size = std::max(size, std::abs(value));
  EXPECT_NEAR(disturbed.response, largest / size, 1e-12);
}

}  // namespace
}  // namespace harmos::study
