#include <harmos/substructure/IterativeSolver.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/substructure/MultigridLibrary.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

#include "Lattice.hpp"

namespace harmos::substructure {
namespace {

class Iterating : public testing::Test {
 protected:
  void SetUp() override {
    if (!hasMultigrid()) GTEST_SKIP() << "built without MueLu";
  }

  static std::vector<base::Vector3> placesOf(const Lattice& lattice) {
    std::vector<base::Vector3> places;
    for (int node = 0; node < lattice.nodes(); ++node) {
      const int row = node / lattice.n % lattice.n, layer = node / (lattice.n * lattice.n);
      places.push_back({static_cast<double>(node % lattice.n), static_cast<double>(row), static_cast<double>(layer)});
    }
    return places;
  }

  static BoundaryTerm onOneFace(const Lattice& lattice, double value) {
    BoundaryTerm boundary;
    boundary.dimension = lattice.dimension;
    boundary.diagonal.assign(lattice.dofs(), 0.0);
    for (int dof = 0; dof < lattice.dimension * lattice.n * lattice.n; ++dof) boundary.diagonal[dof] = value;
    return boundary;
  }

  static base::Matrix loads(int rows, int columns) {
    base::Matrix b(rows, columns);
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < rows; ++i) b(i, j) = std::sin(1.0 + i + 7.0 * j);
    }
    return b;
  }

  /// sqrt of d.b(d) / x.b with d = x - y and b(d) the forces of d: the energy error of x where y is exact.
  static double energyError(const SubstructureSolver& iterating, const base::Matrix& b, const base::Matrix& x,
                            const base::Matrix& exact) {
    const base::Matrix left = iterating.residual(b, x);
    double largest = 0.0;
    for (int j = 0; j < b.numCols(); ++j) {
      double error = 0.0, energy = 0.0;
      for (int row = 0; row < b.numRows(); ++row) {
        error += (exact(row, j) - x(row, j)) * left(row, j);
        energy += exact(row, j) * b(row, j);
      }
      largest = std::max(largest, std::sqrt(std::abs(error) / energy));
    }
    return largest;
  }

  Lattice lattice_{9};
};

// Columns of any size, one without forces.
TEST_F(Iterating, KeepsToItsToleranceInEveryColumn) {
  const BoundaryTerm boundary = onOneFace(lattice_, 0.3);
  base::Matrix b = loads(lattice_.dofs(), 11), exact, x;
  for (int row = 0; row < b.numRows(); ++row) {
    b(row, 3) = 0.0;
    b(row, 4) *= 1e-12;
    b(row, 5) *= 1e12;
  }
  SubstructureSolver(lattice_.matrix(), boundary, {}, "part").solve(b, exact);
  for (const double tolerance : {1e-4, 1e-8, 1e-11}) {
    SolverOptions options;
    options.iterationTolerance = tolerance;
    const auto solver = SubstructureSolver::iterating(lattice_.matrix(), boundary, options, "part", placesOf(lattice_));
    EXPECT_TRUE(solver.iterates());
    EXPECT_FALSE(solver.solvesTrace());
    EXPECT_EQ(solver.factorNonzeros(), 0u);
    x = base::Matrix();
    solver.solve(b, x);
    for (int row = 0; row < b.numRows(); ++row) ASSERT_EQ(x(row, 3), 0.0);
    for (const int j : {0, 4, 5, 10}) {
      const base::Matrix one(Teuchos::View, b, b.numRows(), 1, 0, j), its(Teuchos::View, x, b.numRows(), 1, 0, j),
          right(Teuchos::View, exact, b.numRows(), 1, 0, j);
      EXPECT_LT(energyError(solver, one, its, right), tolerance) << j;
    }
  }
}

TEST_F(Iterating, GainsByAGuessAndSurvivesABadOne) {
  const BoundaryTerm boundary = onOneFace(lattice_, 0.3);
  const Teuchos::RCP<base::CrsMatrix> sum = lattice_.matrix();
  {
    const CrsView view = viewOf(*sum, "part");
    const auto local = sum->getLocalMatrixHost();
    for (int row = 0; row < view.rows; ++row) local.values(view.positionOf(row, row)) += boundary.diagonal[row];
  }
  const auto translations = Teuchos::rcp(new base::MultiVector(sum->getRowMap(), 3));
  for (int row = 0; row < lattice_.dofs(); ++row) translations->replaceLocalValue(row, row % 3, 1.0);
  const IterativeSolver solver(sum, translations, 3, 1e-8);
  const base::Matrix b = loads(lattice_.dofs(), 1);
  base::Matrix x(lattice_.dofs(), 1);
  solver.solve(b, x);
  const long fromZero = solver.iterations();
  EXPECT_GT(fromZero, 3);
  const base::Matrix exact(x);
  x.scale(1.0 + 1e-5);
  solver.solve(b, x);
  EXPECT_LT(solver.iterations() - fromZero, fromZero / 2 + 1);
  for (const double wrong : {1e9, std::numeric_limits<double>::quiet_NaN()}) {
    x.putScalar(wrong);
    solver.solve(b, x);
    for (int row = 0; row < lattice_.dofs(); ++row) ASSERT_NEAR(x(row, 0), exact(row, 0), 1e-5 * exact.normInf());
  }
}

TEST_F(Iterating, KnowsWhatItHasLeft) {
  const BoundaryTerm boundary = onOneFace(lattice_, 0.3);
  SolverOptions options;
  options.iterationTolerance = 1e-4;
  const auto solver = SubstructureSolver::iterating(lattice_.matrix(), boundary, options, "part", placesOf(lattice_));
  const base::Matrix b = loads(lattice_.dofs(), 2);
  base::Matrix x, again;
  solver.solve(b, x);
  const base::Matrix left = solver.residual(b, x);
  EXPECT_GT(left.normInf(), 1e-9 * b.normInf());
  // x solves for b without what is left.
  base::Matrix without(b);
  without -= left;
  SubstructureSolver(lattice_.matrix(), boundary, {}, "part").solve(without, again);
  again -= x;
  EXPECT_LT(again.normInf(), 1e-11 * x.normInf());
}

TEST_F(Iterating, RefusesWhatNothingHolds) {
  try {
    SubstructureSolver::iterating(lattice_.matrix(), onOneFace(lattice_, 0.0), {}, "left flange", placesOf(lattice_));
    FAIL();
  } catch (const base::Error& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("part \"left flange\""), std::string::npos) << said;
  }
}

TEST(Multigrid, SaysWhatIsMissing) {
  const char* const before = std::getenv("HARMOS_MULTIGRID");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("HARMOS_MULTIGRID", "no/such/multigrid.so", 1);
  EXPECT_FALSE(hasMultigrid());
  try {
    multigridLibrary();
    ADD_FAILURE();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    const std::string said = error.what();
    EXPECT_NE(said.find("no/such/multigrid.so"), std::string::npos) << said;
    EXPECT_NE(said.find("libtrilinos-muelu-dev"), std::string::npos) << said;
  }
  if (before != nullptr) {
    ::setenv("HARMOS_MULTIGRID", kept.c_str(), 1);
  } else {
    ::unsetenv("HARMOS_MULTIGRID");
  }
}

}  // namespace
}  // namespace harmos::substructure
