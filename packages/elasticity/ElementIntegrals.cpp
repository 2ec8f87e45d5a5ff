#include <harmos/elasticity/detail/ElementIntegrals.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace harmos::elasticity {
namespace {

// Of the longest: an element has no extent where the difference of its coordinates is rounding.
constexpr double shortest = 1e-10;

/// Determinant of J and its cofactors, J^-t = cofactor / determinant. False: not positive beyond rounding.
bool invert(const double (&j)[3][3], double (&cofactor)[3][3], double& determinant) {
  double lengths = 1.0, smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int k = 0; k < 3; ++k) {
      const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
      cofactor[i][k] = j[i1][k1] * j[i2][k2] - j[i1][k2] * j[i2][k1];
    }
    const double length = std::hypot(j[i][0], j[i][1], j[i][2]);
    smallest = std::min(smallest, length);
    largest = std::max(largest, length);
    lengths *= std::sqrt(j[0][i] * j[0][i] + j[1][i] * j[1][i] + j[2][i] * j[2][i]);
  }
  determinant = j[0][0] * cofactor[0][0] + j[0][1] * cofactor[0][1] + j[0][2] * cofactor[0][2];
  return determinant > 1e-14 * lengths && smallest > shortest * largest && std::isfinite(determinant);
}

bool invert(const double (&j)[2][2], double (&cofactor)[2][2], double& determinant) {
  cofactor[0][0] = j[1][1];
  cofactor[0][1] = -j[1][0];
  cofactor[1][0] = -j[0][1];
  cofactor[1][1] = j[0][0];
  determinant = j[0][0] * j[1][1] - j[0][1] * j[1][0];
  const double lengths = std::hypot(j[0][0], j[1][0]) * std::hypot(j[0][1], j[1][1]);
  const auto [smallest, largest] = std::minmax({std::hypot(j[0][0], j[0][1]), std::hypot(j[1][0], j[1][1])});
  return determinant > 1e-14 * lengths && smallest > shortest * largest && std::isfinite(determinant);
}

template <int D>
bool integrateIn(const ReferenceElement& reference, const base::Vector3* const* corners, bool withProduct,
                 ElementIntegrals& result) {
  const int nodes = reference.nodes, dofs = D * nodes;
  result = ElementIntegrals{};
  for (int point = 0; point < reference.points; ++point) {
    const double* local = reference.gradient.data() + point * dofs;
    double jacobian[D][D] = {};
    for (int a = 0; a < nodes; ++a) {
      for (int i = 0; i < D; ++i) {
        for (int k = 0; k < D; ++k) jacobian[i][k] += (*corners[a])[i] * local[D * a + k];
      }
    }
    double cofactor[D][D], determinant;
    if (!invert(jacobian, cofactor, determinant)) return false;
    const double weight = reference.weight[point] * determinant;
    double gradient[ElementIntegrals::maximumDofs];
    for (int a = 0; a < nodes; ++a) {
      for (int i = 0; i < D; ++i) {
        double sum = 0.0;
        for (int k = 0; k < D; ++k) sum += cofactor[i][k] * local[D * a + k];
        gradient[D * a + i] = sum / determinant;
      }
    }
    result.volume += weight;
    const double* value = reference.value.data() + point * nodes;
    for (int a = 0; a < nodes; ++a) result.value[a] += weight * value[a];
    for (int i = 0; i < dofs; ++i) result.gradient[i] += weight * gradient[i];
    if (!withProduct) continue;
    for (int i = 0; i < dofs; ++i) {
      const double factor = weight * gradient[i];
      double* row = result.product.data() + i * dofs;
      for (int j = i / D * D; j < dofs; ++j) row[j] += factor * gradient[j];
    }
  }
  return true;
}

}  // namespace

bool integrate(const ReferenceElement& reference, const base::Vector3* const* corners, bool withProduct,
               ElementIntegrals& integrals) {
  return reference.dimension == 3 ? integrateIn<3>(reference, corners, withProduct, integrals)
                                  : integrateIn<2>(reference, corners, withProduct, integrals);
}

}  // namespace harmos::elasticity
