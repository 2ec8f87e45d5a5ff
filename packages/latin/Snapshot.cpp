#include <harmos/latin/Snapshot.hpp>

#include <algorithm>
#include <cmath>

#include <Teuchos_CommHelpers.hpp>

namespace harmos::latin {
namespace {

/// Relative sizes below which a response counts as zero of its kind.
constexpr double smallShare = 1e-3;

/// Largest displacement component and, over the load steps, largest sum of the force components' absolute values.
std::pair<double, double> naturalSizes(const FixedPoint& state) {
  double displacement = 0.0;
  std::vector<double> forces(static_cast<std::size_t>(state.assembly().steps()), 0.0);
  const std::vector<double>& area = state.layout().area();
  for (int t = 0; t < state.assembly().steps(); ++t) {
    for (std::size_t row = 0; row < area.size(); ++row) {
      displacement = std::max(displacement, std::abs(state.trace()[t][row]));
      forces[static_cast<std::size_t>(t)] += area[row] * std::abs(state.hattedTraction()[t][row]);
    }
  }
  state.metric().sum(forces);
  double all = 0.0;
  Teuchos::reduceAll(state.layout().comm(), Teuchos::REDUCE_MAX, displacement, Teuchos::outArg(all));
  return {all, *std::max_element(forces.begin(), forces.end())};
}

}  // namespace

Snapshot::Snapshot(const FixedPoint& state, const std::vector<std::shared_ptr<const Response>>& responses)
    : state_(&state), force_(state.hattedTraction()), displacement_(state.trace()) {
  const auto [displacement, force] = naturalSizes(state);
  for (const auto& response : responses) {
    responses_.push_back(response->evaluate(state));
    const bool kinematic = response->quantity() == Quantity::displacement;
    const bool dynamic = response->quantity() == Quantity::force;
    floors_.push_back(smallShare * (kinematic ? displacement : dynamic ? force : 0.0));
  }
}

std::vector<double> Snapshot::distance(const Snapshot& other) const {
  std::vector<double> result;
  for (std::size_t i = 0; i < responses_.size(); ++i) {
    double size = floors_[i];
    double difference = 0.0;
    for (std::size_t t = 0; t < responses_[i].size(); ++t) {
      size = std::max(size, std::abs(responses_[i][t]));
      difference = std::max(difference, std::abs(responses_[i][t] - other.responses_[i][t]));
    }
    result.push_back(difference == 0.0 ? 0.0 : difference / size);
  }
  result.push_back(fieldDistance(force_, other.force_));
  result.push_back(fieldDistance(displacement_, other.displacement_));
  return result;
}

double Snapshot::fieldDistance(const base::Matrix& a, const base::Matrix& b) const {
  const std::vector<double>& area = state_->layout().area();
  const auto steps = static_cast<std::size_t>(a.numCols());
  std::vector<double> sums(2 * steps, 0.0);  // squares of a, then of the difference
  for (std::size_t t = 0; t < steps; ++t) {
    const double* x = a[static_cast<int>(t)];
    const double* y = b[static_cast<int>(t)];
    for (std::size_t row = 0; row < area.size(); ++row) {
      sums[t] += area[row] * x[row] * x[row];
      sums[steps + t] += area[row] * (x[row] - y[row]) * (x[row] - y[row]);
    }
  }
  state_->metric().sum(sums);
  const double size = *std::max_element(sums.begin(), sums.begin() + static_cast<std::ptrdiff_t>(steps));
  const double difference = *std::max_element(sums.begin() + static_cast<std::ptrdiff_t>(steps), sums.end());
  return difference == 0.0 ? 0.0 : std::sqrt(difference / size);
}

}  // namespace harmos::latin
