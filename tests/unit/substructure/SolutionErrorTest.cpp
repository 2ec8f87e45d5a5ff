#include <cmath>

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>
#include <harmos/substructure/detail/DifferenceProduct.hpp>

namespace harmos::substructure {
namespace {

constexpr int dimension = 3;

/// Nodes one after the other, each joined to the next by a spring that is the same in all directions.
struct Chain {
  std::vector<double> springs;

  int nodes() const { return static_cast<int>(springs.size()) + 1; }
  int dofs() const { return dimension * nodes(); }

  Teuchos::RCP<base::CrsMatrix> matrix() const {
    std::vector<MatrixEntry> entries;
    for (std::size_t i = 0; i < springs.size(); ++i) {
      for (int c = 0; c < dimension; ++c) {
        const int row = dimension * static_cast<int>(i) + c, next = row + dimension;
        entries.insert(entries.end(), {{row, row, springs[i]}, {next, next, springs[i]}});
        entries.insert(entries.end(), {{row, next, -springs[i]}, {next, row, -springs[i]}});
      }
    }
    return makeCrsMatrix(entries, dofs());
  }
  /// Not on one line.
  std::vector<base::Vector3> places() const {
    std::vector<base::Vector3> places;
    for (int i = 0; i < nodes(); ++i) places.push_back({static_cast<double>(i), i % 2 * 1.0, i % 3 * 1.0});
    return places;
  }
  /// So many nodes at its beginning on springs to the ground.
  BoundaryTerm held(int count, double spring) const {
    BoundaryTerm term;
    term.diagonal.assign(static_cast<std::size_t>(dofs()), 0.0);
    std::fill_n(term.diagonal.begin(), dimension * count, spring);
    return term;
  }
};

Chain longChain() {
  Chain chain;
  for (int i = 0; i < 20000; ++i) chain.springs.push_back(i % 2 == 0 ? 0.1 : 0.3);
  return chain;
}

/// Error of the way of the last node under a unit force [-].
double errorOf(const Chain& chain, const SubstructureSolver& solver) {
  long double exact = 0.5L;
  for (const double spring : chain.springs) exact += 1.0L / spring;
  base::Matrix force(chain.dofs(), 1), u;
  force(chain.dofs() - 1, 0) = 1.0;
  solver.solve(force, u);
  return std::abs(static_cast<double>(u(chain.dofs() - 1, 0) / exact - 1.0L));
}

// 0.1 + 0.3 is rounded, at every node alike.
TEST(SolutionError, OfRoundedEntriesIsKnown) {
  const Chain chain = longChain();
  const SubstructureSolver solver(chain.matrix(), chain.held(1, 2.0), {}, "chain", {}, chain.places());
  const double error = errorOf(chain, solver);
  EXPECT_GT(error, 1e-9);
  EXPECT_GT(solver.solutionError(), 0.5 * error);
  EXPECT_LT(solver.solutionError(), 10.0 * error);
}

TEST(SolutionError, IsSmallWhereAPartIsShort) {
  const Chain chain{std::vector<double>(30, 0.3)};
  const SubstructureSolver solver(chain.matrix(), chain.held(1, 2.0), {}, "chain", {}, chain.places());
  EXPECT_LT(solver.solutionError(), 1e-12);
}

TEST(SolutionError, TellsTheSlenderFromTheFree) {
  Chain chain{std::vector<double>(30, 1.0)};
  chain.springs[15] = 1e-18;
  const auto messageOf = [&](const BoundaryTerm& term) -> std::string {
    try {
      const SubstructureSolver solver(chain.matrix(), term, {}, "chain", {}, chain.places());
    } catch (const base::Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(messageOf(chain.held(4, 1.0)).find("\"Pieces\""), std::string::npos) << messageOf(chain.held(4, 1.0));
  EXPECT_NE(messageOf(chain.held(0, 1.0)).find("can move or turn"), std::string::npos);
}

TEST(DifferenceProduct, LeavesNothingOfTranslationsButWhatResistsThem) {
  const Chain chain = longChain();
  base::Matrix none(chain.dofs(), 1), far(chain.dofs(), 1);
  far.putScalar(1e9);
  EXPECT_EQ(DifferenceProduct(chain.matrix(), {}).residual(none, far).normInf(), 0.0);
  const auto grounded = chain.matrix();
  const auto local = grounded->getLocalMatrixHost();
  local.values(viewOf(*grounded, "chain").positionOf(30, 30)) += 1e-6;
  const base::Matrix left = DifferenceProduct(grounded, {}).residual(none, far);
  EXPECT_NEAR(left(30, 0), -1e3, 1e-5);
  EXPECT_NEAR(left.normOne(), 1e3, 1e-5);
  EXPECT_EQ(DifferenceProduct(chain.matrix(), chain.held(1, 2.0)).residual(none, far).normOne(), 6e9);
}

}  // namespace
}  // namespace harmos::substructure
