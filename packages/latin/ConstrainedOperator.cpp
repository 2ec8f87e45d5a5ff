#include <harmos/latin/detail/ConstrainedOperator.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include <harmos/substructure/CrsMatrix.hpp>
#include <harmos/substructure/TranslationForces.hpp>

namespace harmos::latin {
namespace {

/// The degrees of freedom, ascending, of the nodes at which a boundary term has search directions.
std::vector<int> traceOf(const substructure::BoundaryTerm& term) {
  std::set<int> nodes;
  for (std::size_t dof = 0; dof < term.diagonal.size(); ++dof) {
    if (term.diagonal[dof] != 0.0) nodes.insert(static_cast<int>(dof) / term.dimension);
  }
  for (const substructure::MatrixEntry& entry : term.entries) nodes.insert(entry.row);
  std::vector<int> dofs;
  for (const int node : nodes) {
    for (int c = 0; c < term.dimension; ++c) dofs.push_back(node * term.dimension + c);
  }
  return dofs;
}

/// 1 or -1, as if by chance.
double signOf(unsigned seed, std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U * (seed + std::uint64_t{1});
  // The finaliser of SplitMix64, Steele et al. (2014), doi:10.1145/2660193.2660195.
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return ((x ^ (x >> 31U)) & 1U) != 0U ? 1.0 : -1.0;
}

/// Two numbers as one, whatever their order.
std::uint64_t together(int one, int other) {
  return (static_cast<std::uint64_t>(std::min(one, other)) << 32U) | static_cast<unsigned>(std::max(one, other));
}

/// Of an entry by its place: symmetries of the part are not those of its round-off.
double signByPlace(unsigned seed, int row, int column) {
  return signOf(seed, together(row, column));
}

/// Of an entry by its components and, but for round-off, its value: the same for congruent elements.
double signByValue(unsigned seed, int row, int column, int dimension, double entry) {
  const auto value = static_cast<float>(entry);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return signOf(seed, together(row % dimension, column % dimension) * 0xd1342543de82ef95U + bits);
}

}  // namespace

ConstrainedOperator::ConstrainedOperator(Teuchos::RCP<const base::CrsMatrix> stiffness, substructure::BoundaryTerm term)
    : stiffness_(std::move(stiffness)), term_(std::move(term)), trace_(traceOf(term_)) {
  for (const substructure::BoundaryTerm::NodeTensor& held : term_.free) {
    for (int c = 0; c < term_.dimension; ++c) heldDofs_.push_back(held.node * term_.dimension + c);
  }
}

int ConstrainedOperator::placeOf(const std::vector<int>& dofs, int dof) {
  const auto at = std::lower_bound(dofs.begin(), dofs.end(), dof);
  return at != dofs.end() && *at == dof ? static_cast<int>(at - dofs.begin()) : -1;
}

int ConstrainedOperator::heldPlace(int node) const {
  const int row = heldRow(node * term_.dimension);
  return row < 0 ? -1 : row / term_.dimension;
}

void ConstrainedOperator::projectNode(const substructure::BoundaryTerm::NodeTensor& held, int row,
                                      base::Matrix& vectors) const {
  for (int j = 0; j < vectors.numCols(); ++j) {
    base::Vector3 old{};
    std::copy_n(vectors[j] + row, term_.dimension, old.begin());
    const base::Vector3 now = base::product(held.value, old);
    std::copy_n(now.begin(), term_.dimension, vectors[j] + row);
  }
}

void ConstrainedOperator::project(base::Matrix& vectors) const {
  for (const substructure::BoundaryTerm::NodeTensor& held : term_.free) {
    projectNode(held, held.node * term_.dimension, vectors);
  }
}

void ConstrainedOperator::projectTrace(base::Matrix& vectors) const {
  for (const substructure::BoundaryTerm::NodeTensor& held : term_.free) {
    const int row = traceRow(held.node * term_.dimension);
    if (row >= 0) projectNode(held, row, vectors);
  }
}

void ConstrainedOperator::multiply(const double* u, const std::vector<int>& rows, double* result) const {
  const substructure::CrsView view = substructure::viewOf(*stiffness_, "operator");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int row = rows[i];
    double sum = term_.diagonal.empty() ? 0.0 : term_.diagonal[row] * u[row];
    for (std::size_t k = view.rowPointers[row]; k < view.rowPointers[row + 1]; ++k) {
      sum += view.values[k] * u[view.columns[k]];
    }
    result[i] = sum;
  }
  for (const substructure::MatrixEntry& entry : term_.entries) {
    const int at = placeOf(rows, entry.row * term_.dimension);
    if (at < 0) continue;
    for (int c = 0; c < term_.dimension; ++c) {
      result[at + c] += entry.value * u[entry.column * term_.dimension + c];
    }
  }
  for (const substructure::BoundaryTerm::NodeTensor& spring : term_.springs) {
    const int first = spring.node * term_.dimension;
    const int at = placeOf(rows, first);
    if (at < 0) continue;
    base::Vector3 w{};
    std::copy_n(u + first, term_.dimension, w.begin());
    const base::Vector3 force = base::product(spring.value, w);
    for (int c = 0; c < term_.dimension; ++c) result[at + c] += force[c];
  }
}

