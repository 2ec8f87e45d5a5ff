#include <harmos/substructure/SubstructureSolver.hpp>

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/substructure/FactorPrediction.hpp>

#include "Lattice.hpp"

namespace harmos::substructure {
namespace {

BoundaryTerm onOneFace(const Lattice& lattice, double value) {
  BoundaryTerm boundary;
  boundary.dimension = lattice.dimension;
  boundary.diagonal.assign(lattice.dofs(), 0.0);
  for (int dof = 0; dof < lattice.dimension * lattice.n * lattice.n; ++dof) {
    boundary.diagonal[dof] = value;
  }
  return boundary;
}

base::Matrix loads(int rows, int columns) {
  base::Matrix b(rows, columns);
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) b(i, j) = std::sin(1.0 + i + 7.0 * j);
  }
  return b;
}

/// max |b - (K + boundary) x| / max |b|
double residual(const base::CrsMatrix& stiffness, const BoundaryTerm& boundary, const base::Matrix& b,
                const base::Matrix& x) {
  const CrsView view = viewOf(stiffness, "part");
  base::Matrix r = b;
  for (int j = 0; j < b.numCols(); ++j) {
    for (int row = 0; row < view.rows; ++row) {
      for (std::size_t k = view.rowPointers[row]; k < view.rowPointers[row + 1]; ++k) {
        r(row, j) -= view.values[k] * x(view.columns[k], j);
      }
      if (!boundary.diagonal.empty()) r(row, j) -= boundary.diagonal[row] * x(row, j);
    }
    for (const auto& entry : boundary.entries) {
      for (int i = 0; i < boundary.dimension; ++i) {
        r(entry.row * boundary.dimension + i, j) -= entry.value * x(entry.column * boundary.dimension + i, j);
      }
    }
  }
  return r.normInf() / b.normInf();
}

std::string messageOf(const Teuchos::RCP<const base::CrsMatrix>& stiffness, const BoundaryTerm& boundary,
                      const std::string& solver) {
  try {
    SubstructureSolver(stiffness, boundary, SolverOptions(solver), "left flange");
  } catch (const base::Error& error) {
    return error.what();
  }
  return "no error";
}

class EverySolver : public testing::TestWithParam<std::string> {};

// 24 unknowns take Tacho's dense path, 1536 its sparse one.
TEST_P(EverySolver, solvesBlocksOfAnyWidth) {
  for (const int n : {2, 8}) {
    const Lattice lattice{n};
    const auto stiffness = lattice.matrix();
    const BoundaryTerm boundary = onOneFace(lattice, 0.3);
    const SubstructureSolver solver(stiffness, boundary, SolverOptions(GetParam()), "part");
    base::Matrix x;
    for (const int columns : {1, 11, 3, 11}) {
      const base::Matrix b = loads(lattice.dofs(), columns);
      solver.solve(b, x);
      ASSERT_EQ(x.numCols(), columns);
      EXPECT_LT(residual(*stiffness, boundary, b, x), 1e-12) << n << " " << columns;  // rounding times condition 1e3
    }
    EXPECT_GT(solver.factorNonzeros(), static_cast<std::size_t>(lattice.dofs()));
  }
}

TEST_P(EverySolver, leavesTheRightHandSideAlone) {
  const Lattice lattice{8};
  const SubstructureSolver solver(lattice.matrix(), onOneFace(lattice, 1.0), SolverOptions(GetParam()), "part");
  const base::Matrix b = loads(lattice.dofs(), 4);
  base::Matrix x;
  solver.solve(b, x);
  EXPECT_TRUE(b == loads(lattice.dofs(), 4));
}

TEST_P(EverySolver, addsAConsistentBoundaryTerm) {
  const Lattice lattice{8};
  BoundaryTerm boundary;
  for (const int node : {0, 5, 60}) {  // 0-1 and 5-6 are neighbours, 60-70 are not: the structure has to grow
    const int other = node == 60 ? 70 : node + 1;
    for (const auto& [row, column, value] :
         {std::tuple{node, node, 2.0}, {other, other, 2.0}, {node, other, 1.0}, {other, node, 1.0}}) {
      boundary.entries.push_back({row, column, value});
      boundary.entries.push_back({row, column, 0.5 * value});
    }
  }
  const auto stiffness = lattice.matrix();
  const SubstructureSolver solver(stiffness, boundary, SolverOptions(GetParam()), "part");
  const base::Matrix b = loads(lattice.dofs(), 2);
  base::Matrix x;
  solver.solve(b, x);
  EXPECT_LT(residual(*stiffness, boundary, b, x), 1e-12);
}

TEST_P(EverySolver, findsFloatingParts) {
  for (const int n : {2, 8}) {
    for (const double stiffness : {1e-6, 1.0, 1e12}) {
      const Lattice lattice{n, 3, stiffness};
      const std::string message = messageOf(lattice.matrix(), {}, GetParam());
      EXPECT_NE(message.find("\"left flange\""), std::string::npos) << message;
      EXPECT_NE(message.find("singular"), std::string::npos) << message;
    }
  }
}

