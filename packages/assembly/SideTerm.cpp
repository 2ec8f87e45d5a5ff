#include <harmos/assembly/SideTerm.hpp>

namespace harmos::assembly {

void addSideTerm(const Interface& interface, int side, const std::vector<double>& k, const std::vector<int>& numbers,
                 substructure::BoundaryTerm& term) {
  const mesh::TraceOperator& trace = interface.trace(side);
  const auto numberOf = [&](int node) { return numbers.empty() ? node : numbers[node]; };
  const auto add = [&](int p, int q, double value) {
    for (const auto& [row, rowWeight] : trace.row(p)) {
      for (const auto& [column, columnWeight] : trace.row(q))
        term.entries.push_back({numberOf(row), numberOf(column), rowWeight * columnWeight * value});
    }
  };
  for (const mesh::MassEntry& entry : interface.mass) add(entry.row, entry.column, k[entry.row] * entry.value);
  for (int p = 0; p < interface.pairs() && interface.mass.empty(); ++p) {
    if (!trace.isSelection()) {
      add(p, p, k[p] * interface.area[p]);
      continue;
    }
    const int first = numberOf(trace.node(p)) * term.dimension;
    for (int c = 0; c < term.dimension; ++c) term.diagonal[first + c] += k[p] * interface.area[p];
  }
}

}  // namespace harmos::assembly
