#include <gtest/gtest.h>

#include <harmos/mesh/TraceOperator.hpp>

namespace harmos::mesh {
namespace {

/// w_p of nodal values u.
double traceAt(const TraceOperator& b, int point, const std::vector<double>& u) {
  double w = 0.0;
  for (const TraceOperator::Entry& entry : b.row(point)) w += entry.weight * u[static_cast<std::size_t>(entry.node)];
  return w;
}

TEST(TraceOperator, HasNoPointsAtFirst) {
  const TraceOperator none;
  EXPECT_EQ(none.points(), 0);
  EXPECT_TRUE(none.isSelection());
}

TEST(TraceOperator, SelectsOneNodeForEachPoint) {
  const TraceOperator b(std::vector<int>{2, 0, 2});
  ASSERT_EQ(b.points(), 3);
  EXPECT_TRUE(b.isSelection());
  const std::vector<double> u{5.0, 6.0, 7.0};
  EXPECT_EQ(traceAt(b, 0, u), 7.0);
  EXPECT_EQ(traceAt(b, 1, u), 5.0);
  EXPECT_EQ(traceAt(b, 2, u), 7.0);
}

TEST(TraceOperator, WeighsSeveralNodes) {
  TraceOperator b(std::vector<int>{1});
  b.append({{0, 0.25}, {2, 0.75}});
  ASSERT_EQ(b.points(), 2);
  EXPECT_FALSE(b.isSelection());
  EXPECT_EQ(b.row(0).end() - b.row(0).begin(), 1);
  EXPECT_EQ(b.row(1).end() - b.row(1).begin(), 2);
  EXPECT_EQ(traceAt(b, 0, {4.0, 6.0, 8.0}), 6.0);
  EXPECT_EQ(traceAt(b, 1, {4.0, 6.0, 8.0}), 7.0);
}

TEST(TraceOperator, CarriesVectorsToPointsAndForcesBack) {
  TraceOperator b(std::vector<int>{1});
  b.append({{0, 0.25}, {2, 0.75}});
  EXPECT_EQ(TraceOperator(std::vector<int>{7, 4}).node(1), 4);
  EXPECT_EQ(b.at(1, {{4, 0, 1}, {9, 9, 9}, {8, 4, 1}}), (base::Vector3{7, 3, 1}));

  const std::vector<double> u{4, 0, 6, 1, 8, 4};  // of three nodes in the plane
  std::vector<double> w{1, 1, 1, 1};
  b.addProduct(2, u.data(), w.data());
  EXPECT_EQ(w, (std::vector<double>{7, 2, 8, 4}));
  const std::vector<double> f{3, 1, 4, 8};
  std::vector<double> forces{0, 0, 0, 0, 1, 1};
  b.addTransposed(2, f.data(), forces.data());
  EXPECT_EQ(forces, (std::vector<double>{1, 2, 3, 1, 4, 7}));
}

TEST(TraceOperator, OfOtherWeightOrWithoutEntriesIsNoSelection) {
  TraceOperator half, empty;
  half.append({{0, 0.5}});
  EXPECT_FALSE(half.isSelection());
  empty.append({});
  EXPECT_EQ(empty.points(), 1);
  EXPECT_FALSE(empty.isSelection());
}

}  // namespace
}  // namespace harmos::mesh
