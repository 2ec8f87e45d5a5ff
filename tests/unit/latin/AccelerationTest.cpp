#include <cmath>

#include <gtest/gtest.h>

#include <harmos/latin/AndersonAcceleration.hpp>
#include <harmos/latin/NormalEquations.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

/// An affine map alpha_t -> M_t alpha_t + b_t, another one for every load step.
struct AffineMap {
  AffineMap(int rows, int steps, double size) : shift(rows, steps) {
    for (int t = 0; t < steps; ++t) {
      matrices.emplace_back(rows, rows);
      randomize(matrices.back(), static_cast<unsigned>(t) + 10);
      matrices.back().scale(size / matrices.back().normFrobenius());
    }
    randomize(shift, 99);
  }
  base::Matrix operator()(const base::Matrix& alpha) const {
    base::Matrix image(shift);
    for (int t = 0; t < alpha.numCols(); ++t) {
      for (int i = 0; i < alpha.numRows(); ++i) {
        for (int j = 0; j < alpha.numRows(); ++j) image(i, t) += matrices[t](i, j) * alpha(j, t);
      }
    }
    return image;
  }
  double residual(const base::Matrix& alpha) const {
    base::Matrix r = (*this)(alpha);
    r -= alpha;
    return r.normFrobenius();
  }
  std::vector<base::Matrix> matrices;
  base::Matrix shift;
};

class Anderson : public testing::Test {
 protected:
  Anderson()
      : assembly_(twoChains(laws::makeLaw("Perfect"), clamp(), 3)),
        k_(assembly_, 1.0, *self()),
        eliminated_(assembly_, k_, Elimination::none, {}),
        layout_(assembly_, k_, eliminated_, self()),
        metric_(layout_) {}

  assembly::Assembly assembly_;
  assembly::SearchDirection k_;
  EliminatedBoundaries eliminated_;
  TraceLayout layout_;
  StateMetric metric_;
};

TEST_F(Anderson, GoesOnAfterAPauseAsAfterResuming) {
  const int rows = layout_.rows();
  const AffineMap map(rows, 3, 0.9);
  AndersonAcceleration paused(metric_, 6), resumed(metric_, 6);
  base::Matrix one(rows, 3), other(rows, 3);
  for (int i = 0; i < 8; ++i) {
    if (i == 4) paused.pause();
    if (i == 4) resumed.resume();
    paused.advance(one, map(one));
    resumed.advance(other, map(other));
  }
  EXPECT_TRUE(one == other);
}

// n differences span everything: the next iterate is exact, even where the plain iteration is slow.
TEST_F(Anderson, SolvesAffineMapsInAsManyStepsAsRows) {
  const int rows = layout_.rows();
  for (double size : {0.5, 0.999}) {
    const AffineMap map(rows, 3, size);
    AndersonAcceleration acceleration(metric_, rows);
    base::Matrix alpha(rows, 3);
    const double first = map.residual(alpha);
    for (int n = 0; n < rows + 1; ++n) acceleration.advance(alpha, map(alpha));
    // Normal equations square the condition number.
    EXPECT_LT(map.residual(alpha), 1e-6 * first);
  }
}

// Where T throws apart what it maps, residuals grow until the differences span everything.
TEST_F(Anderson, KeepsTheDifferencesOfAnAffineMap) {
  const int rows = layout_.rows();
  const AffineMap map(rows, 1, 5.0);
  for (const bool isAffine : {false, true}) {
    AndersonAcceleration acceleration(metric_, rows, isAffine);
    base::Matrix alpha(rows, 1);
    const double first = map.residual(alpha);
    for (int n = 0; n < rows + 1; ++n) acceleration.advance(alpha, map(alpha));
    EXPECT_EQ(map.residual(alpha) < 1e-6 * first, isAffine) << map.residual(alpha) / first;
  }
}

TEST_F(Anderson, StartsPlain) {
  const AffineMap map(layout_.rows(), 3, 0.5);
  AndersonAcceleration acceleration(metric_, 5);
  base::Matrix alpha(layout_.rows(), 3);
  randomize(alpha);
  for (int round = 0; round < 2; ++round) {
    const base::Matrix image = map(alpha);
    acceleration.advance(alpha, image);
    EXPECT_EQ(alpha, image);
    acceleration.advance(alpha, map(alpha));
    acceleration.restart();
  }
}

