#include <harmos/latin/detail/ErrorEstimate.hpp>

#include <numeric>

#include <gtest/gtest.h>

#include <harmos/latin/FixedPoint.hpp>

#include "Chains.hpp"

namespace harmos::latin {
namespace {

constexpr double accuracy = 0.1;

/// States of two chains, one load step, and what corrections between them tell.
class States {
 public:
  States()
      : assembly_(twoChains(laws::makeLaw("Perfect"), laws::makeLaw("Prescribed Traction", {{"X", 1.0}}))),
        fixedPoint_(assembly_, {}, self(), timers_) {}

  /// The state whose tractions are `away` from those of the first, before chains and laws have answered.
  Snapshot at(double away) {
    base::Matrix alpha(fixedPoint_.layout().rows(), 1), image(alpha);
    alpha.putScalar(away);
    return {fixedPoint_.apply(alpha, image), {}};
  }

  /// Of corrections by so much each, of which the last one leaves a share of its residual, and may hide so much; those
  /// before may hide `hiddenBefore`.
  ErrorEstimate after(const std::vector<double>& ways, double share = 0.1, double hidden = 0.0,
                      ErrorEstimate::Delivered delivered = ErrorEstimate::Delivered::a2, double hiddenBefore = 0.0) {
    ErrorEstimate estimate(accuracy, delivered);
    double place = -std::accumulate(ways.begin(), ways.end(), 0.0);  // sizes are those of the last state
    for (const double& way : ways) {
      const bool isLast = &way == &ways.back();
      const Snapshot from = at(place), to = at(place += way);
      last_ = to.distance(from);
      estimate.add(from, to, isLast ? share : 0.1, {isLast ? share : 0.1}, isLast ? hidden : hiddenBefore);
    }
    return estimate;
  }

  /// The error of the force field over the way of the last correction.
  double factor(const ErrorEstimate& estimate) const { return estimate.errors().at(0) / last_.at(0); }

 private:
  assembly::Assembly assembly_;
  base::Timers timers_;
  FixedPoint fixedPoint_;
  std::vector<double> last_;
};

TEST(ErrorEstimate, NeedsTwoCorrections) {
  States states;
  EXPECT_FALSE(states.after({0.01}).isKnown());
  EXPECT_FALSE(states.after({0.01}).isSmall());
  EXPECT_TRUE(states.after({0.01, 0.001}).isKnown());
  EXPECT_TRUE(states.after({0.01, 0.001}).isSmall());
}

// Corrections contract by 0.1, 0.7, 0.9.
TEST(ErrorEstimate, SumsUpWhatFurtherCorrectionsWouldGo) {
  States states;
  EXPECT_NEAR(states.factor(states.after({0.01, 0.001})), 1.0 / (1.0 - 0.6), 1e-6);
  // Sizes are those of a state that is 0.01 away from the last but one.
  EXPECT_NEAR(states.factor(states.after({0.01, 0.007})), 1.0 / (1.0 - 0.7), 0.05);
  EXPECT_NEAR(states.factor(states.after({0.01, 0.009})), 1.0 / (1.0 - 0.8) + 1.0, 1e-6) << "a2 is one farther away";
  EXPECT_NEAR(states.factor(states.after({0.01, 0.009}, 0.1, 0.0, ErrorEstimate::Delivered::a1)), 1.0 / (1.0 - 0.8),
              1e-6);
}

// A correction finds no more than it takes from the residual.
TEST(ErrorEstimate, CountsWhatLoadStepsKeepOfTheirResiduals) {
  States states;
  EXPECT_NEAR(states.factor(states.after({0.01, 0.001}, 0.3)), 1.0 / (1.0 - 0.6), 1e-6);
  EXPECT_NEAR(states.factor(states.after({0.01, 0.001}, 0.65)), 1.0 / (1.0 - 0.8), 1e-6);
  EXPECT_NEAR(states.factor(states.after({0.01, 0.001}, 0.9, 0.0, ErrorEstimate::Delivered::a1)), 10.0, 1e-6);
  EXPECT_TRUE(states.after({1e-4, 1e-5}, 0.94).isSmall());
  EXPECT_FALSE(states.after({1e-4, 1e-5}, 0.96).isSmall()) << "what moves it has not been found";
}

TEST(ErrorEstimate, IsNoClaimWhereItIsLargeOrCorrectionsGrowOrHideMore) {
  States states;
  EXPECT_FALSE(states.after({0.08, 0.06}).isSmall());
  EXPECT_TRUE(states.after({0.08, 0.02}).isSmall());
  EXPECT_FALSE(states.after({3.0, 1e-6}).isSmall()) << "from far away";
  const ErrorEstimate growing = states.after({0.0115, 0.012});
  EXPECT_TRUE(growing.grows());
  EXPECT_LT(growing.errors().at(0), accuracy);
  EXPECT_FALSE(growing.isSmall());
  EXPECT_FALSE(states.after({1e-9, 3e-9}).grows()) << "round-off";
  EXPECT_TRUE(states.after({0.01, 0.009}, 0.1, 0.9).isSmall());
  EXPECT_FALSE(states.after({0.01, 0.009}, 0.1, 2.0).isSmall());
  EXPECT_FALSE(states.after({0.01, 0.009}, 0.1, 0.0, ErrorEstimate::Delivered::a2, 2.0).isSmall()) << "the first";
  EXPECT_TRUE(states.after({1e-4, 1e-4}, 0.1, 2.0).isSmall()) << "hides nothing that would matter";
}

TEST(ErrorEstimate, TakesWhatCorrectionsCannotSee) {
  States states;
  ErrorEstimate estimate = states.after({1e-3, 1e-4});
  const double before = estimate.errors().at(0);
  estimate.addUnseen(0.2);
  EXPECT_DOUBLE_EQ(estimate.errors().at(0), before + 0.2);
  EXPECT_FALSE(estimate.isSmall());
}

}  // namespace
}  // namespace harmos::latin
