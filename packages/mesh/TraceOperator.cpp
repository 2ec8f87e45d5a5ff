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

}  // namespace harmos::mesh
