#include <harmos/substructure/NestedDissection.hpp>

#include <gtest/gtest.h>

#include <harmos/substructure/MirrorPlanes.hpp>

#include "Lattice.hpp"
#include "MirroredLattice.hpp"

namespace harmos::substructure {
namespace {

/// Entries of L by elimination of a dense pattern.
double entriesByElimination(const CrsView& matrix, const Ordering& ordering) {
  const auto n = static_cast<std::size_t>(matrix.rows);
  std::vector<std::vector<bool>> filled(n, std::vector<bool>(n, false));
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t k = matrix.rowPointers[row]; k < matrix.rowPointers[row + 1]; ++k) {
      filled[ordering.position[row]][ordering.position[matrix.columns[k]]] = true;
    }
  }
  double entries = 0.0;
  for (std::size_t pivot = 0; pivot < n; ++pivot) {
    for (std::size_t i = pivot; i < n; ++i) {
      if (!filled[i][pivot]) continue;
      entries += 1.0;
      for (std::size_t j = pivot + 1; j < n; ++j) {
        if (filled[j][pivot]) filled[i][j] = true;
      }
    }
  }
  return entries;
}

TEST(NestedDissection, isAPermutationThatKeepsNodesTogether) {
  const Lattice lattice{6};
  const auto matrix = lattice.matrix();
  const CrsView view = viewOf(*matrix, "part");
  const NestedDissection dissection(view.rows, view.rowPointers, view.columns);
  const Ordering& ordering = dissection.ordering();
  for (int row = 0; row < view.rows; ++row) {
    const int position = ordering.position[row];
    ASSERT_EQ(ordering.old[position], row);
    ASSERT_EQ(position % 3, row % 3);
  }
}

TEST(NestedDissection, ordersRowsLast) {
  const Lattice lattice{6};
  const auto matrix = lattice.matrix();
  const CrsView view = viewOf(*matrix, "part");
  const NestedDissection mixed(view.rows, view.rowPointers, view.columns, {4, 300});  // one component of two nodes
  const std::vector<int>& old = mixed.ordering().old;
  EXPECT_EQ(std::vector<int>(old.end() - 2, old.end()), (std::vector<int>{4, 300}));
  for (int row = 0; row < view.rows; ++row) {
    EXPECT_EQ(old[mixed.ordering().position[row]], row);
  }
  const NestedDissection whole(view.rows, view.rowPointers, view.columns, {3, 4, 5, 300, 301, 302});
  EXPECT_EQ(whole.factorSize().nonzeros, entriesByElimination(view, whole.ordering()));
}

TEST(NestedDissection, predictsTheFactorExactly) {
  for (const int dimension : {1, 2, 3}) {
    const Lattice lattice{4, dimension};
    const auto matrix = lattice.matrix();
    const CrsView view = viewOf(*matrix, "part");
    const NestedDissection dissection(view.rows, view.rowPointers, view.columns);
    EXPECT_EQ(dissection.factorSize().nonzeros, entriesByElimination(view, dissection.ordering()));
  }
}

TEST(NestedDissection, predictsTheFactorOfNodesWithDifferentNumbersOfComponents) {
  // Nodes on a mirror plane have two components that are even and one that is odd.
  const MirroredLattice lattice(3);
  MirrorPlanes planes(lattice.nodes, 3);
  planes.keepThoseOf(viewOf(*lattice.matrix, "lattice"));
  for (const std::vector<int>& rows : planes.blocks()) {
    const auto block = planes.blockOf(viewOf(*lattice.matrix, "lattice"), rows);
    const CrsView view = viewOf(*block, "block");
    const NestedDissection dissection(view.rows, view.rowPointers, view.columns);
    EXPECT_EQ(dissection.factorSize().nonzeros, entriesByElimination(view, dissection.ordering()));
  }
}

TEST(NestedDissection, takesMatricesWithoutCoupling) {
  const auto matrix = makeCrsMatrix({0, 1, 2}, {0, 1}, {1.0, 1.0});
  const CrsView view = viewOf(*matrix, "part");
  EXPECT_EQ(NestedDissection(view.rows, view.rowPointers, view.columns).factorSize().nonzeros, 2.0);
}

}  // namespace
}  // namespace harmos::substructure
