#include <cmath>

#include <gtest/gtest.h>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/TangentSpace.hpp>
#include <harmos/latin/detail/SoftMotions.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

using Law = std::shared_ptr<const laws::InterfaceLaw>;

Law springs(double normal, double tangential) {
  return laws::makeLaw("Linear Elastic", {{"Normal Stiffness", normal}, {"Tangential Stiffness", tangential}});
}

/// An assembly with tangents at the state of nothing.
struct Mechanism {
  explicit Mechanism(BoxAssembly made)
      : blocks(std::move(made)),
        fixedPoint(blocks.assembly(), {}, self(), timers),
        lines(blocks.assembly(), fixedPoint.searchDirection(), fixedPoint.layout()),
        tangents(fixedPoint, lines),
        alpha(fixedPoint.layout().rows(), 1),
        image(alpha) {
    fixedPoint.apply(alpha, image);
    base::Matrix traction(alpha);
    const base::Matrix beta(alpha);
    fixedPoint.pointwiseStage().begin();
    fixedPoint.pointwiseStage().solveColumn(0, beta, traction);
    tangents.differentiate(0, fixedPoint.pointwiseStage());
  }

  std::vector<SoftMotions::Motion> find(double limit) {
    return SoftMotions(fixedPoint).find(tangents.tangents(), limit);
  }
  /// |(I - J) v| / |v|, from T of an affine assembly.
  double resistance(const SoftMotions::Motion& motion) {
    const std::vector<double> v = SoftMotions(fixedPoint).state(motion);
    base::Matrix state(alpha), of(alpha), change(alpha);
    std::copy(v.begin(), v.end(), state[0]);
    fixedPoint.apply(alpha, image);
    fixedPoint.apply(state, of);
    for (int row = 0; row < alpha.numRows(); ++row) change(row, 0) = v[row] - (of(row, 0) - image(row, 0));
    return fixedPoint.metric().norm(change) / fixedPoint.metric().norm(state);
  }

  base::Timers timers;
  BoxAssembly blocks;
  FixedPoint fixedPoint;
  InterfaceLines lines;
  TangentSpace tangents;
  base::Matrix alpha, image;
};

const Law load = laws::makeLaw("Prescribed Traction", {{"Z", -1.0}});

/// A block on one that is held below, with a boundary beside it.
BoxAssembly besideABoundary(const Law& joint, const Law& boundary) {
  const std::array<int, 3> cells{2, 2, 2};
  BoxAssembly blocks({{"a", {0, 0, 0}, {1, 1, 1}, cells}, {"b", {0, 0, 1}, {1, 1, 2}, cells}});
  blocks.hold("under", "a_zmin", laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}));
  blocks.hold("beside", "b_xmin", boundary);
  blocks.join("ab", "a_zmax", "b_zmin", joint);
  blocks.hold("above", "b_zmax", load);
  return blocks;
}

// The limit is far above all of them, and bodies do not resist: only springs and round-off do.
TEST(SoftMotions, AreResistedAsTheStagesSay) {
  Mechanism cubes(twoCubes(springs(2.0, 0.5), load));
  const auto motions = cubes.find(0.5);
  ASSERT_EQ(motions.size(), 6U);  // of the upper cube: the lower one is held
  for (std::size_t i = 0; i < motions.size(); ++i) {
    EXPECT_NEAR(cubes.resistance(motions[i]), motions[i].resistance, 1e-6 * motions[i].resistance);
    EXPECT_GE(motions[i].resistance, motions[i == 0 ? 0 : i - 1].resistance);
  }
}

// Springs of stiffness s answer a way with t = s / (1 + 2 s / k) (u - 2 t / k): with one k, the resistance of a
// translation on them is sqrt(8) s / (k + 2 s), of what a joint of two sides makes of the motion of one.
TEST(SoftMotions, AreResistedAsSpringsSay) {
  Mechanism cubes(twoCubes(springs(1e-2, 1e-2), load));
  const auto motions = cubes.find(0.5);
  ASSERT_EQ(motions.size(), 6U);
  double resisted = 0.0, felt = 0.0;
  const assembly::Interface& joint = cubes.blocks.assembly().interfaces[1];
  ASSERT_EQ(joint.sides(), 2);
  for (int p = 0; p < joint.pairs(); ++p) {
    const double k = cubes.fixedPoint.searchDirection().of(1)[p];
    const double answer = 1e-2 / (k + 2e-2);
    resisted += 8.0 * joint.area[p] * k * answer * answer;
    felt += joint.area[p] * k;
  }
  const double translation = std::sqrt(resisted / felt);
  EXPECT_LE(motions.front().resistance, 1.000001 * translation);
  EXPECT_GE(motions.back().resistance, 0.999999 * translation);
}

