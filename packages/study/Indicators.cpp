#include <harmos/study/Indicators.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <harmos/latin/NaturalSizes.hpp>

namespace harmos::study {
namespace {

double forceIndicator(const latin::FixedPoint& state, const base::Matrix& alpha, const base::Matrix& image) {
  const std::vector<double>& scale = state.metric().scale();
  std::vector<double> sums(2, 0.0);
  for (int t = 0; t < alpha.numCols(); ++t) {
    for (std::size_t row = 0; row < scale.size(); ++row) {
      const double residual = scale[row] * (image[t][row] - alpha[t][row]);
      const double force = scale[row] * state.hattedTraction()[t][row];
      sums[0] += residual * residual;
      sums[1] += force * force;
    }
  }
  state.metric().sum(sums);
  if (sums[0] == 0.0) return 0.0;
  return sums[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) : 1.0;
}

/// Largest imbalance of a body, and largest resultant of an interface [force].
std::array<double, 2> resultants(const latin::FixedPoint& state) {
  const latin::TraceLayout& layout = state.layout();
  const auto steps = static_cast<std::size_t>(state.assembly().steps());
  const std::size_t bodies = state.assembly().bodies.size() * steps * 3;
  const std::size_t interfaces = state.assembly().interfaces.size() * steps * 3;
  std::vector<double> sums(bodies + interfaces, 0.0);
  const int dimension = layout.dimension();
  for (const latin::TraceLayout::Block& block : layout.blocks()) {
    for (std::size_t t = 0; t < steps; ++t) {
      const double* f = state.traction()[static_cast<int>(t)];
      const double* hatted = state.hattedTraction()[static_cast<int>(t)];
      double* imbalance = sums.data() + (static_cast<std::size_t>(block.body) * steps + t) * 3;
      double* resultant = sums.data() + bodies + (static_cast<std::size_t>(block.interface) * steps + t) * 3;
      for (int i = 0; i < block.pairs * dimension; ++i) {
        const int row = block.begin + i;
        const double area = layout.area()[static_cast<std::size_t>(row)];
        imbalance[i % dimension] += area * (hatted[row] - f[row]);
        if (block.side == 0) resultant[i % dimension] += area * hatted[row];
      }
    }
  }
  state.metric().sum(sums);
  std::array<double, 2> largest{};
  for (std::size_t i = 0; i < sums.size(); i += 3) {
    double& one = largest[i < bodies ? 0 : 1];
    one = std::max(one, std::hypot(sums[i], sums[i + 1], sums[i + 2]));
  }
  return largest;
}

}  // namespace

Indicators indicatorsOf(const latin::FixedPoint& state, const base::Matrix& alpha, const base::Matrix& image,
                        const std::vector<std::shared_ptr<const latin::Response>>& responses) {
  Indicators indicators;
  indicators.force = forceIndicator(state, alpha, image);
  const auto [imbalance, resultant] = resultants(state);
  const latin::NaturalSizes sizes(state);
  double size = resultant;
  for (const auto& response : responses) {
    if (response->quantity() != latin::Quantity::force) continue;
    double largest = sizes.floor(response->quantity());
    for (double value : response->evaluate(state)) largest = std::max(largest, std::abs(value));
    size = std::min(size, largest);
  }
  indicators.response = imbalance == 0.0 ? 0.0 : size > 0.0 ? imbalance / size : 1.0;
  return indicators;
}

}  // namespace harmos::study
