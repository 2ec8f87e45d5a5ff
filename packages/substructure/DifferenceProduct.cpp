#include <harmos/substructure/detail/DifferenceProduct.hpp>

#include <algorithm>
#include <utility>

#include <harmos/base/Vector3.hpp>
#include <harmos/substructure/CrsMatrix.hpp>
#include <harmos/substructure/TranslationForces.hpp>

namespace harmos::substructure {

DifferenceProduct::DifferenceProduct(Teuchos::RCP<const base::CrsMatrix> stiffness, BoundaryTerm boundary)
    : stiffness_(std::move(stiffness)),
      boundary_(std::move(boundary)),
      ofTranslation_(translationForces(viewOf(*stiffness_, "operator"), boundary_.dimension).resistance) {}

void DifferenceProduct::project(base::Matrix& vectors) const {
  for (const BoundaryTerm::NodeTensor& held : boundary_.free) {
    for (int j = 0; j < vectors.numCols(); ++j) {
      double* const at = vectors[j] + held.node * boundary_.dimension;
      base::Vector3 old{};
      std::copy_n(at, boundary_.dimension, old.begin());
      const base::Vector3 now = base::product(held.value, old);
      std::copy_n(now.begin(), boundary_.dimension, at);
    }
  }
}

void DifferenceProduct::subtractAdded(const double* x, double* from) const {
  const int dimension = boundary_.dimension;
  for (std::size_t row = 0; row < boundary_.diagonal.size(); ++row) from[row] -= boundary_.diagonal[row] * x[row];
  for (const MatrixEntry& entry : boundary_.entries) {
    for (int c = 0; c < dimension; ++c) {
      from[entry.row * dimension + c] -= entry.value * x[entry.column * dimension + c];
    }
  }
  for (const BoundaryTerm::NodeTensor& spring : boundary_.springs) {
    const int first = spring.node * dimension;
    base::Vector3 moved{};
    std::copy_n(x + first, dimension, moved.begin());
    const base::Vector3 force = base::product(spring.value, moved);
    for (int c = 0; c < dimension; ++c) from[first + c] -= force[c];
  }
}

base::Matrix DifferenceProduct::residual(const base::Matrix& b, const base::Matrix& x) const {
  const CrsView view = viewOf(*stiffness_, "operator");
  const int dimension = boundary_.dimension;
  base::Matrix free(Teuchos::Copy, x, x.numRows(), x.numCols()), result(Teuchos::Copy, b, b.numRows(), b.numCols());
  project(free);
  for (int j = 0; j < result.numCols(); ++j) {
    const double* const u = free[j];
    for (int row = 0; row < view.rows; ++row) {
      const double* const own = u + row / dimension * dimension;
      double sum = 0.0;
      for (std::size_t k = view.rowPointers[row]; k < view.rowPointers[row + 1]; ++k) {
        const int column = view.columns[k];
        sum += view.values[k] * (u[column] - own[column % dimension]);
      }
      for (int c = 0; c < dimension && !ofTranslation_.empty(); ++c) {
        sum += ofTranslation_[static_cast<std::size_t>(row) * dimension + c] * own[c];
      }
      result[j][row] -= sum;
    }
    subtractAdded(u, result[j]);
  }
  project(result);
  return result;
}

}  // namespace harmos::substructure
