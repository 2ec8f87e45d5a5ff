#pragma once

#include <vector>

#include <harmos/mesh/TraceOperator.hpp>

namespace harmos::latin {

/// The same operator, but no selection any more: every point feels another of its nodes as well, by nothing.
inline mesh::TraceOperator unselected(const mesh::TraceOperator& selection) {
  mesh::TraceOperator same;
  for (int p = 0; p < selection.points(); ++p) {
    const int node = selection.node(p), other = node > 0 ? node - 1 : 1;
    same.append({{node, 1.0}, {other, 0.0}});
  }
  return same;
}

/// Every point feels the mean of all nodes for a quarter.
inline mesh::TraceOperator smoothed(const mesh::TraceOperator& selection) {
  mesh::TraceOperator smooth;
  for (int p = 0; p < selection.points(); ++p) {
    std::vector<mesh::TraceOperator::Entry> row;
    for (int q = 0; q < selection.points(); ++q) {
      row.push_back({selection.node(q), 0.25 / selection.points() + (p == q ? 0.75 : 0.0)});
    }
    smooth.append(row);
  }
  return smooth;
}

/// One point that feels the mean of all nodes, weighted by these areas.
inline mesh::TraceOperator meanOf(const mesh::TraceOperator& selection, const std::vector<double>& area) {
  double total = 0.0;
  for (const double one : area) total += one;
  std::vector<mesh::TraceOperator::Entry> row;
  for (int p = 0; p < selection.points(); ++p) {
    row.push_back({selection.node(p), area[static_cast<std::size_t>(p)] / total});
  }
  mesh::TraceOperator mean;
  mean.append(row);
  return mean;
}

}  // namespace harmos::latin
