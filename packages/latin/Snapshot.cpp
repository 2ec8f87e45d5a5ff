#include <harmos/latin/Snapshot.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/latin/NodalForces.hpp>

namespace harmos::latin {
namespace {

/// The rows of `field`, and below them sqrt(area) times those of a field of eliminated boundaries.
base::Matrix withBoundaries(const base::Matrix& field, const base::Matrix& ofBoundaries,
                            const std::vector<double>& area) {
  base::Matrix all(field.numRows() + ofBoundaries.numRows(), field.numCols());
  for (int t = 0; t < field.numCols(); ++t) {
    double* below = std::copy_n(field[t], field.numRows(), all[t]);
    for (int row = 0; row < ofBoundaries.numRows(); ++row) below[row] = std::sqrt(area[row]) * ofBoundaries[t][row];
  }
  return all;
}

base::Matrix scaledTrace(const Iterate& state) {
  base::Matrix trace(state.trace());
  for (int t = 0; t < trace.numCols(); ++t) {
    for (int row = 0; row < trace.numRows(); ++row) {
      trace[t][row] *= std::sqrt(state.layout().area()[row]);
    }
  }
  return withBoundaries(trace, state.boundaryFields().trace, state.boundaryFields().area);
}

/// Largest over the columns of |a - b|, relative to the largest |a|, whose square counts as at least `floor`.
double fieldDistance(const base::Matrix& a, const base::Matrix& b, double floor, const StateMetric& metric) {
  const auto steps = static_cast<std::size_t>(a.numCols());
  std::vector<double> sums(2 * steps, 0.0);  // squares of a, then of the difference
  for (std::size_t t = 0; t < steps; ++t) {
    const double* x = a[static_cast<int>(t)];
    const double* y = b[static_cast<int>(t)];
    for (int row = 0; row < a.numRows(); ++row) {
      sums[t] += x[row] * x[row];
      sums[steps + t] += (x[row] - y[row]) * (x[row] - y[row]);
    }
  }
  metric.sum(sums);
  const auto middle = sums.begin() + static_cast<std::ptrdiff_t>(steps);
  const double size = std::max(floor, *std::max_element(sums.begin(), middle));
  const double difference = *std::max_element(middle, sums.end());
  return difference == 0.0 ? 0.0 : std::sqrt(difference / size);
}

}  // namespace

Snapshot::Snapshot(const Iterate& state, const std::vector<std::shared_ptr<const Response>>& responses)
    : metric_(&state.metric()),
      sizes_(state),
      force_(withBoundaries(nodalForces(state.layout(), state.hattedTraction()), state.boundaryFields().traction,
                            state.boundaryFields().area)),
      displacement_(scaledTrace(state)) {
  for (const auto& response : responses) {
    responses_.push_back(response->evaluate(state));
    const std::vector<double>& values = responses_.back();
    const auto wrong = std::find_if_not(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
    if (wrong != values.end()) {
      throw base::Error("response \"" + response->name() + "\", load step " +
                            std::to_string(wrong - values.begin() + 1) + ": the value is not finite (NaN or infinity)",
                        base::ExitCode::notConverged);
    }
    floors_.push_back(sizes_.floor(*response));
  }
}

double Snapshot::size(std::size_t response) const {
  double size = floors_[response];
  for (const double value : responses_[response]) size = std::max(size, std::abs(value));
  return size;
}

std::vector<double> Snapshot::distance(const Snapshot& other) const {
  std::vector<double> result;
  for (std::size_t i = 0; i < responses_.size(); ++i) {
    double difference = 0.0;
    for (std::size_t t = 0; t < responses_[i].size(); ++t) {
      difference = std::max(difference, std::abs(responses_[i][t] - other.responses_[i][t]));
    }
    result.push_back(difference == 0.0 ? 0.0 : difference / size(i));
  }
  result.push_back(fieldDistance(force_, other.force_, sizes_.squaredForceFloor(), *metric_));
  result.push_back(fieldDistance(displacement_, other.displacement_, sizes_.squaredDisplacementFloor(), *metric_));
  return result;
}

}  // namespace harmos::latin
