#include <harmos/latin/detail/ConstrainedOperator.hpp>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>

#include <harmos/substructure/CrsMatrix.hpp>

#include "Chains.hpp"

namespace harmos::latin {
namespace {

constexpr int nodes = 20000;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Sum of the forces [force] that the experiment on round-off finds for a unit translation.
double roundOffOfTranslation(const Teuchos::RCP<const base::CrsMatrix>& stiffness) {
  std::vector<double> u(static_cast<std::size_t>(3) * nodes, 0.0), forces(u);
  for (std::size_t row = 0; row < u.size(); row += 3) u[row] = 1.0;
  ConstrainedOperator(stiffness, {}).addRoundOff(0, {u.data()}, {forces.data()});
  return std::abs(std::accumulate(forces.begin(), forces.end(), 0.0));
}

// Of a matrix with all that boundaries and interfaces make of it, columns are what unit displacements give, whichever
// components of a node are asked for.
TEST(ConstrainedOperator, HasTheColumnsOfItsProducts) {
  constexpr int dofs = 9;
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

// Rows of this chain add up to nothing; as far as factors are off, then by chance.
TEST(ConstrainedOperator, DoesNotResistTranslationsAlikeWhereEntriesAreExact) {
  EXPECT_LT(roundOffOfTranslation(chainMatrix(nodes, 0.5)), 0.1 * nodes * epsilon);
}

TEST(ConstrainedOperator, ResistsTranslationsAsItsEntriesDo) {
  const auto rounded = chainMatrix(nodes, 0.5);
  const auto local = rounded->getLocalMatrixHost();
  const substructure::CrsView view = substructure::viewOf(*rounded, "chain");
  for (int row = 0; row < view.rows; ++row) local.values(view.positionOf(row, row)) += epsilon;
  EXPECT_NEAR(roundOffOfTranslation(rounded), nodes * epsilon, 0.1 * nodes * epsilon);
}

}  // namespace
}  // namespace harmos::latin
