#include <harmos/substructure/detail/RigidMotions.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace harmos::substructure {
namespace {

// Of the largest pivot: a motion that is left with less is not resisted. Slender parts are turned about their axis by
// the square of their slenderness.
constexpr double leastPivot = 1e-12;

/// Adds motions^T D motions of one node, whose first row is given.
void add(const base::Tensor3& directions, int first, int dimension, const base::Matrix& motions, base::Matrix& gram) {
  for (int i = 0; i < motions.numCols(); ++i) {
    base::Vector3 motion{};
    std::copy_n(motions[i] + first, dimension, motion.begin());
    const base::Vector3 resisted = base::product(directions, motion);
    for (int j = 0; j < motions.numCols(); ++j) {
      for (int c = 0; c < dimension; ++c) gram(i, j) += resisted[c] * motions(first + c, j);
    }
  }
}

/// Of a semi-definite matrix, by elimination with the largest pivot first.
bool isRegular(base::Matrix gram) {
  const int size = gram.numRows();
  std::vector<bool> isDone(static_cast<std::size_t>(size), false);
  double largest = 0.0;
  for (int step = 0; step < size; ++step) {
    int at = -1;
    for (int i = 0; i < size; ++i) {
      if (!isDone[i] && (at < 0 || gram(i, i) > gram(at, at))) at = i;
    }
    largest = std::max(largest, gram(at, at));
    if (!(gram(at, at) > leastPivot * largest)) return false;
    isDone[at] = true;
    for (int i = 0; i < size; ++i) {
      const double factor = isDone[i] ? 0.0 : gram(i, at) / gram(at, at);
      for (int j = 0; j < size; ++j) gram(i, j) -= factor * gram(at, j);
    }
  }
  return true;
}

}  // namespace

base::Matrix rigidMotions(const std::vector<base::Vector3>& nodes, int dimension) {
  double extent = 0.0;
  for (const base::Vector3& node : nodes) {
    for (int c = 0; c < dimension; ++c) extent = std::max(extent, std::abs(node[c] - nodes.front()[c]));
  }
  const int rotations = dimension == 3 ? 3 : 1;
  base::Matrix motions(static_cast<int>(nodes.size()) * dimension, dimension + rotations);
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const int row = static_cast<int>(a) * dimension;
    for (int c = 0; c < dimension; ++c) motions(row + c, c) = 1.0;
    for (int r = 0; r < rotations; ++r) {
      const int from = r, to = (r + 1) % dimension;  // turns the first of these axes towards the second
      motions(row + from, dimension + r) = -(nodes[a][to] - nodes.front()[to]) / extent;
      motions(row + to, dimension + r) = (nodes[a][from] - nodes.front()[from]) / extent;
    }
  }
  return motions;
}

bool holdsRigidMotions(const BoundaryTerm& boundary, const std::vector<base::Vector3>& nodes) {
  if (nodes.empty()) return false;
  const int dimension = boundary.dimension;
  const base::Matrix motions = rigidMotions(nodes, dimension);
  base::Matrix gram(motions.numCols(), motions.numCols());
  const base::Tensor3 all{base::Vector3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t dof = 0; dof < boundary.diagonal.size(); dof += static_cast<std::size_t>(dimension)) {
    if (boundary.diagonal[dof] > 0.0) add(all, static_cast<int>(dof), dimension, motions, gram);
  }
  for (const MatrixEntry& entry : boundary.entries) {
    if (entry.row == entry.column) add(all, entry.row * dimension, dimension, motions, gram);
  }
  for (const BoundaryTerm::NodeTensor& spring : boundary.springs) {
    const double size = base::distance(spring.value, {});
    base::Tensor3 directions{};
    for (std::size_t c = 0; c < 3 && size > 0.0; ++c) directions[c] = (1.0 / size) * spring.value[c];
    add(directions, spring.node * dimension, dimension, motions, gram);
  }
  for (const BoundaryTerm::NodeTensor& held : boundary.free) {
    base::Tensor3 directions{};
    for (std::size_t c = 0; c < 3; ++c) directions[c] = all[c] - held.value[c];
    add(directions, held.node * dimension, dimension, motions, gram);
  }
  return isRegular(gram);
}

void removeRigidMotions(const std::vector<base::Vector3>& nodes, int dimension, base::Matrix& vectors) {
  base::Matrix motions = rigidMotions(nodes, dimension);
  const int rows = motions.numRows();
  const auto remove = [rows](const double* direction, double* from) {
    const double share = std::inner_product(direction, direction + rows, from, 0.0);
    for (int row = 0; row < rows; ++row) from[row] -= share * direction[row];
  };
  for (int m = 0; m < motions.numCols(); ++m) {
    double* const motion = motions[m];
    // Twice, so that round-off of the first time is taken as well.
    for (int pass = 0; pass < 2; ++pass) {
      for (int earlier = 0; earlier < m; ++earlier) remove(motions[earlier], motion);
    }
    const double length = std::sqrt(std::inner_product(motion, motion + rows, motion, 0.0));
    for (int row = 0; row < rows && length > 0.0; ++row) motion[row] /= length;
  }
  for (int j = 0; j < vectors.numCols(); ++j) {
    for (int pass = 0; pass < 2; ++pass) {
      for (int m = 0; m < motions.numCols(); ++m) remove(motions[m], vectors[j]);
    }
  }
}

}  // namespace harmos::substructure
