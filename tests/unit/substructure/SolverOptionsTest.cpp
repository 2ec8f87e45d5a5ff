#include <harmos/substructure/SolverOptions.hpp>

#include <gtest/gtest.h>

namespace harmos::substructure {
namespace {

// A trace that is small beside the sparse factor is kept dense in any case, and inverted where solves are many; a
// larger one only then; one that is larger still, never.
TEST(SolverOptions, InvertTracesWhereSolvesAreManyEnough) {
  constexpr double small = 500.0, entries = 1e6, middling = 2000.0, large = 4000.0;
  SolverOptions options("cholmod");
  EXPECT_TRUE(options.keepsDense(small, entries));
  EXPECT_FALSE(options.inverts(small, entries));
  EXPECT_FALSE(options.keepsDense(middling, entries));
  options.invertTrace = true;
  for (const double rows : {small, middling}) EXPECT_TRUE(options.inverts(rows, entries)) << rows;
  options.traceSolves = 10.0;
  for (const double rows : {small, middling}) EXPECT_FALSE(options.inverts(rows, entries)) << rows;
  EXPECT_TRUE(options.keepsDense(small, entries));
  EXPECT_FALSE(options.keepsDense(middling, entries));
  options.traceSolves = 1e4;
  for (const double rows : {small, middling}) EXPECT_TRUE(options.inverts(rows, entries)) << rows;
  EXPECT_TRUE(options.keepsDense(middling, entries));
  EXPECT_FALSE(options.keepsDense(large, entries));
  options.name = "tacho";
  EXPECT_FALSE(options.keepsDense(small, entries));
}

}  // namespace
}  // namespace harmos::substructure
