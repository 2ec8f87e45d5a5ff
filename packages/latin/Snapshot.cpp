#include <harmos/latin/Snapshot.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/latin/NodalForces.hpp>
#include <harmos/latin/StepsAtOnce.hpp>

namespace harmos::latin {
namespace {

base::Matrix columnsOf(const base::Matrix& field, int first, int count) {
  return {Teuchos::View, field, field.numRows(), count, 0, first};
}

/// Puts columns of a field from number `first` on, and below them sqrt(area) times those of eliminated boundaries.
void keep(const base::Matrix& columns, int first, const base::Matrix& ofBoundaries, const std::vector<double>& area,
          base::ColumnStore& all) {
  std::vector<double> column(static_cast<std::size_t>(all.rows()));
  for (int j = 0; j < columns.numCols(); ++j) {
    auto below = std::copy_n(columns[j], columns.numRows(), column.begin());
    for (int row = 0; row < ofBoundaries.numRows(); ++row)
      *below++ = std::sqrt(area[row]) * ofBoundaries[first + j][row];
    all.write(first + j, column.data());
  }
}

base::ColumnStore forcesOf(const Iterate& state) {
  const BoundaryFields& boundaries = state.boundaryFields();
  const base::Matrix& traction = state.hattedTraction();
  const int ofNodes = nodalForces(state.layout(), columnsOf(traction, 0, 0)).numRows();
  base::ColumnStore all = state.store(ofNodes + boundaries.traction.numRows());
  for (int first = 0; first < traction.numCols(); first += stepsAtOnce) {
    const int count = std::min(stepsAtOnce, traction.numCols() - first);
    keep(nodalForces(state.layout(), columnsOf(traction, first, count)), first, boundaries.traction, boundaries.area,
         all);
  }
  return all;
}

base::ColumnStore displacementsOf(const Iterate& state) {
  const BoundaryFields& boundaries = state.boundaryFields();
  const std::vector<double>& area = state.layout().area();
  const base::Matrix& trace = state.trace();
  base::ColumnStore all = state.store(trace.numRows() + boundaries.trace.numRows());
  base::Matrix scaled(trace.numRows(), 1);
  for (int t = 0; t < trace.numCols(); ++t) {
    for (int row = 0; row < trace.numRows(); ++row) scaled(row, 0) = trace[t][row] * std::sqrt(area[row]);
    keep(scaled, t, boundaries.trace, boundaries.area, all);
  }
  return all;
}

/// Largest over the columns of factor |a - b|, relative to the largest |a|, whose square counts as at least `floor`.
double fieldDistance(const base::ColumnStore& a, const base::ColumnStore& b, const std::vector<double>& factors,
                     double floor, const StateMetric& metric) {
  const auto steps = static_cast<std::size_t>(a.columns());
  std::vector<double> sums(2 * steps, 0.0);  // squares of a, then of the difference
  for (std::size_t t = 0; t < steps; ++t) {
    const double* x = a.read(static_cast<int>(t));
    const double* y = b.read(static_cast<int>(t));
    for (int row = 0; row < a.rows(); ++row) {
      sums[t] += x[row] * x[row];
      sums[steps + t] += (x[row] - y[row]) * (x[row] - y[row]);
    }
  }
  metric.sum(sums);
  const auto middle = sums.begin() + static_cast<std::ptrdiff_t>(steps);
  const double size = std::max(floor, *std::max_element(sums.begin(), middle));
  for (std::size_t t = 0; t < steps; ++t) sums[steps + t] *= factors[t] * factors[t];
  const double difference = *std::max_element(middle, sums.end());
  return difference == 0.0 ? 0.0 : std::sqrt(difference / size);
}

}  // namespace

Snapshot::Snapshot(const Iterate& state, const std::vector<std::shared_ptr<const Response>>& responses)
    : metric_(&state.metric()), sizes_(state), force_(forcesOf(state)), displacement_(displacementsOf(state)) {
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

std::vector<double> Snapshot::distance(const Snapshot& other, const std::vector<double>& factors) const {
  const auto steps = static_cast<std::size_t>(force_.columns());
  const std::vector<double> weights = factors.empty() ? std::vector<double>(steps, 1.0) : factors;
  std::vector<double> result;
  for (std::size_t i = 0; i < responses_.size(); ++i) {
    double difference = 0.0;
    for (std::size_t t = 0; t < responses_[i].size(); ++t) {
      difference = std::max(difference, weights[t] * std::abs(responses_[i][t] - other.responses_[i][t]));
    }
    result.push_back(difference == 0.0 ? 0.0 : difference / size(i));
  }
  result.push_back(fieldDistance(force_, other.force_, weights, sizes_.squaredForceFloor(), *metric_));
  result.push_back(
      fieldDistance(displacement_, other.displacement_, weights, sizes_.squaredDisplacementFloor(), *metric_));
  return result;
}

}  // namespace harmos::latin
