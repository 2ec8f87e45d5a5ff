#include <harmos/substructure/CrsMatrix.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include <harmos/base/Error.hpp>

#include "Lattice.hpp"

namespace harmos::substructure {
namespace {

TEST(CrsMatrix, keepsTheArrays) {
  const std::vector<std::size_t> pointers{0, 2, 3};
  const std::vector<int> columns{0, 1, 1};
  const std::vector<double> values{4.0, -1.0, 3.0};
  const auto matrix = makeCrsMatrix(pointers, columns, values);
  const CrsView view = viewOf(*matrix, "part");
  EXPECT_EQ(view.rows, 2);
  EXPECT_EQ(std::vector<std::size_t>(view.rowPointers, view.rowPointers + 3), pointers);
  EXPECT_EQ(std::vector<int>(view.columns, view.columns + 3), columns);
  EXPECT_EQ(std::vector<double>(view.values, view.values + 3), values);
}

TEST(CrsMatrix, refusesArraysThatDoNotFit) {
  EXPECT_THROW(makeCrsMatrix({0, 1}, {0, 0}, {1.0, 1.0}), base::Error);
  EXPECT_THROW(makeCrsMatrix({0, 1}, {1}, {1.0}), base::Error);
  EXPECT_THROW(makeCrsMatrix({0, 2, 3}, {1, 0, 1}, {1.0, 1.0, 1.0}), base::Error);
}

TEST(CrsMatrix, TakesRowsOverWhereTheyAreFilled) {
  CrsRows rows({0, 1, 3});
  ASSERT_EQ(rows.rows(), 2U);
  ASSERT_EQ(rows.entries(), 3U);
  const std::vector<int> columns{0, 0, 1};
  const std::vector<double> values{4.0, -1.0, 3.0};
  std::copy(columns.begin(), columns.end(), rows.columns());
  std::copy(values.begin(), values.end(), rows.values());
  const double* place = rows.values();
  const auto matrix = makeCrsMatrix(std::move(rows));
  const CrsView view = viewOf(*matrix, "part");
  EXPECT_EQ(view.values, place);
  EXPECT_EQ(std::vector<int>(view.columns, view.columns + 3), columns);
  EXPECT_THROW(CrsRows({0, 2, 1}), base::Error);
  EXPECT_THROW(CrsRows({1, 2}), base::Error);
}

TEST(CrsMatrix, nodalDiagonalIsTheMeanOverComponents) {
  EXPECT_EQ(nodalStiffnessDiagonal(*makeCrsMatrix({0, 1, 2, 3, 4}, {0, 1, 2, 3}, {1.0, 3.0, 10.0, 20.0}), 2),
            (std::vector<double>{2.0, 15.0}));
  const Lattice lattice{3};
  const std::vector<double> diagonal = nodalStiffnessDiagonal(*lattice.matrix(), 3);
  EXPECT_DOUBLE_EQ(diagonal[0], 3 * 2.0);   // corner: three springs
  EXPECT_DOUBLE_EQ(diagonal[13], 6 * 2.0);  // centre: six
}

// A host's own assembly: entries in any order, summed up by Tpetra.
TEST(CrsMatrix, acceptsMatricesThatTpetraAssembled) {
  using Map = base::CrsMatrix::map_type;
  const Teuchos::RCP<const Teuchos::Comm<int>> self = Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF));
  const auto map = Teuchos::rcp(new Map(4, 0, self));
  base::CrsMatrix matrix(map, 4);
  for (const long long row : {2, 0, 3, 1}) {
    for (const long long column : {3, 1, 0, 2, 1}) {
      const double value = row == column ? 5.0 : 1.0;
      matrix.insertGlobalValues(row, 1, &value, &column);
    }
  }
  EXPECT_THROW(viewOf(matrix, "part"), base::Error);
  matrix.fillComplete();
  const CrsView view = viewOf(matrix, "part");
  EXPECT_EQ(std::vector<int>(view.columns, view.columns + 4), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(view.values[0], 5.0);
  EXPECT_EQ(view.values[1], 2.0);  // inserted twice
}

TEST(CrsMatrix, AddsUpEntriesOfOnePlace) {
  const auto matrix = makeCrsMatrix({{1, 0, 2.0}, {0, 1, 1.0}, {1, 0, 3.0}, {0, 0, 4.0}}, 2);
  const CrsView view = viewOf(*matrix, "part");
  ASSERT_EQ(view.rowPointers[2], 3U);
  EXPECT_EQ(view.values[view.positionOf(0, 0)], 4.0);
  EXPECT_EQ(view.values[view.positionOf(0, 1)], 1.0);
  EXPECT_EQ(view.values[view.positionOf(1, 0)], 5.0);
}

}  // namespace
}  // namespace harmos::substructure
