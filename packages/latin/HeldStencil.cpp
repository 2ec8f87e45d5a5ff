#include <harmos/latin/detail/HeldStencil.hpp>

#include <algorithm>

namespace harmos::latin {
namespace {

// Columns solved together: enough to read the factors seldom.
constexpr int columnsAtOnce = 64;

/// The trace of S^-1 P of these columns, kept from column `first` of `to` on.
void keepTraces(const ConstrainedOperator& constrained, const substructure::SubstructureSolver& solver,
                base::Matrix& columns, int first, base::Matrix& to) {
  base::Matrix solution;
  constrained.project(columns);
  solver.solve(columns, solution);
  constrained.project(solution);
  const std::vector<int>& trace = constrained.trace();
  for (int j = 0; j < solution.numCols(); ++j) {
    for (std::size_t row = 0; row < trace.size(); ++row) to[first + j][row] = solution[j][trace[row]];
  }
}

/// Adds the rows of `by`^T f to these rows of `to`.
void addProduct(const base::Matrix& by, const base::Matrix& f, const std::vector<int>& rows, base::Matrix& to) {
  if (rows.empty()) return;
  base::Matrix product(by.numCols(), f.numCols());
  product.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, by, f, 0.0);
  for (int j = 0; j < f.numCols(); ++j) {
    for (std::size_t i = 0; i < rows.size(); ++i) to[j][rows[i]] += product[j][i];
  }
}

}  // namespace

HeldStencil::HeldStencil(const ConstrainedOperator& constrained) : operator_(constrained) {
  const auto dimension = static_cast<std::size_t>(operator_.term().dimension);
  int place = 0;
  for (const substructure::BoundaryTerm::NodeTensor& held : operator_.term().free) {
    for (std::size_t c = 0; c < dimension; ++c, ++place) {
      base::Vector3 axis{};
      axis[c] = 1.0;
      if (base::product(held.value, axis) != axis) reacting_.push_back(place);
      if (base::product(held.value, axis) != base::Vector3{}) moving_.push_back(place);
    }
  }
}

void HeldStencil::prepare(const substructure::SubstructureSolver& solver) {
  if (reactions_.numCols() + motions_.numCols() == solves()) return;
  const auto rows = static_cast<int>(operator_.trace().size());
  const std::vector<int>& held = operator_.heldDofs();
  // S and A are symmetric: rows of N A S^-1 and of N S^-1 are solutions for columns of A and of 1.
  for (const bool isReaction : {true, false}) {
    const std::vector<int>& places = isReaction ? reacting_ : moving_;
    const auto count = static_cast<int>(places.size());
    base::Matrix& to = isReaction ? reactions_ : motions_;
    to.shapeUninitialized(rows, count);
    for (int first = 0; first < count; first += columnsAtOnce) {
      std::vector<int> dofs;
      for (int j = first; j < std::min(first + columnsAtOnce, count); ++j) dofs.push_back(held[places[j]]);
      base::Matrix columns(solver.dofs(), static_cast<int>(dofs.size()));
      if (isReaction) {
        operator_.addColumns(dofs, columns);
      } else {
        for (std::size_t j = 0; j < dofs.size(); ++j) columns[static_cast<int>(j)][dofs[j]] = 1.0;
      }
      keepTraces(operator_, solver, columns, first, to);
    }
  }
}

void HeldStencil::add(const base::Matrix& forces, base::Matrix& reactions, base::Matrix& motions) const {
  addProduct(reactions_, forces, reacting_, reactions);
  addProduct(motions_, forces, moving_, motions);
}

}  // namespace harmos::latin
