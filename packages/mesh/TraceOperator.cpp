#include <harmos/mesh/TraceOperator.hpp>

namespace harmos::mesh {

TraceOperator::TraceOperator(const std::vector<int>& nodes) {
  for (const int node : nodes) append({{node, 1.0}});
}

void TraceOperator::append(const std::vector<Entry>& row) {
  entries_.insert(entries_.end(), row.begin(), row.end());
  pointers_.push_back(entries_.size());
  isSelection_ = isSelection_ && row.size() == 1 && row.front().weight == 1.0;
}

base::Vector3 TraceOperator::at(int p, const std::vector<base::Vector3>& x) const {
  base::Vector3 value{};
  for (const Entry& entry : row(p)) value = value + entry.weight * x[entry.node];
  return value;
}

void TraceOperator::addProduct(int dimension, const double* x, double* y) const {
  for (int p = 0; p < points(); ++p, y += dimension) {
    for (const Entry& entry : row(p)) {
      for (int c = 0; c < dimension; ++c) y[c] += entry.weight * x[entry.node * dimension + c];
    }
  }
}

void TraceOperator::addTransposed(int dimension, const double* x, double* y) const {
  for (int p = 0; p < points(); ++p, x += dimension) {
    for (const Entry& entry : row(p)) {
      for (int c = 0; c < dimension; ++c) y[entry.node * dimension + c] += entry.weight * x[c];
    }
  }
}

}  // namespace harmos::mesh
