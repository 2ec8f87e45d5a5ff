#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include <harmos/latin/CausalCorrection.hpp>
#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/March.hpp>
#include <harmos/latin/detail/SelfStresses.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

using Law = std::shared_ptr<const laws::InterfaceLaw>;

Law perfect() {
  return laws::makeLaw("Perfect");
}

Law friction() {
  return laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.5}});
}

/// Four blocks around a line, the lower two held, pushed from above and from one side: one joint by `law`, the others
/// by `others`.
BoxAssembly fourBlocks(const Law& law, const Law& others) {
  const std::array<int, 3> cells{2, 2, 2};
  BoxAssembly blocks({{"a", {0, 0, 0}, {1, 1, 1}, cells},
                      {"b", {1, 0, 0}, {2, 1, 1}, cells},
                      {"c", {0, 0, 1}, {1, 1, 2}, cells},
                      {"d", {1, 0, 1}, {2, 1, 2}, cells}});
  const Law held = laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}});
  blocks.hold("under a", "a_zmin", held);
  blocks.hold("under b", "b_zmin", held);
  blocks.join("ab", "a_xmax", "b_xmin", law);
  blocks.join("ac", "a_zmax", "c_zmin", others);
  blocks.join("bd", "b_zmax", "d_zmin", others);
  blocks.join("cd", "c_xmax", "d_xmin", others);
  blocks.hold("above c", "c_zmax", laws::makeLaw("Prescribed Traction", {{"X", 1.0}, {"Z", -5.0}}));
  blocks.hold("above d", "d_zmax", laws::makeLaw("Prescribed Traction", {{"X", 1.0}, {"Z", -3.0}}));
  return blocks;
}

/// A joint that is hardly less stiff than a perfect one.
Law stiffGlue() {
  return laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 1e6}, {"Tangential Stiffness", 1e6}});
}

struct Solved {
  explicit Solved(BoxAssembly made)
      : blocks(std::move(made)),
        fixedPoint(blocks.assembly(), {}, self(), timers),
        stresses(fixedPoint.selfStresses()),
        alpha(fixedPoint.layout().rows(), 1),
        image(alpha) {}
  void march(double tolerance) {
    March(fixedPoint, 30, tolerance, 0).run(alpha, tolerance, March::Guess::extrapolation);
  }

  base::Timers timers;
  BoxAssembly blocks;
  FixedPoint fixedPoint;
  const SelfStresses& stresses;
  base::Matrix alpha, image;
};

// Rings around the three nodes of the line, and three pairs between nodes that are held: three components each.
TEST(SelfStresses, AreOrthonormalAndComeBackFromTheLinearStage) {
  Solved solved(fourBlocks(stiffGlue(), perfect()));
  ASSERT_EQ(solved.stresses.size(), 18);
  base::Matrix fields(solved.alpha.numRows(), 18);
  for (int i = 0; i < 18; ++i) {
    const std::vector<double> field = solved.stresses.field(i);
    std::copy(field.begin(), field.end(), fields[i]);
  }
  const base::Matrix& all = fields;
  const StateMetric& metric = solved.fixedPoint.metric();
  randomize(solved.alpha);
  base::Matrix beta(solved.alpha), shifted(solved.alpha), betaOfShifted(solved.alpha);
  solved.fixedPoint.solveLinear(solved.alpha, beta);
  for (int i = 0; i < 18; ++i) {
    const base::Matrix s(Teuchos::Copy, all, all.numRows(), 1, 0, i);
    for (int j = 0; j <= i; ++j) {
      const base::Matrix other(Teuchos::Copy, all, all.numRows(), 1, 0, j);
      EXPECT_NEAR(metric.dot(s, other), i == j ? 1.0 : 0.0, 1e-12);
    }
    shifted.assign(solved.alpha);
    shifted += s;
    solved.fixedPoint.solveLinear(shifted, betaOfShifted);
    betaOfShifted -= beta;
    EXPECT_LT(metric.distance(betaOfShifted, s), 1e-10 * metric.norm(beta));
  }
}

TEST(SelfStresses, AreStiffWhereAJointIsNearlyRigid) {
  EXPECT_EQ(Solved(fourBlocks(stiffGlue(), perfect())).stresses.stiff().size(), 18U);
  const Law soft = laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 1e3}, {"Tangential Stiffness", 1e3}});
  EXPECT_TRUE(Solved(fourBlocks(soft, perfect())).stresses.stiff().empty());
  EXPECT_TRUE(Solved(fourBlocks(perfect(), perfect())).stresses.isEmpty());
}

// A self-stress that hardly any law resists does hardly show in the residual: a correction that goes for a tenth of
// that must find it all the same, or what it has hidden would be certified.
TEST(SelfStresses, AreCorrectedThoughTheResidualHardlyTellsThem) {
  Solved solved(fourBlocks(stiffGlue(), friction()));
  solved.march(1e-9);
  const base::Matrix solution(solved.alpha);
  const StateMetric& metric = solved.fixedPoint.metric();
  base::Matrix noise(solution);
  randomize(noise);
  noise *= 1e-3 * metric.norm(solution) / metric.norm(noise);
  solved.alpha += noise;
  const std::vector<double> field = solved.stresses.field(0);
  for (std::size_t row = 0; row < field.size(); ++row)
    solved.alpha(static_cast<int>(row), 0) += 0.01 * metric.norm(solution) * field[row];
  const double before = metric.distance(solved.alpha, solution);
  CausalCorrection correction(solved.fixedPoint);
  const Iterate& iterate = solved.fixedPoint.apply(solved.alpha, solved.image);
  correction.correct(iterate, solved.alpha, solved.image, {0.1}, 100);
  EXPECT_LT(metric.distance(solved.alpha, solution), 0.2 * before);
}

// What sticks, slides and opens around the line agrees with the laws after the image is settled, and bodies have felt
// nothing of that.
TEST(SelfStresses, AreSettledWithoutALinearStage) {
  Solved solved(fourBlocks(friction(), friction()));
  solved.march(1e-4);
  const std::vector<double> field = solved.stresses.field(2);
  const StateMetric& metric = solved.fixedPoint.metric();
  const double size = 0.1 * metric.norm(solved.alpha);
  for (std::size_t row = 0; row < field.size(); ++row) solved.alpha(static_cast<int>(row), 0) += size * field[row];
  const Iterate& iterate = solved.fixedPoint.apply(solved.alpha, solved.image);
  const base::Matrix before(iterate.trace());
  const double residual = metric.distance(solved.image, solved.alpha);
  const int stages = solved.fixedPoint.linearStage().stages();
  for (int i = 0; i < 5; ++i) solved.fixedPoint.settleUnfelt(solved.alpha, solved.image);
  EXPECT_EQ(solved.fixedPoint.linearStage().stages(), stages);
  EXPECT_LT(metric.distance(solved.image, solved.alpha), 0.2 * residual);
  const base::Matrix settled(iterate.trace());
  for (int row = 0; row < before.numRows(); ++row) EXPECT_EQ(settled(row, 0), before(row, 0));
  base::Matrix image(solved.image);
  solved.fixedPoint.apply(solved.alpha, image);
  EXPECT_LT(metric.distance(image, solved.image), 1e-10 * metric.norm(image));
}

}  // namespace
}  // namespace harmos::latin
