#include <cmath>

#include <gtest/gtest.h>

#include <harmos/latin/CorrectionSpace.hpp>
#include <harmos/latin/FixedPoint.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

/// The metric of two chains whose ends and joint have rows: six numbers of each side.
struct Metric {
  Metric()
      : assembly(twoChains(laws::makeLaw("Perfect"), clamp())),
        fixedPoint(assembly, {}, self(), timers),
        metric(fixedPoint.metric()),
        rows(fixedPoint.layout().rows()) {}

  double dot(const double* a, const double* b) const {
    double sum = 0.0;
    for (int row = 0; row < rows; ++row) sum += metric.scale()[row] * metric.scale()[row] * a[row] * b[row];
    return sum;
  }

  base::Timers timers;
  assembly::Assembly assembly;
  FixedPoint fixedPoint;
  const StateMetric& metric;
  int rows;
};

/// `factors` times directions of a space, from `first` on.
base::Matrix timesDirections(const Metric& m, const CorrectionSpace& space, int first,
                             const std::vector<double>& factors) {
  base::Matrix g(m.rows, static_cast<int>(factors.size()));
  for (int j = 0; j < g.numCols(); ++j) {
    for (int row = 0; row < m.rows; ++row) g[j][row] = factors[j] * space.direction(first + j)[row];
  }
  return g;
}

/// A space of random directions whose g is `factors` times their v.
CorrectionSpace scaledSpace(const Metric& m, const std::vector<double>& factors,
                            substructure::Precision images = substructure::Precision::single) {
  CorrectionSpace space(m.metric, images);
  base::Matrix v(m.rows, static_cast<int>(factors.size()));
  randomize(v);
  for (std::size_t j = 0; j < factors.size(); ++j) {
    double* column = v[static_cast<int>(j)];
    EXPECT_TRUE(space.makeIndependent(column));
    std::vector<double> y(column, column + m.rows);
    for (double& value : y) value *= 3.0;
    space.add(column, y.data());
    space.append(timesDirections(m, space, space.size() - 1, {factors[j]}));
  }
  return space;
}

TEST(CorrectionSpace, MakesDirectionsOrthonormal) {
  const Metric m;
  const CorrectionSpace space = scaledSpace(m, {1.0, 1.0, 1.0});
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(m.dot(space.direction(i), space.direction(j)), i == j ? 1.0 : 0.0, 1e-14);
    }
  }
  std::vector<double> inside(m.rows);
  for (int row = 0; row < m.rows; ++row) inside[row] = 2.0 * space.direction(0)[row] - space.direction(2)[row];
  EXPECT_FALSE(space.makeIndependent(inside.data()));
}

// Without singular values the same comes out, also where a direction has nothing but round-off.
TEST(CorrectionSpace, SolvesDampedLeastSquares) {
  const Metric m;
  for (const double least : {0.25, 1e-3, 0.0}) {
    const CorrectionSpace space = scaledSpace(m, {0.5, least, 2.0});
    base::Matrix residual(m.rows, 1);
    randomize(residual, 11);
    const CorrectionSpace::LeastSquares exact = space.solve(residual[0]), damped = space.solveDamped(residual[0]);
    EXPECT_NEAR(damped.left, exact.left, 1e-6 * exact.left) << least;
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(damped.c[j], exact.c[j], 1e-6 * (1.0 + std::abs(exact.c[j]))) << j;
  }
}

TEST(CorrectionSpace, SolvesLeastSquares) {
  const Metric m;
  CorrectionSpace space = scaledSpace(m, {0.5, 2.0});
  base::Matrix outside(m.rows, 1);
  randomize(outside, 7);
  ASSERT_TRUE(space.makeIndependent(outside[0]));
  std::vector<double> residual(m.rows);
  for (int row = 0; row < m.rows; ++row) {
    residual[row] = 3.0 * space.direction(0)[row] - 4.0 * space.direction(1)[row] + 5.0 * outside[0][row];
  }
  const CorrectionSpace::LeastSquares found = space.solve(residual.data());
  EXPECT_NEAR(found.c[0], 6.0, 1e-12);
  EXPECT_NEAR(found.c[1], -2.0, 1e-12);
  EXPECT_NEAR(found.left, 5.0, 1e-12);
  EXPECT_NEAR(space.smallestSingularValue(), 0.5, 1e-12);

  std::vector<double> alpha(m.rows, 0.0), beta(m.rows, 0.0);
  space.move(found.c, 0.5, alpha.data(), beta.data());
  for (int row = 0; row < m.rows; ++row) EXPECT_NEAR(beta[row], 3.0 * alpha[row], 1e-13);
  EXPECT_NEAR(m.dot(alpha.data(), space.direction(0)), 3.0, 1e-12);
}

// A direction that T does not answer to, but for round-off, gets nothing instead of everything.
TEST(CorrectionSpace, LeavesOutWhatIsSingular) {
  const Metric m;
  const CorrectionSpace space = scaledSpace(m, {1.0, 1e-12});
  std::vector<double> residual(m.rows);
  for (int row = 0; row < m.rows; ++row) residual[row] = space.direction(0)[row] + space.direction(1)[row];
  const CorrectionSpace::LeastSquares found = space.solve(residual.data());
  EXPECT_NEAR(found.c[0], 1.0, 1e-10);
  EXPECT_NEAR(found.c[1], 0.0, 1e-4);
  EXPECT_NEAR(found.left, 1.0, 1e-10);
  EXPECT_NEAR(space.smallestSingularValue(), 1.0, 1e-10);
}