TEST_F(Anderson, ForgetsTheOldestAndStillConverges) {
  const AffineMap map(layout_.rows(), 3, 0.9);
  AndersonAcceleration acceleration(metric_, 3);
  base::Matrix alpha(layout_.rows(), 3), plain(layout_.rows(), 3);
  for (int n = 0; n < 20; ++n) {
    acceleration.advance(alpha, map(alpha));
    plain = map(plain);
  }
  EXPECT_LT(map.residual(alpha), map.residual(plain));
}

// A load step that has converged must not disturb the others, nor itself.
TEST_F(Anderson, StaysAtTheFixedPoint) {
  const AffineMap map(layout_.rows(), 3, 0.5);
  base::Matrix fixed(layout_.rows(), 3);
  for (int n = 0; n < 200; ++n) fixed = map(fixed);
  AndersonAcceleration acceleration(metric_, 10);
  base::Matrix alpha(fixed);
  for (int n = 0; n < 20; ++n) acceleration.advance(alpha, map(alpha));
  for (int t = 0; t < 3; ++t) {
    for (int row = 0; row < alpha.numRows(); ++row) EXPECT_NEAR(alpha(row, t), fixed(row, t), 1e-13);
  }
}

// T(alpha) = alpha + b goes on for ever: the residual does not change and its differences are round-off. The iterate
// follows b in steps that double, and no other direction.
TEST_F(Anderson, FollowsAConstantForceEverFaster) {
  base::Matrix step(layout_.rows(), 3), alpha(layout_.rows(), 3);
  randomize(step);
  randomize(alpha, 2);
  const base::Matrix start(alpha);
  AndersonAcceleration acceleration(metric_, 10);
  for (int n = 0; n < 12; ++n) {
    base::Matrix image(alpha);
    image += step;
    acceleration.advance(alpha, image);
  }
  // The first move is plain and the second can be the first to double: 1 + 2 + 4 + .. + 2^11.
  for (int t = 0; t < 3; ++t) {
    for (int row = 0; row < alpha.numRows(); ++row)
      EXPECT_NEAR(alpha(row, t) - start(row, t), 4095.0 * step(row, t), 1e-9);
  }
}

// Beyond a kink T throws back: the iterate is given up for one between the last good one and its image.
TEST_F(Anderson, GoesBackFromAKink) {
  const auto map = [](const base::Matrix& alpha) {
    base::Matrix image(alpha);
    for (int t = 0; t < image.numCols(); ++t) {
      for (int row = 0; row < image.numRows(); ++row)
        image(row, t) = alpha(row, t) < 1.0 ? alpha(row, t) + 0.01 : alpha(row, t) - 10.0 * (alpha(row, t) - 1.0);
    }
    return image;
  };
  AndersonAcceleration acceleration(metric_, 10);
  base::Matrix alpha(layout_.rows(), 3);
  for (int n = 0; n < 60; ++n) {
    acceleration.advance(alpha, map(alpha));
    EXPECT_LT(alpha.normInf(), 5.0);
  }
  EXPECT_NEAR(alpha(0, 0), 1.0, 0.05);
}

base::Matrix gramOf(const base::Matrix& columns) {
  base::Matrix gram(columns.numCols(), columns.numCols());
  gram.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, columns, columns, 0.0);
  return gram;
}

std::vector<double> productsWith(const base::Matrix& columns, const std::vector<double>& b) {
  std::vector<double> result(columns.numCols(), 0.0);
  for (int j = 0; j < columns.numCols(); ++j) {
    for (int i = 0; i < columns.numRows(); ++i) result[j] += columns(i, j) * b[i];
  }
  return result;
}

// More columns and rows than are multiplied at once, and remainders of both.
TEST(GramMatrix, HoldsTheProductsOfAllColumns) {
  for (const int rows : {1, 7, 256, 601}) {
    for (int count = 1; count < 9; ++count) {
      base::Matrix columns(rows, count);
      randomize(columns);
      const base::Matrix gram = gramMatrix(columns), exact = gramOf(columns);
      for (int a = 0; a < count; ++a) {
        for (int b = 0; b < count; ++b) EXPECT_NEAR(gram(a, b), exact(a, b), 1e-14 * rows);
      }
    }
  }
}

