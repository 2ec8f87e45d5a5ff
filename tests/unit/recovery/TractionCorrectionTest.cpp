#include <cmath>

#include <gtest/gtest.h>

#include <harmos/recovery/TractionCorrection.hpp>

namespace harmos::recovery {
namespace {

constexpr int component[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};

base::Vector3 tractionOf(const base::Matrix& stress, int node, int column, const base::Vector3& n) {
  const int columns = stress.numRows() / 6;
  base::Vector3 t{};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) t[i] += stress(columns * component[i][k] + column, node) * n[k];
  }
  return t;
}

base::Matrix someStress(int nodes, int columns) {
  base::Matrix stress(6 * columns, nodes);
  for (int node = 0; node < nodes; ++node) {
    for (int row = 0; row < stress.numRows(); ++row) stress(row, node) = std::sin(3.0 * row + 7.0 * node);
  }
  return stress;
}

TEST(TractionCorrection, MeetsTheTractionOfAFaceInAllColumns) {
  const base::Vector3 n{0.6, 0.0, 0.8};
  KnownFace face{{0}, n, {{1.0, 2.0, 3.0}, {0.0, 0.0, 0.0}}};
  base::Matrix stress = someStress(2, 2);
  const base::Matrix before(stress);
  correctTractions({face}, {false, false}, 3, stress);
  EXPECT_LT(base::distance(tractionOf(stress, 0, 0, n), {1.0, 2.0, 3.0}), 1e-12);
  EXPECT_LT(base::norm(tractionOf(stress, 0, 1, n)), 1e-12);
  for (int row = 0; row < 12; ++row) EXPECT_EQ(stress(row, 1), before(row, 1));  // the other node
}

// The smallest change of a stress tensor that makes sigma n = 0 takes t n + n t - (t.n) n n away.
TEST(TractionCorrection, IsTheSmallestChange) {
  const base::Vector3 n{0.0, 0.6, 0.8};
  base::Matrix stress = someStress(1, 1);
  const base::Matrix before(stress);
  const base::Vector3 t = tractionOf(stress, 0, 0, n);
  correctTractions({{{0}, n, {}}}, {false}, 3, stress);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const double taken = t[i] * n[k] + n[i] * t[k] - base::dot(t, n) * n[i] * n[k];
      EXPECT_NEAR(stress(component[i][k], 0), before(component[i][k], 0) - taken, 1e-12);
    }
  }
}

TEST(TractionCorrection, OfTwoFacesAtAnEdgeMeetsBoth) {
  const base::Vector3 a{1.0, 0.0, 0.0}, b{0.0, 0.0, 1.0};
  base::Matrix stress = someStress(1, 1);
  correctTractions({{{0}, a, {{2.0, 0.0, 0.5}}}, {{0}, b, {{0.5, 1.0, 0.0}}}}, {false}, 3, stress);
  EXPECT_LT(base::distance(tractionOf(stress, 0, 0, a), {2.0, 0.0, 0.5}), 1e-12);
  EXPECT_LT(base::distance(tractionOf(stress, 0, 0, b), {0.5, 1.0, 0.0}), 1e-12);
}

// At the rim of a load nobody knows the traction; where a force acts at a point, neither.
TEST(TractionCorrection, AsksNothingWhereTractionsJump) {
  const base::Vector3 n{0.0, 1.0, 0.0};
  base::Matrix stress = someStress(2, 1);
  const base::Matrix before(stress);
  correctTractions({{{0}, n, {{0.0, -1.0, 0.0}}}, {{0}, n, {}}, {{1}, n, {}}}, {false, true}, 3, stress);
  EXPECT_TRUE(stress == before);
}

TEST(TractionCorrection, InThePlaneLeavesTheRestAlone) {
  const base::Vector3 n{0.0, 1.0, 0.0};
  base::Matrix stress = someStress(1, 1);
  const double zz = stress(2, 0);
  correctTractions({{{0}, n, {}}}, {false}, 2, stress);
  EXPECT_NEAR(stress(1, 0), 0.0, 1e-14);
  EXPECT_NEAR(stress(3, 0), 0.0, 1e-14);
  EXPECT_EQ(stress(2, 0), zz);
}

}  // namespace
}  // namespace harmos::recovery