void ConstrainedOperator::addColumns(const std::vector<int>& dofs, base::Matrix& to) const {
  const substructure::CrsView view = substructure::viewOf(*stiffness_, "operator");
  const int dimension = term_.dimension;
  for (std::size_t j = 0; j < dofs.size(); ++j) {
    const int dof = dofs[j];
    double* const column = to[static_cast<int>(j)];
    if (!term_.diagonal.empty()) column[dof] += term_.diagonal[dof];
    for (std::size_t k = view.rowPointers[dof]; k < view.rowPointers[dof + 1]; ++k) {
      column[view.columns[k]] += view.values[k];
    }
  }
  // Some components of a node may be missing among the columns.
  for (const substructure::MatrixEntry& entry : term_.entries) {
    for (int c = 0; c < dimension; ++c) {
      const int at = placeOf(dofs, entry.row * dimension + c);
      if (at >= 0) to[at][entry.column * dimension + c] += entry.value;
    }
  }
  for (const substructure::BoundaryTerm::NodeTensor& spring : term_.springs) {
    const int first = spring.node * dimension;
    for (int c = 0; c < dimension; ++c) {
      const int at = placeOf(dofs, first + c);
      if (at < 0) continue;
      for (int row = 0; row < dimension; ++row) to[at][first + row] += spring.value[row][c];
    }
  }
}

std::vector<double> ConstrainedOperator::diagonal() const {
  const substructure::CrsView view = substructure::viewOf(*stiffness_, "operator");
  std::vector<double> diagonal(term_.diagonal);
  diagonal.resize(static_cast<std::size_t>(view.rows), 0.0);
  for (int row = 0; row < view.rows; ++row) {
    const std::size_t at = view.positionOf(row, row);
    if (at != view.rowPointers[view.rows]) diagonal[row] += view.values[at];
  }
  return diagonal;
}

double ConstrainedOperator::stiffnessNorm() const {
  const std::vector<double> values = diagonal();
  return std::sqrt(std::inner_product(values.begin(), values.end(), values.begin(), 0.0));
}

void ConstrainedOperator::addRoundOff(unsigned seed, const std::vector<const double*>& u,
                                      const std::vector<double*>& forces) const {
  const substructure::CrsView view = substructure::viewOf(*stiffness_, "operator");
  const int dimension = term_.dimension;
  std::vector<double> roots = diagonal();
  for (double& value : roots) value = std::sqrt(value);
  const std::vector<double> ofTranslation = substructure::translationForces(view, dimension).roundOff;
  for (int row = 0; row < view.rows; ++row) {
    const int node = row - row % dimension;
    for (std::size_t k = view.rowPointers[row]; k < view.rowPointers[row + 1]; ++k) {
      const int column = view.columns[k];
      const int same = node + column % dimension;  // component of the node of the row
      const double size = std::numeric_limits<double>::epsilon() * roots[row] * roots[column];
      const double byPlace = signByPlace(seed, row, column) * size;
      const double byValue = signByValue(seed, row, column, dimension, view.values[k]) * size;
      for (std::size_t j = 0; j < u.size(); ++j) {
        const double difference = u[j][column] - u[j][same];
        forces[j][row] += byPlace * u[j][column] + byValue * difference;
      }
    }
    for (int c = 0; c < dimension && !ofTranslation.empty(); ++c) {
      const double force = ofTranslation[static_cast<std::size_t>(row) * dimension + c];
      for (std::size_t j = 0; j < u.size(); ++j) forces[j][row] += force * u[j][node + c];
    }
  }
}

}  // namespace harmos::latin
