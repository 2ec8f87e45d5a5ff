#include <gtest/gtest.h>

#include <harmos/latin/EquilibriumWatch.hpp>
#include <harmos/latin/StepNewton.hpp>

#include "Chains.hpp"

namespace harmos::latin {
namespace {

using Law = std::shared_ptr<const laws::InterfaceLaw>;

constexpr double accuracy = 1e-3;
constexpr double pull = 2.5;

Law contact() {
  return laws::makeLaw("Unilateral Contact");
}
Law traction(double x) {
  return laws::makeLaw("Prescribed Traction", {{"X", x}});
}

/// The relaxed iteration on two chains, watched.
struct Watched {
  explicit Watched(assembly::Assembly chains, double ignored = accuracy, double scale = 1.0, bool isSure = false)
      : assembly(std::move(chains)), watch(ignored, [isSure](int) { return isSure; }) {
    StageOptions options;
    options.searchDirectionScale = scale;
    base::Timers timers;
    FixedPoint fixedPoint(assembly, options, self(), timers);
    base::Matrix alpha(fixedPoint.layout().rows(), assembly.steps()), image(alpha);
    while (foundAt == 0 && iterations < 200) {
      const Iterate* iterate = &fixedPoint.apply(alpha, image);
      ++iterations;
      const base::Matrix before(image);
      if (watch.look(fixedPoint, iterate, alpha, image) == EquilibriumWatch::Finding::noEquilibrium)
        foundAt = iterations;
      EXPECT_EQ(image, before);
      image -= alpha;
      image.scale(0.5);
      alpha += image;
    }
  }

  assembly::Assembly assembly;
  EquilibriumWatch watch;
  int iterations = 0;
  int foundAt = 0;  // 0: never
};

// Nothing holds the right chain; the watch has to see that four times, nine iterations apart.
TEST(EquilibriumWatch, FindsABodyThatIsPulledOff) {
  const Watched pulled(twoChains(contact(), traction(pull)));
  EXPECT_EQ(pulled.foundAt, 36);
  EXPECT_EQ(pulled.watch.imbalance().body, 1);
  EXPECT_EQ(pulled.watch.imbalance().step, 0);
  EXPECT_NEAR(pulled.watch.imbalance().force[0], -pull, 0.05 * pull);
}

TEST(EquilibriumWatch, NamesTheLoadStep) {
  const Law growing = laws::makeLaw("Prescribed Traction", {{"X", pull}}, {{"X", {-1.0, 0.0, 1.0}}});
  const Watched pulled(twoChains(contact(), growing, 3));
  EXPECT_EQ(pulled.foundAt, 36);
  EXPECT_EQ(pulled.watch.imbalance().step, 2);
}

TEST(EquilibriumWatch, IsQuietWhereItIsKnownBetter) {
  EXPECT_EQ(Watched(twoChains(contact(), traction(pull)), accuracy, 1.0, true).foundAt, 0);
}

TEST(EquilibriumWatch, IsQuietWhereThereIsEquilibrium) {
  EXPECT_EQ(Watched(twoChains(contact(), traction(-pull))).foundAt, 0);
  EXPECT_EQ(Watched(twoChains(laws::makeLaw("Perfect"), traction(pull))).foundAt, 0);
}

// The contact that closes in the end is still open at the looks: what lacks a reaction is not yet lost.
TEST(EquilibriumWatch, WaitsForAContactThatIsStillOpen) {
  EXPECT_EQ(Watched(twoChains(contact(), traction(-pull), 1, 50.0)).foundAt, 0);
}

// The right chain lacks its whole load: an imbalance of 1 relative to the forces on it.
TEST(EquilibriumWatch, IgnoresWhatIsFarBelowTheAccuracy) {
  EXPECT_EQ(Watched(twoChains(contact(), traction(pull)), 5.0).foundAt, 36);
  EXPECT_EQ(Watched(twoChains(contact(), traction(pull)), 20.0).foundAt, 0);
}

// With so small a k the interfaces answer late, and a lack that persists means nothing.
TEST(EquilibriumWatch, DoesNotTrustAVerySmallSearchDirection) {
  EXPECT_EQ(Watched(twoChains(contact(), traction(pull)), accuracy, 1e-3).foundAt, 0);
}

/// What is lacking where a load step has slid to in pseudo-time; none where it does not slide on.
std::optional<Imbalance> lackOf(const assembly::Assembly& assembly, double scale, bool isSure = false) {
  StageOptions options;
  options.searchDirectionScale = scale;
  base::Timers timers;
  FixedPoint fixedPoint(assembly, options, self(), timers);
  StepNewton newton(fixedPoint);
  fixedPoint.select({0});
  base::Matrix alpha(fixedPoint.layout().rows(), 1), image(alpha);
  const base::Matrix beta(fixedPoint.apply(alpha, image).beta());
  const StepNewton::Result result = newton.settle(alpha, beta, 1e-6, {});
  if (!result.slide) return std::nullopt;
  return EquilibriumWatch(accuracy, [isSure](int) { return isSure; }).lackAt(fixedPoint, *result.slide);
}

TEST(EquilibriumWatch, KnowsWhatSlidesOnWithEverySearchDirection) {
  for (const double scale : {1e-4, 1e-2, 1.0, 1e2}) {
    const std::optional<Imbalance> lack = lackOf(twoChains(contact(), traction(pull)), scale);
    ASSERT_TRUE(lack) << scale;
    EXPECT_EQ(lack->body, 1);
    EXPECT_NEAR(lack->force[0], -pull, 1e-3 * pull) << scale;
  }
}

TEST(EquilibriumWatch, LacksNothingWhereSomethingHolds) {
  const Law spring = laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 1e-6}, {"Tangential Stiffness", 1e-6}});
  for (const double scale : {1e-2, 1.0, 1e2}) {
    EXPECT_FALSE(lackOf(twoChains(spring, traction(pull)), scale)) << scale;
    EXPECT_FALSE(lackOf(twoChains(contact(), traction(-pull), 1, 50.0), scale)) << scale;
  }
  EXPECT_FALSE(lackOf(twoChains(contact(), traction(pull)), 1.0, true));
}

}  // namespace
}  // namespace harmos::latin
