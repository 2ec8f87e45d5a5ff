// A factor that one rank sends to another.
#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/substructure/SingleFactor.hpp>

namespace harmos::substructure {
namespace {

/// Columns of two supernodes of a triangle with 70 and 30 columns.
SingleFactor someFactor() {
  constexpr int size = 100, wide = 70;
  std::vector<int> order(size), rows(size);
  std::vector<double> values;
  for (int k = 0; k < size; ++k) {
    order[k] = (k * 37) % size;
    rows[k] = k;
  }
  SingleFactor factor(order, size * size);
  for (const int first : {0, wide}) {
    const int height = size - first;
    values.assign(static_cast<std::size_t>(height) * height, 0.0);
    for (int j = 0; j < height; ++j) {
      for (int i = j; i < height; ++i) values[static_cast<std::size_t>(j) * height + i] = i == j ? 2.0 : 0.01 * (i % 7);
    }
    factor.add(first == 0 ? wide : size - wide, height, rows.data() + first, values.data());
  }
  factor.setTrace({3, 50, 99});
  return factor;
}

TEST(SingleFactor, ArrivesAsItWasSent) {
  const auto comm = Tpetra::getDefaultComm();
  if (comm->getSize() == 1) GTEST_SKIP() << "for several ranks";
  const int last = comm->getSize() - 1;
  const SingleFactor sent = someFactor();
  if (comm->getRank() == last) sent.send(*comm, 0);
  if (comm->getRank() != 0) return;
  const SingleFactor found = SingleFactor::receive(*comm, last);
  EXPECT_EQ(found.memory(), sent.memory());
  EXPECT_EQ(found.traceEntries(), sent.traceEntries());
  base::Matrix b(100, 5), part(3, 5), x(b), expected(b), partX(part), partExpected(part);
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 100; ++i) b(i, j) = 1.0 + (i + j) % 5;
    for (int i = 0; i < 3; ++i) part(i, j) = 1.0 + i + j;
  }
  found.solve(b, x);
  sent.solve(b, expected);
  EXPECT_EQ(x, expected);
  found.solveTrace(part, partX);
  sent.solveTrace(part, partExpected);
  EXPECT_EQ(partX, partExpected);
}

}  // namespace
}  // namespace harmos::substructure