// Far below what squares of resistances in double precision hold beside those of other motions.
TEST(SoftMotions, AreResistedByAsMuchLessAsSpringsAreSofter) {
  Mechanism cubes(twoCubes(springs(2e-4, 5e-5), load));
  for (const double softer : {1e-3, 1e-6}) {
    SCOPED_TRACE(softer);
    Mechanism soft(twoCubes(springs(2e-4 * softer, 5e-5 * softer), load));
    const auto motions = cubes.find(0.5), softMotions = soft.find(0.5);
    ASSERT_EQ(motions.size(), 6U);
    ASSERT_EQ(softMotions.size(), 6U);
    for (std::size_t i = 0; i < motions.size(); ++i) {
      // Springs of stiffness s answer with s / (1 + 2 s / k).
      EXPECT_NEAR(softMotions[i].resistance, softer * motions[i].resistance, 1e-3 * softMotions[i].resistance);
      EXPECT_TRUE(SoftMotions(soft.fixedPoint).isLeftToLaws(softMotions[i]));
    }
  }
}

// A foundation that is eliminated holds what the springs of the joint leave. Of the body only its rigid motions are
// known, of which k is the stiffness; that it is strained as well changes the resistance by a part.
TEST(SoftMotions, AreResistedByFoundations) {
  Mechanism slider(besideABoundary(
      springs(1e4, 0.0),
      laws::makeLaw("Elastic Foundation", {{"Normal Stiffness", 1e-3}, {"Tangential Stiffness", 2e-3}})));
  const auto motions = slider.find(0.1);
  ASSERT_EQ(motions.size(), 3U);
  for (const auto& motion : motions) {
    EXPECT_NEAR(slider.resistance(motion), motion.resistance, 0.5 * motion.resistance);
    EXPECT_FALSE(SoftMotions(slider.fixedPoint).isLeftToLaws(motion));
  }
}

// What is joined perfectly is one body, also where it is only a piece of it that springs hold.
TEST(SoftMotions, KeepWhatIsJoinedPerfectlyTogether) {
  const std::array<int, 3> cells{1, 1, 1};
  BoxAssembly blocks(
      {{"a", {0, 0, 0}, {1, 1, 1}, cells}, {"b", {0, 0, 1}, {1, 1, 2}, cells}, {"c", {0, 0, 2}, {1, 1, 3}, cells}});
  blocks.hold("under", "a_zmin", laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}));
  blocks.join("ab", "a_zmax", "b_zmin", springs(0.3, 0.1));
  blocks.join("bc", "b_zmax", "c_zmin", laws::makeLaw("Perfect"));
  blocks.hold("above", "c_zmax", load);
  Mechanism pillar(std::move(blocks));
  const auto motions = pillar.find(0.5);
  ASSERT_EQ(motions.size(), 6U);
  for (const auto& motion : motions) {
    EXPECT_NEAR(pillar.resistance(motion), motion.resistance, 1e-6 * motion.resistance);
  }
}

TEST(SoftMotions, LeaveOutWhatIsResistedOrNotAtAll) {
  Mechanism bonded(twoCubes(springs(1e4, 1e4), load));
  EXPECT_TRUE(bonded.find(0.1).empty());
  Mechanism sliding(twoCubes(springs(1e4, 0.0), load));  // three motions are not determined
  EXPECT_TRUE(sliding.find(0.1).empty());
}

// A plane of symmetry leaves the motions within it.
TEST(SoftMotions, AreThoseThatBoundariesLeave) {
  Mechanism half(besideABoundary(springs(0.3, 0.1), laws::makeLaw("Prescribed Displacement", {{"X", 0.0}})));
  const auto motions = half.find(0.5);
  ASSERT_EQ(motions.size(), 3U);
  for (const auto& motion : motions) {
    EXPECT_NEAR(half.resistance(motion), motion.resistance, 1e-6 * motion.resistance);
  }
}

}  // namespace
}  // namespace harmos::latin
