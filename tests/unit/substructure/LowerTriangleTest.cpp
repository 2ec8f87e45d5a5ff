#include <random>

#include <gtest/gtest.h>

#include <harmos/substructure/LowerTriangle.hpp>

namespace harmos::substructure {
namespace {

// Around the widths of panels, with one column and with several, which take other routines of BLAS.
TEST(LowerTriangle, SolvesAsASquareInHalfOfItsRoom) {
  std::mt19937 random(3);
  const auto number = [&] { return random() / 2147483648.0 - 1.0; };
  for (const int rows : {0, 1, 7, LowerTriangle::width - 1, LowerTriangle::width, LowerTriangle::width + 1,
                         2 * LowerTriangle::width, 3 * LowerTriangle::width + 5}) {
    LowerTriangle lower(rows);
    base::Matrix square(rows, rows);
    for (int j = 0; j < rows; ++j) {
      for (int i = j; i < rows; ++i) square(i, j) = lower(i, j) = i == j ? 4.0 + number() : number() / rows;
    }
    for (const int columns : {1, 3}) {
      base::Matrix exact(rows, columns), right(rows, columns), transposed(rows, columns);
      for (int j = 0; j < columns; ++j) {
        for (int i = 0; i < rows; ++i) exact(i, j) = number();
        for (int i = 0; i < rows; ++i) {
          for (int k = 0; k < rows; ++k) {
            right(i, j) += square(i, k) * exact(k, j);
            transposed(i, j) += square(k, i) * exact(k, j);
          }
        }
      }
      lower.solve(right);
      lower.solveTransposed(transposed);
      for (int j = 0; j < columns; ++j) {
        for (int i = 0; i < rows; ++i) {
          ASSERT_NEAR(right(i, j), exact(i, j), 1e-14) << rows << " rows";
          ASSERT_NEAR(transposed(i, j), exact(i, j), 1e-14) << rows << " rows";
        }
      }
    }
    EXPECT_LE(lower.entries(), static_cast<std::size_t>(rows) * (rows + LowerTriangle::width) / 2);
    EXPECT_GE(lower.entries(), static_cast<std::size_t>(rows) * (rows + 1) / 2);
  }
}

}  // namespace
}  // namespace harmos::substructure