// What is round-off of images in single precision is that of soft springs where images are exact.
TEST(CorrectionSpace, KeepsWhatIsHardlyResistedWhereImagesAreExact) {
  const Metric m;
  for (const auto images : {substructure::Precision::single, substructure::Precision::exact}) {
    const CorrectionSpace space = scaledSpace(m, {1.0, 1e-9}, images);
    std::vector<double> residual(m.rows);
    for (int row = 0; row < m.rows; ++row) residual[row] = space.direction(0)[row] + space.direction(1)[row];
    const bool isExact = images == substructure::Precision::exact;
    EXPECT_NEAR(space.solve(residual.data()).c[1], isExact ? 1e9 : 0.0, isExact ? 1e3 : 1e-4);
    EXPECT_NEAR(space.smallestSingularValue(), isExact ? 1e-9 : 1.0, 1e-13);
  }
}

// Where loads are found, one direction may ask for many times the loads that others do.
TEST(CorrectionSpace, KeepsWhatIsSmallBesideWhatIsLarge) {
  const Metric m;
  const CorrectionSpace space = scaledSpace(m, {2e4, 1e-4});
  std::vector<double> residual(m.rows);
  for (int row = 0; row < m.rows; ++row) residual[row] = space.direction(0)[row] + space.direction(1)[row];
  const CorrectionSpace::LeastSquares found = space.solve(residual.data());
  EXPECT_NEAR(found.c[0], 5e-5, 1e-10);
  EXPECT_NEAR(found.c[1], 1e4, 1e-3);
  EXPECT_NEAR(found.left, 0.0, 1e-8);
  EXPECT_NEAR(space.smallestSingularValue(), 1e-4, 1e-10);
}

// The round-off of what is large is no soft spring, also where images are exact.
TEST(CorrectionSpace, LeavesOutTheRoundOffOfWhatIsLarge) {
  const Metric m;
  const CorrectionSpace space = scaledSpace(m, {5e3, 1e-7, 1e-4}, substructure::Precision::exact);
  EXPECT_NEAR(space.smallestSingularValue(), 1e-4, 1e-10);
}

TEST(CorrectionSpace, TakesANewTangent) {
  const Metric m;
  CorrectionSpace space = scaledSpace(m, {1.0, 1.0});
  space.forgetTangent();
  space.append(timesDirections(m, space, 0, {0.25, 0.25}));
  EXPECT_NEAR(space.solve(space.direction(1)).c[1], 4.0, 1e-12);
  EXPECT_NEAR(space.smallestSingularValue(), 0.25, 1e-12);
}

// Columns that come together may hardly differ from each other and from those before them: what differs is not lost, as
// it would be in a basis that is no longer orthogonal.
TEST(CorrectionSpace, TakesNearlyEqualColumnsTogether) {
  const Metric m;
  constexpr double difference = 1e-9;
  CorrectionSpace space = scaledSpace(m, std::vector<double>(6, 1.0), substructure::Precision::exact);
  base::Matrix g = timesDirections(m, space, 0, {1.0, difference, difference, difference, difference, difference});
  for (int j = 1; j < 6; ++j) {
    for (int row = 0; row < m.rows; ++row) g[j][row] += g[0][row];
  }
  space.forgetTangent();
  space.append(base::Matrix(Teuchos::View, g, m.rows, 2));
  space.append(base::Matrix(Teuchos::View, g, m.rows, 4, 0, 2));
  std::vector<double> residual(m.rows);
  const std::vector<double> wanted{1.0, -2.0, 3.0, 0.5, -0.25, 4.0};
  for (int row = 0; row < m.rows; ++row) {
    for (int j = 0; j < 6; ++j) residual[row] += wanted[j] * g[j][row];
  }
  const CorrectionSpace::LeastSquares found = space.solve(residual.data());
  for (std::size_t j = 0; j < 6; ++j) EXPECT_NEAR(found.c[j], wanted[j], 3e-6) << j;  // round-off over the difference
  EXPECT_NEAR(found.left, 0.0, 1e-14);
  // That of the matrix with a first row of ones, then 0 and the difference on the diagonal.
  EXPECT_NEAR(space.smallestSingularValue(), difference / std::sqrt(6.0), 1e-12);
}

TEST(CorrectionSpace, IsTheSameAfterItsBasisWasLetGo) {
  const Metric m;
  CorrectionSpace space = scaledSpace(m, {0.5, 2.0});
  std::vector<double> residual(m.rows, 1.0);
  const CorrectionSpace::LeastSquares before = space.solve(residual.data());
  space.releaseBasis();
  EXPECT_TRUE(space.isReleased());
  EXPECT_NEAR(space.smallestSingularValue(), 0.5, 1e-12);
  space.forgetTangent();
  space.append(timesDirections(m, space, 0, {0.5, 2.0}));
  EXPECT_FALSE(space.isReleased());
  const CorrectionSpace::LeastSquares after = space.solve(residual.data());
  for (std::size_t j = 0; j < 2; ++j) EXPECT_NEAR(after.c[j], before.c[j], 1e-14) << j;
  EXPECT_NEAR(after.left, before.left, 1e-14);
}

TEST(CorrectionSpace, BeginsEmpty) {
  const Metric m;
  const CorrectionSpace space(m.metric);
  EXPECT_EQ(space.size(), 0);
  EXPECT_EQ(space.smallestSingularValue(), 1.0);
  const std::vector<double> residual(m.rows, 1.0);
  EXPECT_NEAR(space.solve(residual.data()).left, std::sqrt(m.dot(residual.data(), residual.data())), 1e-14);
}

}  // namespace
}  // namespace harmos::latin
