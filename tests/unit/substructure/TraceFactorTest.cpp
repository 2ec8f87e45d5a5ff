#include <gtest/gtest.h>

#include <cmath>

#include <harmos/substructure/SolverFactory.hpp>

// Amesos2's solver is a forward declaration in the factory.
#include <Amesos2.hpp>

#include "RandomSystem.hpp"

namespace harmos::substructure {
namespace {

TEST(TraceFactor, IsTheSchurComplementOfAnyTraceOfAnyGraph) {
  if (availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD gives its factor";
  int factors = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    RandomSystem system(seed);
    SolverOptions options;
    options.invertTrace = seed % 2 == 0;  // allows larger traces
    const auto solver = makeSolver(options, system.matrix, system.trace);
    solver->symbolicFactorization().numericFactorization();
    const auto factor = traceFactor(*solver);
    if (!factor) continue;
    ++factors;
    const int count = static_cast<int>(system.trace.size());
    base::Matrix unit(count, count), found;
    for (int i = 0; i < count; ++i) unit(i, i) = 1.0;
    factor->solve(unit, found);
    const base::Matrix exact = system.inverseOnTrace();
    for (int j = 0; j < count; ++j) {
      // The inverse of a diagonally dominant matrix has entries below 1, and the condition is about 10.
      for (int i = 0; i < count; ++i) ASSERT_NEAR(found(i, j), exact(i, j), 1e-13) << "seed " << seed;
    }
  }
  EXPECT_GT(factors, 200);
}

TEST(TraceFactor, IsTheSameInSinglePrecision) {
  for (const int rows : {1, 5, LowerTriangle::width, LowerTriangle::width + 1, 2 * LowerTriangle::width + 7}) {
    TraceFactor factor;
    factor.lower = LowerTriangle(rows);
    for (int i = 0; i < rows; ++i) {
      factor.order.push_back(rows - 1 - i);
      for (int j = 0; j < i; ++j) factor.lower(i, j) = std::sin(1.0 + i * rows + j) / rows;
      factor.lower(i, i) = 1.1 + 0.5 * std::sin(i);
    }
    const SingleFactor single = factor.single();
    for (const int columns : {1, 2, 11}) {
      base::Matrix b(rows, columns), exact, x(rows, columns);
      for (int j = 0; j < columns; ++j) {
        for (int i = 0; i < rows; ++i) b(i, j) = std::cos(3.0 * i + j);
      }
      factor.solve(b, exact);
      single.solve(b, x);
      x -= exact;
      EXPECT_LT(x.normFrobenius(), 1e-5 * exact.normFrobenius()) << rows << " rows, " << columns << " columns";
      EXPECT_GT(x.normFrobenius(), 0.0) << rows << " rows, " << columns << " columns";
    }
  }
}

}  // namespace
}  // namespace harmos::substructure
