#include <harmos/latin/detail/HeldStencil.hpp>

#include <algorithm>
#include <set>

namespace harmos::latin {
namespace {

// Columns solved together: enough to read the factors seldom.
constexpr int columnsAtOnce = 64;

}  // namespace

HeldStencil::HeldStencil(const substructure::CrsView& stiffness, const substructure::BoundaryTerm& term,
                         const std::vector<int>& trace)
    : trace_(trace) {
  std::set<int> held, all;
  const auto addNode = [&](std::set<int>& dofs, int node) {
    for (int c = 0; c < term.dimension; ++c) dofs.insert(node * term.dimension + c);
  };
  for (const substructure::BoundaryTerm::NodeTensor& one : term.free) addNode(held, one.node);
  all = held;
  for (const int row : held) {
    for (std::size_t k = stiffness.rowPointers[row]; k < stiffness.rowPointers[row + 1]; ++k) {
      addNode(all, stiffness.columns[k] / term.dimension);
    }
  }
  for (const substructure::MatrixEntry& entry : term.entries) {
    if (held.count(entry.row * term.dimension) > 0) addNode(all, entry.column);
  }
  dofs_.assign(all.begin(), all.end());
}

int HeldStencil::rowOf(int dof) const {
  const auto at = std::lower_bound(dofs_.begin(), dofs_.end(), dof);
  return at != dofs_.end() && *at == dof ? static_cast<int>(at - dofs_.begin()) : -1;
}

void HeldStencil::prepare(const substructure::SubstructureSolver& solver,
                          const std::function<void(base::Matrix&)>& project) {
  const int count = static_cast<int>(dofs_.size());
  if (motions_.numCols() == count) return;
  motions_.shapeUninitialized(static_cast<int>(trace_.size()), count);
  base::Matrix unit, solution;
  for (int first = 0; first < count; first += columnsAtOnce) {
    const int columns = std::min(columnsAtOnce, count - first);
    unit.shape(solver.dofs(), columns);
    for (int j = 0; j < columns; ++j) unit[j][dofs_[first + j]] = 1.0;
    solver.solve(unit, solution);
    project(solution);
    for (int j = 0; j < columns; ++j) {
      for (std::size_t row = 0; row < trace_.size(); ++row) motions_[first + j][row] = solution[j][trace_[row]];
    }
  }
}

void HeldStencil::move(const base::Matrix& forces, base::Matrix& u) const {
  u.shapeUninitialized(motions_.numCols(), forces.numCols());
  u.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, motions_, forces, 0.0);
}

}  // namespace harmos::latin
