// The same matrix given by 1, 2 and 4 ranks in shares.
#include <cmath>

#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/substructure/CrsMatrix.hpp>
#include <harmos/substructure/DistributedSolver.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

namespace harmos::substructure {
namespace {

constexpr int side = 12;  // points along an edge of a grid

/// Springs between neighbours of a grid, of which this rank gives every so many, and `ground` to the first point.
SymmetricEntries springs(double ground, int rank, int ranks) {
  SymmetricEntries entries;
  const auto add = [&](int row, int column, double value) {
    entries.rows.push_back(row);
    entries.columns.push_back(column);
    entries.values.push_back(value);
  };
  int count = 0;
  const auto join = [&](int first, int second) {
    if (count++ % ranks != rank) return;
    const double stiffness = 1.0 + count % 5;
    add(first, first, stiffness);
    add(second, second, stiffness);
    add(second, first, -stiffness);
  };
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      if (i + 1 < side) join(side * i + j, side * (i + 1) + j);
      if (j + 1 < side) join(side * i + j, side * i + j + 1);
    }
  }
  if (rank == 0) add(0, 0, ground);
  return entries;
}

class Distributed : public testing::Test {
 protected:
  void SetUp() override {
    if (!DistributedSolver::exists()) GTEST_SKIP() << "built without MUMPS";
  }
  Teuchos::RCP<const Teuchos::Comm<int>> comm_ = Tpetra::getDefaultComm();
  int rank_ = comm_->getRank();
  int ranks_ = comm_->getSize();
};

TEST_F(Distributed, SolvesAsOneRankAlone) {
  constexpr int rows = side * side, columns = 3;
  const SymmetricEntries all = springs(2.0, 0, 1);
  base::Matrix dense(rows, rows);
  for (std::size_t k = 0; k < all.values.size(); ++k) {
    dense(all.rows[k], all.columns[k]) += all.values[k];
    if (all.rows[k] != all.columns[k]) dense(all.columns[k], all.rows[k]) += all.values[k];
  }
  std::vector<std::size_t> pointers{0};
  std::vector<int> numbers;
  std::vector<double> values;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) {
      if (dense(i, j) == 0.0) continue;
      numbers.push_back(j);
      values.push_back(dense(i, j));
    }
    pointers.push_back(numbers.size());
  }
  const SubstructureSolver alone(makeCrsMatrix(pointers, numbers, values), {}, SolverOptions(), "grid");
  const DistributedSolver together(rows, springs(2.0, rank_, ranks_), comm_);
  base::Matrix b(rows, columns), expected, found;
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) b(i, j) = std::sin(1.0 + i + 7.0 * j);
  }
  alone.solve(b, expected);
  together.solve(b, found);
  ASSERT_EQ(found.numRows(), rows);
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) EXPECT_NEAR(found(i, j), expected(i, j), 1e-12 * expected.normInf());
  }
}

TEST_F(Distributed, RefusesWhatIsNotPositiveDefiniteOnAllRanks) {
  for (const double ground : {0.0, -1.0}) {
    EXPECT_THROW(DistributedSolver(side * side, springs(ground, rank_, ranks_), comm_),
                 DistributedSolver::NotPositiveDefinite);
  }
}

}  // namespace
}  // namespace harmos::substructure
