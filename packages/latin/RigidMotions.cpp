#include <algorithm>
#include <cmath>

#include <harmos/latin/InterfaceMass.hpp>
#include <harmos/latin/detail/RigidMotions.hpp>
#include <harmos/latin/detail/SymmetricEigen.hpp>

namespace harmos::latin {
namespace {

using base::Matrix;

// Eigenvalue of a rigid motion over the largest one, below which an interface cannot feel the motion.
constexpr double felt = 1e-10;

/// Rigid motions of some pairs of an interface about their centre, rotations scaled by their size, so that all columns
/// are lengths alike.
Matrix motionsAboutCentre(const assembly::Interface& interface, int dimension, const std::vector<int>& pairs) {
  base::Vector3 centre{};
  double total = 0.0;
  for (const int p : pairs) {
    const auto i = static_cast<std::size_t>(p);
    for (std::size_t c = 0; c < 3; ++c) centre[c] += interface.area[i] * interface.position[i][c];
    total += interface.area[i];
  }
  for (double& c : centre) c /= total;
  double size = 0.0;
  for (const int p : pairs) {
    const base::Vector3& x = interface.position[p];
    for (std::size_t c = 0; c < 3; ++c) size = std::max(size, std::abs(x[c] - centre[c]));
  }
  if (size == 0.0) size = 1.0;

  Matrix motions(interface.pairs() * dimension, dimension == 3 ? 6 : 3);
  for (const int p : pairs) {
    const base::Vector3& x = interface.position[p];
    const double r[3] = {(x[0] - centre[0]) / size, (x[1] - centre[1]) / size, (x[2] - centre[2]) / size};
    const int row = p * dimension;
    for (int c = 0; c < dimension; ++c) motions(row + c, c) = 1.0;
    if (dimension == 2) {
      motions(row, 2) = -r[1];
      motions(row + 1, 2) = r[0];
    } else {
      motions(row + 1, 3) = -r[2], motions(row + 2, 3) = r[1];
      motions(row, 4) = r[2], motions(row + 2, 4) = -r[0];
      motions(row, 5) = -r[1], motions(row + 1, 5) = r[0];
    }
  }
  return motions;
}

}  // namespace

Matrix weighted(const assembly::Interface& interface, int dimension, const std::vector<double>& k, const Matrix& x) {
  Matrix y(x.numRows(), x.numCols());
  for (int j = 0; j < x.numCols(); ++j) {
    applyMass(interface, dimension, x[j], y[j]);
    for (int row = 0; row < y.numRows(); ++row) y(row, j) *= k[row / dimension];
  }
  return y;
}

Matrix rigidMotions(const assembly::Interface& interface, int dimension, const std::vector<double>& k,
                    const std::vector<int>& pairs) {
  const Matrix motions = motionsAboutCentre(interface, dimension, pairs);
  Matrix gram(motions.numCols(), motions.numCols());
  gram.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, motions, weighted(interface, dimension, k, motions), 0.0);
  const std::vector<double> values = symmetricEigen(gram);
  // A point, or nodes on a line, cannot feel some rotations: their eigenvalues are round-off.
  const double threshold = felt * values.back();
  const auto kept =
      static_cast<int>(std::count_if(values.begin(), values.end(), [&](double v) { return v > threshold; }));
  Matrix basis(gram.numRows(), kept);
  for (int j = 0; j < kept; ++j) {
    const int from = gram.numCols() - kept + j;
    const double scale = 1.0 / std::sqrt(values[from]);
    for (int i = 0; i < basis.numRows(); ++i) basis(i, j) = scale * gram(i, from);
  }
  Matrix modes(motions.numRows(), kept);
  modes.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, motions, basis, 0.0);
  return modes;
}

}  // namespace harmos::latin