TEST_P(EverySolver, acceptsWeakAndStiffSupports) {
  for (const double support : {1e-9, 1e-6, 1e6, 1e9}) {
    for (const double stiffness : {1e-6, 1e12}) {
      const Lattice lattice{8, 3, stiffness};
      EXPECT_EQ(messageOf(lattice.matrix(), onOneFace(lattice, support * stiffness), GetParam()), "no error");
    }
  }
}

TEST_P(EverySolver, findsUnusableDiagonals) {
  const Lattice lattice{3};
  BoundaryTerm boundary = onOneFace(lattice, 1.0);
  boundary.diagonal[40] = -1e3;
  const std::string message = messageOf(lattice.matrix(), boundary, GetParam());
  EXPECT_NE(message.find("node 14 of the part, component y"), std::string::npos) << message;
  boundary.diagonal[40] = std::nan("");
  EXPECT_NE(messageOf(lattice.matrix(), boundary, GetParam()).find("nan"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Names, EverySolver, testing::ValuesIn(availableSolvers()),
                         [](const auto& solver) { return solver.param; });

TEST(SubstructureSolver, findsIndefiniteOperators) {
  const Lattice lattice{8};
  BoundaryTerm boundary = onOneFace(lattice, 1.0);
  boundary.entries = {{100, 101, 50.0}, {101, 100, 50.0}};  // off-diagonal beyond the diagonals
  for (const std::string name : {"cholmod", "tacho"}) {
    if (const auto names = availableSolvers(); std::find(names.begin(), names.end(), name) == names.end()) continue;
    const std::string message = messageOf(lattice.matrix(), boundary, name);
    EXPECT_NE(message.find("\"left flange\" is indefinite"), std::string::npos) << message;
  }
}

TEST(SubstructureSolver, solvesTheTraceLikeTheWhole) {
  if (availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD gives its factor";
  const Lattice lattice{8};
  const BoundaryTerm boundary = onOneFace(lattice, 0.3);
  // Rows of nodes in two corners and of one component inside, so that trace and other rows alternate.
  std::vector<int> trace{1, 2, 3, 7, 8, 300};
  for (int dof = lattice.dofs() - 60; dof < lattice.dofs(); ++dof) trace.push_back(dof);
  for (const bool invert : {false, true}) {
    SolverOptions options;
    options.invertTrace = invert;
    SubstructureSolver solver(lattice.matrix(), boundary, options, "part", trace);
    ASSERT_TRUE(solver.solvesTrace());
    EXPECT_EQ(solver.prepareSingle() > 0.0, invert);
    const base::Matrix b = loads(static_cast<int>(trace.size()), 3);
    base::Matrix x, rough, roughAlone, whole, wholeLoads(lattice.dofs(), 3);
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < b.numRows(); ++i) wholeLoads(trace[i], j) = b(i, j);
    }
    solver.solve(wholeLoads, whole);
    solver.solveTrace(b, x, Precision::exact);
    solver.solveTrace(b, rough, Precision::single);
    solver.solveTrace(base::Matrix(Teuchos::Copy, b, b.numRows(), 1), roughAlone, Precision::single);
    const double size = whole.normInf();
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < b.numRows(); ++i) {
        const double exact = whole(trace[i], j);
        EXPECT_NEAR(x(i, j), exact, 1e-12 * size);  // rounding times condition 1e3
        EXPECT_NEAR(rough(i, j), exact, (invert ? 1e-6 : 1e-12) * size);
      }
    }
    for (int i = 0; i < b.numRows(); ++i) {
      EXPECT_NEAR(roughAlone(i, 0), whole(trace[i], 0), (invert ? 1e-6 : 1e-12) * size);
    }
    EXPECT_LT(residual(*lattice.matrix(), boundary, wholeLoads, whole), 1e-12);
  }
}

TEST(SubstructureSolver, keepsToTheSparseFactorWhereItIsCheaper) {
  const Lattice lattice{6};
  std::vector<int> all(lattice.dofs());
  std::iota(all.begin(), all.end(), 0);
  const SubstructureSolver solver(lattice.matrix(), onOneFace(lattice, 1.0), {}, "part", all);
  EXPECT_FALSE(solver.solvesTrace());
}

double distance(const base::Matrix& a, const base::Matrix& b) {
  base::Matrix difference = a;
  difference -= b;
  return difference.normFrobenius() / b.normFrobenius();
}

