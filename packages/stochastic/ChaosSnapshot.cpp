#include <harmos/stochastic/ChaosSnapshot.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/latin/NodalForces.hpp>
#include <harmos/stochastic/StochasticResult.hpp>

namespace harmos::stochastic {
namespace {

/// The modal columns of each load step below each other.
base::Matrix stacked(const base::Matrix& columns, int terms) {
  return base::Matrix(Teuchos::Copy, columns.values(), columns.stride() * terms, columns.stride() * terms,
                      columns.numCols() / terms);
}

}  // namespace

ChaosSnapshot::ChaosSnapshot(const latin::Iterate& state, const ResponseSampler& sampler,
                             const std::vector<std::shared_ptr<const latin::Response>>& responses, int terms)
    : metric_(state.metric()), terms_(terms) {
  const latin::NaturalSizes sizes(state);
  for (std::size_t i = 0; i < responses.size(); ++i) {
    quantities_.push_back({sampler.coefficients(static_cast<int>(i)), sizes.floor(*responses[i]), false});
  }
  base::Matrix trace(state.trace());
  for (int j = 0; j < trace.numCols(); ++j) {
    for (int row = 0; row < trace.numRows(); ++row) {
      trace[j][row] *= std::sqrt(state.layout().area()[row]);
    }
  }
  quantities_.push_back({stacked(latin::nodalForces(state.layout(), state.hattedTraction()), terms),
                         std::sqrt(sizes.squaredForceFloor()), true});
  quantities_.push_back({stacked(trace, terms), std::sqrt(sizes.squaredDisplacementFloor()), true});
}

double ChaosSnapshot::distance(const Quantity& mine, const Quantity& other) const {
  const int steps = mine.coefficients.numCols();
  const int rows = mine.coefficients.numRows() / terms_;
  const auto count = static_cast<std::size_t>(steps);
  // Squares per load step: of the mean, of the random part, and of the differences of both.
  std::vector<double> sums(4 * count, 0.0);
  for (int t = 0; t < steps; ++t) {
    for (int row = 0; row < mine.coefficients.numRows(); ++row) {
      const std::size_t part = (row < rows ? 0 : count) + static_cast<std::size_t>(t);
      const double value = mine.coefficients[t][row];
      const double difference = value - other.coefficients[t][row];
      sums[part] += value * value;
      sums[2 * count + part] += difference * difference;
    }
  }
  if (mine.isDistributed) metric_.sum(sums);
  const auto largest = [&](std::size_t part) {
    const auto from = sums.begin() + static_cast<std::ptrdiff_t>(part * count);
    return std::sqrt(*std::max_element(from, from + static_cast<std::ptrdiff_t>(count)));
  };
  const double mean = std::max(largest(0), mine.floor);
  const double spread = std::max(largest(1), smallestSpread * mean);
  const auto relative = [](double difference, double size) { return difference == 0.0 ? 0.0 : difference / size; };
  return std::max(relative(largest(2), mean), relative(largest(3), spread));
}

std::vector<double> ChaosSnapshot::distance(const ChaosSnapshot& other) const {
  std::vector<double> result;
  for (std::size_t i = 0; i < quantities_.size(); ++i) {
    result.push_back(distance(quantities_[i], other.quantities_[i]));
  }
  return result;
}

}  // namespace harmos::stochastic
