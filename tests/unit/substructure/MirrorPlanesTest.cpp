#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>
#include <Teuchos_LAPACK.hpp>

#include <harmos/substructure/TraceInverse.hpp>

namespace harmos::substructure {
namespace {

/// The corners of uneven bricks that lie evenly about x = 1, y = 2 and z = 3, in an order as if by chance, and a
/// symmetric matrix that its mirror images in planes across x and y leave as it is.
class MirrorPlanesTest : public testing::Test {
 protected:
  MirrorPlanesTest() {
    for (const double x : {-1.0, -0.3, 0.3, 1.0}) {
      for (const double y : {-2.0, 0.0, 2.0}) {
        for (const double z : {-1.0, 1.0}) {
          for (int c = 0; c < 3; ++c) rows_.push_back({{1.0 + x, 2.0 + y, 3.0 + z}, c});
        }
      }
    }
    std::shuffle(rows_.begin(), rows_.end(), random_);
    const int count = static_cast<int>(rows_.size());
    base::Matrix any(count, count);
    for (int j = 0; j < count; ++j) {
      for (int i = 0; i <= j; ++i) any(i, j) = any(j, i) = number();
    }
    matrix_.shape(count, count);
    for (int j = 0; j < count; ++j) {
      for (int i = 0; i < count; ++i) {
        for (const auto& mirrored : {0, 1, 2, 3}) {
          const auto [row, rowSign] = image(i, mirrored);
          const auto [column, columnSign] = image(j, mirrored);
          matrix_(i, j) += 0.25 * rowSign * columnSign * any(row, column);
        }
      }
      matrix_(j, j) += count;
    }
  }

  double number() { return random_() / 2147483648.0 - 1.0; }

  /// Across x (bit 1) and y (bit 2): the row on which one falls, and its sign.
  std::pair<int, double> image(int row, int mirrored) const {
    MirrorPlanes::Row to = rows_[row];
    double sign = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
      if ((mirrored >> axis & 1) == 0) continue;
      to.position[axis] = 2.0 * (1.0 + axis) - to.position[axis];
      if (to.component == axis) sign = -sign;
    }
    const auto at = std::find_if(rows_.begin(), rows_.end(), [&](const MirrorPlanes::Row& other) {
      return other.component == to.component && base::distance(other.position, to.position) < 1e-12;
    });
    return {static_cast<int>(at - rows_.begin()), sign};
  }

  base::Matrix transposed(const base::Matrix& matrix) const { return {matrix, Teuchos::TRANS}; }

  std::mt19937 random_{7};
  std::vector<MirrorPlanes::Row> rows_;
  base::Matrix matrix_;
};

TEST_F(MirrorPlanesTest, AreThoseThatLeaveTheMatrixAsItIs) {
  EXPECT_EQ(MirrorPlanes(rows_, matrix_).count(), 2);
  EXPECT_EQ(MirrorPlanes({}, matrix_).count(), 0);
  EXPECT_EQ(MirrorPlanes({}, matrix_).blocks().size(), 1U);
  base::Matrix other(matrix_);
  other(0, 1) = other(1, 0) = other(0, 1) + 1e-6;
  EXPECT_LT(MirrorPlanes(rows_, other).count(), 2);
  std::vector<MirrorPlanes::Row> moved(rows_);
  moved.front().position[0] += 1e-6;
  EXPECT_LT(MirrorPlanes(moved, matrix_).count(), 2);
}

TEST_F(MirrorPlanesTest, SeparateWhatIsEvenFromWhatIsOdd) {
  const MirrorPlanes planes(rows_, matrix_);
  base::Matrix changed(matrix_);
  planes.change(changed);
  base::Matrix again(changed);
  planes.change(again);
  again -= matrix_;
  EXPECT_LT(again.normInf(), 1e-12);
  changed = transposed(changed);
  planes.change(changed);
  const std::vector<std::vector<int>> blocks = planes.blocks();
  ASSERT_EQ(blocks.size(), 4U);
  std::vector<std::size_t> block(rows_.size(), blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (const int row : blocks[b]) block[row] = b;
  }
  EXPECT_EQ(std::count(block.begin(), block.end(), blocks.size()), 0);
  for (int j = 0; j < changed.numCols(); ++j) {
    for (int i = 0; i < changed.numRows(); ++i) {
      if (block[i] == block[j]) continue;
      ASSERT_NEAR(changed(i, j), 0.0, 1e-12);
    }
  }
}

TEST_F(MirrorPlanesTest, LeaveTheInverseOfATraceAsItIsInHalfOfItsRoom) {
  const int count = matrix_.numRows();
  TraceFactor factor{std::vector<int>(rows_.size()), LowerTriangle(count)};
  std::iota(factor.order.begin(), factor.order.end(), 0);
  std::shuffle(factor.order.begin(), factor.order.end(), random_);
  base::Matrix permuted(count, count);
  for (int j = 0; j < count; ++j) {
    for (int i = 0; i < count; ++i) permuted(i, j) = matrix_(factor.order[i], factor.order[j]);
  }
  int info = 0;
  Teuchos::LAPACK<int, double>().POTRF('L', count, permuted.values(), permuted.stride(), &info);
  ASSERT_EQ(info, 0);
  for (int j = 0; j < count; ++j) {
    for (int i = j; i < count; ++i) factor.lower(i, j) = permuted(i, j);
  }
  const TraceInverse whole(factor), blocks(factor, rows_);
  EXPECT_LT(2 * blocks.entries(), whole.entries());
  for (const int columns : {1, 5}) {
    base::Matrix b(count, columns), exact, found, rough;
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < count; ++i) b(i, j) = number();
    }
    whole.solve(b, exact);
    blocks.solve(b, found);
    blocks.solveRoughly(b, rough);
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < count; ++i) {
        double product = 0.0;
        for (int k = 0; k < count; ++k) product += matrix_(i, k) * found(k, j);
        ASSERT_NEAR(product, b(i, j), 1e-12);
        ASSERT_NEAR(found(i, j), exact(i, j), 1e-14);
        ASSERT_NEAR(rough(i, j), exact(i, j), 1e-7);
      }
    }
  }
}

}  // namespace
}  // namespace harmos::substructure
