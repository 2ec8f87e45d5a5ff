#include <harmos/substructure/MirrorPlanes.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <Tpetra_CrsMatrix.hpp>

#include <harmos/substructure/FactorPrediction.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

#include "MirroredLattice.hpp"

namespace harmos::substructure {
namespace {

class MirrorPlanesTest : public testing::Test {
 protected:
  CrsView view() const { return viewOf(*lattice_.matrix, "lattice"); }
  MirrorPlanes planes() const {
    MirrorPlanes planes(lattice_.nodes, 3);
    planes.keepThoseOf(view());
    return planes;
  }
  /// Springs of this stiffness on all rows where a coordinate is so large.
  BoundaryTerm springs(std::size_t axis, double coordinate, double stiffness) const {
    BoundaryTerm term;
    term.diagonal.assign(lattice_.rows(), 0.0);
    for (const int row : lattice_.rowsAt(axis, coordinate)) term.diagonal[row] = stiffness;
    return term;
  }
  SubstructureSolver solver(const BoundaryTerm& term, const std::vector<int>& trace, bool looksForPlanes,
                            bool invertTrace = false) const {
    SolverOptions options;
    options.invertTrace = invertTrace;
    return {lattice_.matrix, term,  options,
            "lattice",       trace, looksForPlanes ? lattice_.nodes : std::vector<base::Vector3>{}};
  }
  static double difference(base::Matrix a, const base::Matrix& b) {
    a -= b;
    return a.normFrobenius() / b.normFrobenius();
  }

