#include <harmos/latin/detail/ConstrainedOperator.hpp>

#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::latin {
namespace {

// Of a matrix with all that boundaries and interfaces make of it, columns are what unit displacements give, whichever
// components of a node are asked for.
TEST(ConstrainedOperator, HasTheColumnsOfItsProducts) {
  constexpr int nodes = 3, dofs = 3 * nodes;
  std::vector<substructure::MatrixEntry> entries;
  for (int i = 0; i < dofs; ++i) {
    for (int j = 0; j < dofs; ++j) entries.push_back({i, j, i == j ? 10.0 : 1.0 / (1 + i + j)});
  }
  substructure::BoundaryTerm term;
  term.diagonal = {0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 0.0, 0.0, 0.0};
  term.entries = {{0, 2, 0.5}, {2, 0, 0.5}, {2, 2, 0.25}};
  term.springs = {{2, {base::Vector3{3.0, 1.0, 0.0}, base::Vector3{1.0, 4.0, 2.0}, base::Vector3{0.0, 2.0, 5.0}}}};
  const ConstrainedOperator constrained(substructure::makeCrsMatrix(entries, dofs), term);
  std::vector<int> all(dofs);
  std::iota(all.begin(), all.end(), 0);
  const std::vector<int> asked{0, 4, 6, 8};
  base::Matrix columns(dofs, static_cast<int>(asked.size()));
  constrained.addColumns(asked, columns);
  for (std::size_t j = 0; j < asked.size(); ++j) {
    std::vector<double> unit(dofs, 0.0), product(dofs);
    unit[asked[j]] = 1.0;
    constrained.multiply(unit.data(), all, product.data());
    for (int row = 0; row < dofs; ++row) EXPECT_DOUBLE_EQ(columns[static_cast<int>(j)][row], product[row]) << row;
  }
}

}  // namespace
}  // namespace harmos::latin