TEST(SubstructureSolver, knowsTheErrorOfSinglePrecision) {
  if (availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD gives its factor";
  const Lattice lattice{8};
  // The softer the springs that hold the part, the worse its condition.
  double before = 0.0;
  for (const double springs : {1.0, 1e-3}) {
    SubstructureSolver solver(lattice.matrix(), onOneFace(lattice, springs), {}, "part");
    for (const int columns : {1, 11}) {
      const base::Matrix b = loads(lattice.dofs(), columns);
      base::Matrix exact, x;
      solver.solve(b, exact);
      EXPECT_EQ(solver.singleError(), columns == 1 ? 0.0 : solver.prepareSingle());
      if (columns == 1) {
        solver.solve(b, x, Precision::single);
        EXPECT_EQ(distance(x, exact), 0.0) << "not yet prepared";
      }
      const double error = solver.prepareSingle();
      EXPECT_GT(error, before);
      EXPECT_LT(error, 1e-3);
      solver.solve(b, x, Precision::single);
      EXPECT_GT(distance(x, exact), 0.1 * error);
      // The part is as soft as the springs, rigidly.
      const double softest = lattice.dofs() / (springs * 64.0);
      x -= exact;
      EXPECT_LT(x.normFrobenius(), error * softest * b.normFrobenius());
    }
    before = solver.singleError();
  }
}

TEST(SubstructureSolver, staysExactWhereSinglePrecisionIsOfNoUse) {
  const Lattice lattice{8};
  const base::Matrix b = loads(lattice.dofs(), 1);
  SolverOptions isDouble;
  isDouble.allowsSingle = false;
  base::Matrix x, exact;
  for (const SolverOptions& options : {isDouble, SolverOptions("tacho")}) {
    SubstructureSolver solver(lattice.matrix(), onOneFace(lattice, 1.0), options, "part");
    EXPECT_EQ(solver.prepareSingle(), 0.0) << options.name;
    solver.solve(b, exact);
    solver.solve(b, x, Precision::single);
    EXPECT_EQ(distance(x, exact), 0.0) << options.name;
  }
  // Entries beyond the numbers of single precision.
  const Lattice hard{8, 3, 1e80};
  SubstructureSolver solver(hard.matrix(), onOneFace(hard, 1e80), {}, "part");
  EXPECT_EQ(solver.prepareSingle(), 0.0);
}

TEST(SubstructureSolver, namesTheSolversThatThereAre) {
  const Lattice lattice{2};
  const std::string message = messageOf(lattice.matrix(), onOneFace(lattice, 1.0), "cholesky");
  EXPECT_NE(message.find("\"cholesky\""), std::string::npos) << message;
  for (const std::string& name : availableSolvers()) EXPECT_NE(message.find(name), std::string::npos) << message;
  EXPECT_EQ(messageOf(lattice.matrix(), onOneFace(lattice, 1.0), "KLU2"), "no error");
}

TEST(SubstructureSolver, refusesRightHandSidesOfOtherSize) {
  const Lattice lattice{2};
  const SubstructureSolver solver(lattice.matrix(), onOneFace(lattice, 1.0), {}, "part");
  base::Matrix x;
  EXPECT_THROW(solver.solve(base::Matrix(lattice.dofs() - 1, 1), x), base::Error);
}

TEST(SubstructureSolver, predictionIsWhatTheFactorTakes) {
  const Lattice lattice{8};
  const auto stiffness = lattice.matrix();
  const SubstructureSolver solver(stiffness, onOneFace(lattice, 1.0), SolverOptions("tacho"), "part");
  EXPECT_EQ(predictFactor(*stiffness, {}).nonzeros, static_cast<double>(solver.factorNonzeros()));
  // Points that see several nodes couple what no element does.
  BoundaryTerm coupled = onOneFace(lattice, 1.0);
  const int nodes = lattice.dofs() / coupled.dimension;
  for (int row = 0; row < nodes; row += 37) {
    for (int column = 0; column < nodes; column += 37)
      coupled.entries.push_back({row, column, row == column ? 1.0 : 1e-3});
  }
  const SubstructureSolver other(stiffness, coupled, SolverOptions("tacho"), "part");
  EXPECT_EQ(predictFactor(*stiffness, coupled).nonzeros, static_cast<double>(other.factorNonzeros()));
  EXPECT_GT(other.factorNonzeros(), solver.factorNonzeros());
}

TEST(SubstructureSolver, predictionIsOfTracesThatAreKeptDense) {
  const Lattice lattice{8};
  const auto stiffness = lattice.matrix();
  const BoundaryTerm term = onOneFace(lattice, 1.0);
  std::vector<int> trace;
  for (int row = 0; row < lattice.dofs(); ++row) {
    if (term.diagonal[row] != 0.0) trace.push_back(row);
  }
  SolverOptions inverting("cholmod");
  inverting.invertTrace = true;
  const FactorSize sparse = predictFactor(*stiffness, term, trace, {}, SolverOptions("tacho")),
                   dense = predictFactor(*stiffness, term, trace, {}, inverting);
  EXPECT_FALSE(sparse.isTraceLast);
  EXPECT_TRUE(dense.isTraceLast);
  EXPECT_GT(dense.nonzeros, sparse.nonzeros);
  EXPECT_TRUE(dense.isTraceInverted);
  // Supernodes of CHOLMOD are padded, the more the smaller they are.
  const SubstructureSolver solver(stiffness, term, {}, "part", trace);
  if (solver.solvesTrace()) {
    EXPECT_LE(dense.nonzeros, static_cast<double>(solver.factorNonzeros()));
    EXPECT_GT(3.0 * dense.nonzeros, static_cast<double>(solver.factorNonzeros()));
  }
}

}  // namespace
}  // namespace harmos::substructure
