#include <algorithm>
#include <tuple>

#include <harmos/latin/detail/BodyTerm.hpp>

namespace harmos::latin {
namespace {

/// Neighbouring points feel the same nodes. Of entries that are sorted.
void addUpRepeated(std::vector<substructure::BoundaryTerm::NodeEntry>& entries) {
  std::size_t kept = 0;
  for (std::size_t i = 1; i < entries.size(); ++i) {
    if (entries[i].row == entries[kept].row && entries[i].column == entries[kept].column) {
      entries[kept].value += entries[i].value;
    } else {
      entries[++kept] = entries[i];
    }
  }
  if (!entries.empty()) entries.resize(kept + 1);
}

}  // namespace

substructure::BoundaryTerm bodyTerm(const assembly::Assembly& assembly,
                                    const assembly::SearchDirection& searchDirection,
                                    const EliminatedBoundaries& eliminated, int body, const std::vector<int>& toMaster,
                                    const base::Frame* rotation) {
  const int dimension = assembly.dimension;
  substructure::BoundaryTerm term;
  term.dimension = dimension;
  term.diagonal.assign(assembly.bodies[body].nodes.size() * static_cast<std::size_t>(dimension), 0.0);
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (interface.law->prescribesTraction() || eliminated.contains(static_cast<int>(i))) continue;
    const std::vector<double>& k = searchDirection.of(static_cast<int>(i));
    for (int side = 0; side < interface.sides(); ++side) {
      if (interface.body(side) != body) continue;
      const mesh::TraceOperator& trace = interface.trace(side);
      const auto numberOf = [&](int node) { return toMaster.empty() ? node : toMaster[node]; };
      const auto add = [&](int p, int q, double value) {
        for (const auto& [row, rowWeight] : trace.row(p)) {
          for (const auto& [column, columnWeight] : trace.row(q)) {
            term.entries.push_back({numberOf(row), numberOf(column), rowWeight * columnWeight * value});
          }
        }
      };
      for (const mesh::MassEntry& entry : interface.mass) add(entry.row, entry.column, k[entry.row] * entry.value);
      for (int p = 0; p < interface.pairs() && interface.mass.empty(); ++p) {
        if (!trace.isSelection()) {
          add(p, p, k[p] * interface.area[p]);
          continue;
        }
        for (int c = 0; c < dimension; ++c) {
          const int dof = numberOf(trace.node(p)) * dimension + c;
          term.diagonal[dof] += k[p] * interface.area[p];
        }
      }
    }
  }
  // Congruent bodies list their interfaces' nodes in other orders.
  std::sort(term.entries.begin(), term.entries.end(), [](const auto& a, const auto& b) {
    return std::tie(a.row, a.column, a.value) < std::tie(b.row, b.column, b.value);
  });
  addUpRepeated(term.entries);
  for (const EliminatedBoundaries::Node& node : eliminated.nodes(body)) {
    const int number = toMaster.empty() ? node.node : toMaster[node.node];
    const auto turned = [&](const base::Tensor3& a) { return rotation ? base::turnedBack(*rotation, a) : a; };
    if (base::distance(node.springs, {}) > 0.0) term.springs.push_back({number, turned(node.springs)});
    if (node.isHeld) term.free.push_back({number, turned(node.free)});
  }
  for (auto* tensors : {&term.springs, &term.free}) {
    std::sort(tensors->begin(), tensors->end(), [](const auto& a, const auto& b) { return a.node < b.node; });
  }
  return term;
}

}  // namespace harmos::latin