  MirroredLattice lattice_{7};
};

TEST_F(MirrorPlanesTest, AreThoseThatLeaveTheMatrixAsItIs) {
  EXPECT_EQ(MirrorPlanes(lattice_.nodes, 3).count(), 2);  // across z the bricks lie unevenly
  EXPECT_EQ(planes().count(), 2);
  EXPECT_EQ(MirrorPlanes(lattice_.rows()).blocks().size(), 1U);
  std::vector<base::Vector3> moved(lattice_.nodes);
  moved.front()[0] += 1e-9;
  EXPECT_LT(MirrorPlanes(moved, 3).count(), 2);
  lattice_.matrix->getLocalMatrixHost().values(1) *= 1.0 + 1e-9;
  EXPECT_LT(planes().count(), 2);
}

TEST_F(MirrorPlanesTest, SeparateWhatIsEvenFromWhatIsOdd) {
  const int rows = lattice_.rows();
  const MirrorPlanes planes = this->planes();
  base::Matrix dense(rows, rows);
  for (int row = 0; row < rows; ++row) {
    for (std::size_t k = view().rowPointers[row]; k < view().rowPointers[row + 1]; ++k)
      dense(row, view().columns[k]) = view().values[k];
  }
  base::Matrix changed(dense);
  planes.change(changed);
  base::Matrix again(changed);
  planes.change(again);
  EXPECT_LT(difference(again, dense), 1e-15);
  changed = base::Matrix(changed, Teuchos::TRANS);
  planes.change(changed);
  const std::vector<std::vector<int>> blocks = planes.blocks();
  ASSERT_EQ(blocks.size(), 4U);
  std::size_t sum = 0;
  for (const std::vector<int>& block : blocks) {
    sum += block.size();
    const auto part = planes.blockOf(view(), block);
    const CrsView partView = viewOf(*part, "block");
    ASSERT_EQ(partView.rows, static_cast<int>(block.size()));
    // What is left of the rows is what the block has no entry for, in the block and beside it.
    for (int i = 0; i < partView.rows; ++i) {
      for (std::size_t k = partView.rowPointers[i]; k < partView.rowPointers[i + 1]; ++k)
        changed(block[i], block[partView.columns[k]]) -= partView.values[k];
    }
  }
  EXPECT_EQ(sum, static_cast<std::size_t>(rows));
  EXPECT_LT(changed.normFrobenius(), 1e-14 * dense.normFrobenius());
}

// Solvers read one triangle. Where it does without forces on rigid motions to the last digits, soft springs may hold
// it.
TEST_F(MirrorPlanesTest, LeaveRigidMotionsRigid) {
  const MirroredLattice uneven(7, 2e-13);
  const CrsView matrix = viewOf(*uneven.matrix, "lattice");
  MirrorPlanes planes(uneven.nodes, 3);
  planes.keepThoseOf(matrix);
  ASSERT_EQ(planes.count(), 2);
  base::Matrix motions(uneven.rows(), 3);
  for (int row = 0; row < uneven.rows(); ++row) motions(row, row % 3) = 1.0;
  planes.change(motions);
  double largest = 0.0, force = 0.0;
  for (const std::vector<int>& block : planes.blocks()) {
    const auto part = planes.blockOf(matrix, block);
    const CrsView view = viewOf(*part, "block");
    base::Matrix forces(view.rows, 3);
    for (int i = 0; i < view.rows; ++i) {
      for (std::size_t k = view.rowPointers[i]; k < view.rowPointers[i + 1] && view.columns[k] <= i; ++k) {
        const int column = view.columns[k];
        largest = std::max(largest, std::abs(view.values[k]));
        for (int c = 0; c < 3; ++c) {
          forces(i, c) += view.values[k] * motions(block[column], c);
          if (column < i) forces(column, c) += view.values[k] * motions(block[i], c);
        }
      }
    }
    force = std::max(force, forces.normInf());
  }
  EXPECT_LT(force, 3e-15 * largest);
}

TEST_F(MirrorPlanesTest, GiveTheSolutionsOfTheWhole) {
  // Also where springs hold the part that are far softer than it: translations are then as large.
  for (const double stiffness : {1.0, 1e-8}) {
    const BoundaryTerm term = springs(2, 2.0, stiffness);
    const SubstructureSolver blocks = solver(term, {}, true), whole = solver(term, {}, false);
    EXPECT_EQ(blocks.mirrorPlanes(), 2);
    EXPECT_EQ(whole.mirrorPlanes(), 0);
    EXPECT_LT(blocks.factorNonzeros(), whole.factorNonzeros());
    for (const int columns : {1, 5}) {
      const base::Matrix b = lattice_.numbers(lattice_.rows(), columns);
      base::Matrix exact, found;
      whole.solve(b, exact);
      blocks.solve(b, found);
      EXPECT_LT(difference(found, exact), 1e-13 / stiffness);
    }
  }
}

TEST_F(MirrorPlanesTest, ArePredicted) {
  const BoundaryTerm term = springs(2, 2.0, 1.0);
  SolverOptions options("tacho");
  const SubstructureSolver blocks(lattice_.matrix, term, options, "lattice", {}, lattice_.nodes);
  const FactorSize size = predictFactor(*lattice_.matrix, term, {}, lattice_.nodes);
  EXPECT_EQ(size.blocks, 4);
  EXPECT_EQ(size.nonzeros, static_cast<double>(blocks.factorNonzeros()));
}

TEST_F(MirrorPlanesTest, AreNotThoseOfAPartThatIsHeldOtherwise) {
  EXPECT_EQ(solver(springs(0, 0.0, 1.0), {}, true).mirrorPlanes(), 1);
  BoundaryTerm unevenly = springs(2, 2.0, 1.0);
  for (const int row : lattice_.rowsAt(0, 0.0)) {
    if (unevenly.diagonal[row] == 0.0) unevenly.diagonal[row] = 1e-13;
  }
  EXPECT_EQ(solver(unevenly, {}, true).mirrorPlanes(), 1) << "however soft the springs are";
  EXPECT_EQ(solver(springs(1, 0.0, 1.0), {}, true).mirrorPlanes(), 1);
  BoundaryTerm held;
  for (const int row : lattice_.rowsAt(0, 0.0)) {
    if (row % 3 == 0) held.free.push_back({row / 3, base::Tensor3{}});
  }
  EXPECT_EQ(solver(held, {}, true).mirrorPlanes(), 1);
  // The trace must be its own mirror image, too.
  EXPECT_EQ(solver(springs(2, 2.0, 1.0), lattice_.rowsAt(0, 0.0), true).mirrorPlanes(), 1);
}

TEST_F(MirrorPlanesTest, CutTraces) {
  if (availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD has traces";
  const std::vector<int> trace = lattice_.rowsAt(2, 2.0);
  const BoundaryTerm term = springs(2, 2.0, 1.0);
  for (const bool invertTrace : {false, true}) {
    SubstructureSolver blocks = solver(term, trace, true, invertTrace), whole = solver(term, trace, false, invertTrace);
    ASSERT_TRUE(blocks.solvesTrace());
    ASSERT_TRUE(whole.solvesTrace());
    EXPECT_LT(3 * blocks.entriesMet(), whole.entriesMet());
    EXPECT_EQ(blocks.prepareSingle() > 0.0, invertTrace);
    EXPECT_LT(blocks.singleError(), 1e-6);
    for (const int columns : {1, 5}) {
      const base::Matrix b = lattice_.numbers(static_cast<int>(trace.size()), columns);
      base::Matrix exact, found, rough;
      whole.solveTrace(b, exact);
      blocks.solveTrace(b, found);
      blocks.solveTrace(b, rough, Precision::single);
      EXPECT_LT(difference(found, exact), 1e-13);
      EXPECT_LT(difference(rough, exact), 1e-6);
    }
  }
}

TEST_F(MirrorPlanesTest, LeaveRightHandSidesThatAreViews) {
  const SubstructureSolver blocks = solver(springs(2, 2.0, 1.0), {}, true);
  ASSERT_GT(blocks.mirrorPlanes(), 0);
  const base::Matrix b = lattice_.numbers(lattice_.rows(), 3), before(Teuchos::Copy, b, b.numRows(), b.numCols());
  base::Matrix x, ofView;
  blocks.solve(b, x);
  blocks.solve(base::Matrix(Teuchos::View, b, b.numRows(), 3), ofView);
  EXPECT_EQ(b, before);
  EXPECT_EQ(ofView, x);
}

TEST_F(MirrorPlanesTest, CutTracesInSinglePrecision) {
  if (availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD gives its factor";
  std::vector<int> trace;  // too large to be kept dense: all rows but those of the uppermost nodes
  const std::vector<int> upper = lattice_.rowsAt(2, lattice_.nodes.back()[2]);
  for (int row = 0; row < lattice_.rows(); ++row) {
    if (!std::binary_search(upper.begin(), upper.end(), row)) trace.push_back(row);
  }
  for (const bool looksForPlanes : {false, true}) {
    SubstructureSolver solver = this->solver(springs(2, 2.0, 1.0), trace, looksForPlanes);
    EXPECT_EQ(solver.mirrorPlanes(), looksForPlanes ? 2 : 0);
    ASSERT_FALSE(solver.solvesTrace());
    EXPECT_FALSE(solver.solvesTraceInSingle());
    EXPECT_TRUE(solver.singleFactors().empty());
    EXPECT_GT(solver.prepareSingle(), 0.0);
    ASSERT_TRUE(solver.solvesTraceInSingle());
    for (const int columns : {1, 5}) {
      const base::Matrix b = lattice_.numbers(static_cast<int>(trace.size()), columns);
      base::Matrix all(lattice_.rows(), columns), solution, exact(b), found, joined;
      for (int j = 0; j < columns; ++j) {
        for (std::size_t i = 0; i < trace.size(); ++i) all(trace[i], j) = b(static_cast<int>(i), j);
      }
      solver.solve(all, solution);
      for (int j = 0; j < columns; ++j) {
        for (std::size_t i = 0; i < trace.size(); ++i) exact(static_cast<int>(i), j) = solution(trace[i], j);
      }
      solver.solveTrace(b, found, Precision::single);
      EXPECT_LT(difference(found, exact), 1e-5);
      EXPECT_GT(difference(found, exact), 0.0);
      std::vector<base::Matrix> parts = solver.split(b);
      const auto factors = solver.singleFactors();
      ASSERT_EQ(parts.size(), factors.size());
      for (std::size_t i = 0; i < parts.size(); ++i) {
        ASSERT_EQ(parts[i].numRows(), factors[i]->traceRows());
        base::Matrix part(parts[i]);
        factors[i]->solveTrace(parts[i], part);
        parts[i].assign(part);
      }
      solver.join(parts, joined);
      EXPECT_EQ(joined, found);
    }
  }
}

}  // namespace
}  // namespace harmos::substructure