TEST(LeastSquares, FindsTheCoefficients) {
  base::Matrix columns(8, 4);
  randomize(columns);
  const std::vector<double> exact{1.0, -2.0, 0.5, 3.0};
  std::vector<double> b(8, 0.0);
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 4; ++j) b[i] += columns(i, j) * exact[j];
  }
  const auto found = solveNormalEquations(gramOf(columns), 4, productsWith(columns, b).data());
  for (std::size_t j = 0; j < 4; ++j) EXPECT_NEAR(found[j], exact[j], 1e-12);
}

TEST(LeastSquares, SurvivesColumnsThatDependOnOthers) {
  base::Matrix columns(8, 5);
  randomize(columns);
  for (int i = 0; i < 8; ++i) {
    columns(i, 3) = 2.0 * columns(i, 0) - columns(i, 1);
    columns(i, 4) = 0.0;
  }
  std::vector<double> b(8);
  for (int i = 0; i < 8; ++i) b[i] = columns(i, 0) + columns(i, 2) + columns(i, 3);
  const auto found = solveNormalEquations(gramOf(columns), 5, productsWith(columns, b).data());
  double error = 0.0;
  for (int i = 0; i < 8; ++i) {
    double residual = b[i];
    for (int j = 0; j < 5; ++j) residual -= columns(i, j) * found[j];
    error = std::max(error, std::abs(residual));
  }
  EXPECT_LT(error, 1e-7);
  EXPECT_EQ(found[4], 0.0);
  EXPECT_TRUE(found[0] == 0.0 || found[1] == 0.0 || found[3] == 0.0);
}

// Differences of a converging iteration shrink by orders of magnitude: the scale of a column must not matter.
TEST(LeastSquares, DoesNotCareForTheLengthOfColumns) {
  base::Matrix columns(8, 3);
  randomize(columns);
  const double lengths[3] = {1e8, 1.0, 1e-12};
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 8; ++i) columns(i, j) *= lengths[j];
  }
  std::vector<double> b(8, 0.0);
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 3; ++j) b[i] += columns(i, j) / lengths[j];
  }
  const auto found = solveNormalEquations(gramOf(columns), 3, productsWith(columns, b).data());
  for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(found[j] * lengths[j], 1.0, 1e-10);
}

TEST(LeastSquares, LeavesOutColumnsBelowTheFloor) {
  base::Matrix gram(2, 2);
  gram(0, 0) = 4.0;
  gram(1, 1) = 1e-20;
  const double right[] = {2.0, 1.0};
  EXPECT_EQ(solveNormalEquations(gram, 2, right, 1e-20), (std::vector<double>{0.5, 0.0}));
}

TEST(LeastSquares, TakesTheLeadingColumnsOnly) {
  base::Matrix gram(3, 3);
  gram(0, 0) = 4.0;
  gram(1, 1) = gram(2, 2) = std::nan("");
  const double right[] = {2.0};
  const auto found = solveNormalEquations(gram, 1, right);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0], 0.5);
}

// Differences that span everything, given beforehand: the first iterate is exact.
TEST_F(Anderson, StartsFromKnownDifferences) {
  const int rows = layout_.rows();
  const AffineMap map(rows, 3, 5.0);
  std::vector<base::Matrix> residuals, images;
  for (const base::Matrix& matrix : map.matrices) {
    residuals.emplace_back(rows, rows);
    images.emplace_back(matrix);
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < rows; ++i) {
        const double identity = i == j ? 1.0 : 0.0;
        residuals.back()(i, j) = metric_.scale()[i] * (matrix(i, j) - identity);
      }
    }
  }
  AndersonAcceleration acceleration(metric_, rows + 5);
  acceleration.seed(residuals, images);
  base::Matrix alpha(rows, 3);
  acceleration.advance(alpha, map(alpha));
  EXPECT_LT(map.residual(alpha), 1e-8 * map.shift.normFrobenius());
}

}  // namespace
}  // namespace harmos::latin
