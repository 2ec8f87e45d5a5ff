#include <algorithm>
#include <random>

#include <harmos/latin/detail/ImageNoise.hpp>

namespace harmos::latin {
namespace {

constexpr int draws = 3;
// Of the largest draw: load steps are many, and the largest residual of all is compared.
constexpr double safety = 2.0;
// Of a state, that it is moved along itself.
constexpr double shareOfState = 2.0 / 7.0;

}  // namespace

double noiseOfImages(FixedPoint& fixedPoint, const base::Matrix& state) {
  const StateMetric& metric = fixedPoint.metric();
  const int rows = state.numRows();
  base::Matrix image(rows, 1), way(rows, 1), moved(rows, 1), there(rows, 1);
  fixedPoint.solveLinear(state, image);
  std::mt19937 random(static_cast<unsigned>(fixedPoint.layout().comm().getRank()) + 1U);
  double largest = 0.0;
  for (int draw = 0; draw < draws; ++draw) {
    for (int row = 0; row < rows; ++row) way(row, 0) = static_cast<double>(random()) / 2147483648.0 - 1.0;
    const double size = metric.norm(way);
    way.scale(size > 0.0 ? metric.norm(state) / size : 0.0);
    base::Matrix left(image);
    left.scale(-2.0);
    for (const double sign : {1.0, -1.0}) {
      for (int row = 0; row < rows; ++row) moved(row, 0) = state(row, 0) + sign * way(row, 0);
      fixedPoint.solveLinear(moved, there);
      left += there;
    }
    largest = std::max(largest, metric.norm(left));
  }
  return safety * largest;
}

base::Matrix noiseAlong(FixedPoint& fixedPoint, const base::Matrix& alpha, const base::Matrix& beta) {
  const std::vector<double> squares = fixedPoint.metric().squaredNorms(alpha);
  const auto step = static_cast<int>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const FixedPoint::AllStepsAtEnd restore(fixedPoint);
  fixedPoint.select({step});
  const int rows = alpha.numRows();
  base::Matrix moved(rows, 1), there(rows, 1), noise(rows, 1);
  for (int row = 0; row < rows; ++row) noise(row, 0) = -2.0 * beta[step][row];
  for (const double factor : {1.0 + shareOfState, 1.0 - shareOfState}) {
    for (int row = 0; row < rows; ++row) moved(row, 0) = factor * alpha[step][row];
    fixedPoint.solveLinear(moved, there);
    noise += there;
  }
  noise.scale(safety);
  return noise;
}

}  // namespace harmos::latin
