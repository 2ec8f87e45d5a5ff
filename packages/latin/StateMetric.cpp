#include <harmos/latin/StateMetric.hpp>

#include <cmath>

#include <Teuchos_CommHelpers.hpp>

namespace harmos::latin {

StateMetric::StateMetric(const TraceLayout& layout, int copies) : layout_(&layout) {
  for (int copy = 0; copy < copies; ++copy) {
    for (std::size_t row = 0; row < layout.area().size(); ++row) {
      scale_.push_back(std::sqrt(layout.area()[row] / layout.stiffness()[row]));
    }
  }
}

void StateMetric::sum(std::vector<double>& values) const {
  if (layout_->comm().getSize() == 1) return;
  const std::vector<double> local = values;
  Teuchos::reduceAll(layout_->comm(), Teuchos::REDUCE_SUM, static_cast<int>(local.size()), local.data(), values.data());
}

std::vector<double> StateMetric::squaredNorms(const base::Matrix& a) const {
  std::vector<double> result(a.numCols(), 0.0);
  for (int t = 0; t < a.numCols(); ++t) {
    for (std::size_t row = 0; row < scale_.size(); ++row) {
      const double x = scale_[row] * a[t][row];
      result[t] += x * x;
    }
  }
  sum(result);
  return result;
}

double StateMetric::dot(const base::Matrix& a, const base::Matrix& b) const {
  std::vector<double> result{0.0};
  for (int t = 0; t < a.numCols(); ++t) {
    for (std::size_t row = 0; row < scale_.size(); ++row)
      result[0] += scale_[row] * scale_[row] * a[t][row] * b[t][row];
  }
  sum(result);
  return result[0];
}

double StateMetric::norm(const base::Matrix& a) const {
  return std::sqrt(dot(a, a));
}

double StateMetric::distance(const base::Matrix& a, const base::Matrix& b) const {
  std::vector<double> result{0.0};
  for (int t = 0; t < a.numCols(); ++t) {
    for (std::size_t row = 0; row < scale_.size(); ++row) {
      const double difference = a[t][row] - b[t][row];
      result[0] += scale_[row] * scale_[row] * difference * difference;
    }
  }
  sum(result);
  return std::sqrt(result[0]);
}

}  // namespace harmos::latin
