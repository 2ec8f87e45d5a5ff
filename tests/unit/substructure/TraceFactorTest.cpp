#include <gtest/gtest.h>

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

}  // namespace
}  // namespace harmos::substructure
