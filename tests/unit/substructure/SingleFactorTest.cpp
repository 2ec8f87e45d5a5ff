#include <gtest/gtest.h>

#include <numeric>

#include <harmos/substructure/SolverFactory.hpp>

// Amesos2's solver is a forward declaration in the factory.
#include <Amesos2.hpp>

#include "RandomSystem.hpp"

namespace harmos::substructure {
namespace {

TEST(SingleFactor, SolvesAnyGraphInAnyBlock) {
  if (availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD gives its factor";
  for (unsigned seed = 0; seed < 200; ++seed) {
    RandomSystem system(seed);
    const auto solver = makeSolver({}, system.matrix, {});
    solver->symbolicFactorization().numericFactorization();
    const auto factor = singleFactor(*solver);
    ASSERT_TRUE(factor);
    system.trace.resize(system.size);
    std::iota(system.trace.begin(), system.trace.end(), 0);
    const base::Matrix exact = system.inverseOnTrace();
    // Blocks of every width, single columns among them; some right-hand sides are zero but for one row.
    for (int first = 0, width = 1; first < system.size; first += width, ++width) {
      const int columns = std::min(width, system.size - first);
      base::Matrix b(system.size, columns), x(system.size, columns);
      for (int j = 0; j < columns; ++j) b(first + j, j) = 1.0;
      factor->solve(b, x);
      for (int j = 0; j < columns; ++j) {
        // Six digits, the condition is about 10, and the entries of the inverse are below 1.
        for (int i = 0; i < system.size; ++i) ASSERT_NEAR(x(i, j), exact(i, first + j), 1e-6) << "seed " << seed;
      }
    }
  }
}

TEST(SingleFactor, SolvesColumnsOfAnySize) {
  if (availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD gives its factor";
  RandomSystem system(1);
  const auto solver = makeSolver({}, system.matrix, {});
  solver->symbolicFactorization().numericFactorization();
  const auto factor = singleFactor(*solver);
  ASSERT_TRUE(factor);
  // Beyond what single precision can hold, and nothing.
  const std::vector<double> sizes{1.0, 1e-80, 1e80, 0.0};
  base::Matrix b(system.size, 4), x(system.size, 4);
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < system.size; ++i) b(i, j) = sizes[j] * (1.0 + i % 7);
  }
  factor->solve(b, x);
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < system.size; ++i) EXPECT_NEAR(x(i, j), sizes[j] * x(i, 0), 1e-14 * sizes[j] * x.normInf());
  }
}

}  // namespace
}  // namespace harmos::substructure
