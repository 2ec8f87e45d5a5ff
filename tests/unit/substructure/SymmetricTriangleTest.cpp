#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <harmos/substructure/SymmetricTriangle.hpp>

namespace harmos::substructure {
namespace {

// Around the widths of panels and registers, and with every number of columns that takes another product.
template <class Number>
void expectMultipliesAsASquare(double tolerance) {
  std::mt19937 random(5);
  const auto number = [&] { return random() / 2147483648.0 - 1.0; };
  for (const int rows : {0, 1, 3, 4, 5, 8, 11, 20, 37, 64, 101}) {
    SymmetricTriangle<Number> half(rows);
    base::Matrix square(rows, rows);
    for (int j = 0; j < rows; ++j) {
      // Either triangle may be given.
      for (int i = 0; i <= j; ++i) {
        square(i, j) = square(j, i) = number();
        half.set((i + j) % 2 == 0 ? i : j, (i + j) % 2 == 0 ? j : i, square(i, j));
      }
    }
    for (const int columns : {1, 2, 3, 4, 5, 8, 9, 11, 16, 17, 21, 40}) {
      base::Matrix right(rows, columns), exact(rows, columns), left;
      for (int j = 0; j < columns; ++j) {
        for (int i = 0; i < rows; ++i) right(i, j) = number();
        for (int i = 0; i < rows; ++i) {
          for (int k = 0; k < rows; ++k) exact(i, j) += square(i, k) * right(k, j);
        }
      }
      half.multiply(right, left);
      ASSERT_EQ(left.numRows(), rows);
      ASSERT_EQ(left.numCols(), columns);
      for (int j = 0; j < columns; ++j) {
        for (int i = 0; i < rows; ++i)
          ASSERT_NEAR(left(i, j), exact(i, j), tolerance * std::sqrt(rows)) << rows << " rows";
      }
    }
    EXPECT_LE(half.entries(), static_cast<std::size_t>(rows + 3) * (rows + 7) / 2);
    EXPECT_GE(half.entries(), static_cast<std::size_t>(rows) * (rows + 1) / 2);
  }
}

TEST(SymmetricTriangle, MultipliesAsASquareInHalfOfItsRoom) {
  expectMultipliesAsASquare<float>(2e-6);
  expectMultipliesAsASquare<double>(4e-15);
}

}  // namespace
}  // namespace harmos::substructure
