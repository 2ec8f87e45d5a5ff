#include <gtest/gtest.h>

#include <memory>
#include <numeric>

#include <harmos/substructure/SolverFactory.hpp>

// Amesos2's solver is a forward declaration in the factory.
#include <Amesos2.hpp>

#include "RandomSystem.hpp"

namespace harmos::substructure {
namespace {

std::unique_ptr<SingleFactor> factorOf(const RandomSystem& system) {
  const auto solver = makeSolver({}, system.matrix, {});
  solver->symbolicFactorization().numericFactorization();
  return singleFactor(*solver);
}

TEST(SingleFactor, SolvesAnyGraphInAnyBlock) {
  if (availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD gives its factor";
  for (unsigned seed = 0; seed < 200; ++seed) {
    RandomSystem system(seed);
    const auto factor = factorOf(system);
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

TEST(SingleFactor, LeavesOutWhatTheTraceDoesNotNeed) {
  if (availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD gives its factor";
  std::size_t read = 0, whole = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    RandomSystem system(seed);
    const auto factor = factorOf(system);
    ASSERT_TRUE(factor);
    whole += factor->traceEntries();
    factor->setTrace(system.trace);
    read += factor->traceEntries();
    const base::Matrix exact = system.inverseOnTrace();
    base::Matrix unit(exact), x(exact);
    unit.putScalar(0.0);
    for (int j = 0; j < unit.numCols(); ++j) unit(j, j) = 1.0;
    factor->solveTrace(unit, x);
    for (int j = 0; j < x.numCols(); ++j) {
      for (int i = 0; i < x.numRows(); ++i) ASSERT_NEAR(x(i, j), exact(i, j), 1e-6) << "seed " << seed;
    }
  }
  EXPECT_LT(read, whole);
}

TEST(SingleFactor, SolvesWithWideSupernodes) {
  // L of two supernodes, 150 and 50 columns wide; every second row of the last 50 is none of the first one.
  constexpr int size = 200, wide = 150;
  base::Matrix lower(size, size);
  for (int j = 0; j < size; ++j) {
    for (int i = j; i < size; ++i) lower(i, j) = i == j ? 2.0 + 0.01 * j : 0.05 * ((7 * i + 3 * j) % 11 - 5) / 5.0;
  }
  std::vector<int> order(size), rows;
  for (int k = 0; k < size; ++k) order[k] = (k * 77) % size;
  for (int k = 0; k < wide; ++k) rows.push_back(k);
  for (int k = wide; k < size; k += 2) rows.push_back(k);
  for (int j = 0; j < wide; ++j) {
    for (int i = wide + 1; i < size; i += 2) lower(i, j) = 0.0;
  }
  const auto columnsOf = [&lower](int first, int count, const std::vector<int>& at) {
    std::vector<double> values;
    for (int j = first; j < first + count; ++j) {
      for (const int i : at) values.push_back(i < j ? 1e30 : lower(i, j));  // what is above the diagonal is not read
    }
    return values;
  };
  std::vector<int> last(size - wide);
  std::iota(last.begin(), last.end(), wide);
  SingleFactor factor(order, static_cast<std::size_t>(size) * size);
  factor.add(wide, static_cast<int>(rows.size()), rows.data(), columnsOf(0, wide, rows).data());
  factor.add(size - wide, size - wide, last.data(), columnsOf(wide, size - wide, last).data());
  // A trace that begins in the second panel of the first supernode, and rows that only the second one has.
  const std::size_t whole = factor.traceEntries();
  for (const std::vector<int>& trace :
       {std::vector<int>{70, 149, 151}, std::vector<int>{151, 199}, std::vector<int>{}}) {
    std::vector<int> places;
    for (const int k : trace) places.push_back(order[k]);
    factor.setTrace(places);
    // 64 columns with 175 rows, 64 with 111, 22 with 47; 50 with 50.
    const std::size_t second = 50 * 50, first = trace.empty() || trace[0] > 149 ? 0 : 64 * 111 + 22 * 47;
    EXPECT_EQ(whole, 64 * 175 + 64 * 111 + 22 * 47 + second);
    EXPECT_EQ(factor.traceEntries(), trace.empty() ? 0 : first + second);
    for (const int columns : {1, 7}) {
      const int count = static_cast<int>(trace.size());
      base::Matrix given(count, columns), found(count, columns), b(size, columns), x(size, columns);
      for (int j = 0; j < columns; ++j) {
        for (int i = 0; i < count; ++i) given(i, j) = b(places[i], j) = 1.0 + (i + j) % 3;
      }
      factor.solve(b, x);
      factor.solveTrace(given, found);
      for (int j = 0; j < columns; ++j) {
        for (int i = 0; i < count; ++i) EXPECT_NEAR(found(i, j), x(places[i], j), 1e-14 * x.normInf());
      }
    }
  }
  for (const int columns : {1, 3, 7}) {
    base::Matrix exact(size, columns), b(size, columns), x(size, columns), y(size, columns), product(size, columns);
    for (int j = 0; j < columns; ++j) {
      for (int k = 0; k < size; ++k) exact(k, j) = 1.0 + (k + j) % 5;
    }
    y.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, lower, exact, 0.0);
    product.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, lower, y, 0.0);
    for (int j = 0; j < columns; ++j) {
      for (int k = 0; k < size; ++k) b(order[k], j) = product(k, j);
    }
    factor.solve(b, x);
    for (int j = 0; j < columns; ++j) {
      // Seven digits, and a condition of about 10.
      for (int k = 0; k < size; ++k) EXPECT_NEAR(x(order[k], j), exact(k, j), 2e-5);
    }
  }
}

TEST(SingleFactor, SolvesColumnsOfAnySize) {
  if (availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD gives its factor";
  RandomSystem system(1);
  const auto factor = factorOf(system);
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
