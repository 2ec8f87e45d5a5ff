#include <harmos/elasticity/detail/ElementIntegrals.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace harmos::elasticity {
namespace {

// Of the longest: an element has no extent where the difference of its coordinates is rounding.
constexpr double shortest = 1e-10;
// Of the volume of an element: a Jacobian that is 0 but for rounding.
constexpr double roundOff = 1e-10;
constexpr double pi = 3.14159265358979323846;

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
void addJacobian(const double* gradient, const base::Vector3* const* nodes, int count, double (&jacobian)[D][D]) {
  for (int a = 0; a < count; ++a) {
    for (int i = 0; i < D; ++i) {
      for (int k = 0; k < D; ++k) jacobian[i][k] += (*nodes[a])[i] * gradient[D * a + k];
    }
  }
}

/// A gradient in space of one in the reference element.
template <int D>
void transform(const double (&cofactor)[D][D], double determinant, const double* local, double* gradient) {
  for (int i = 0; i < D; ++i) {
    double sum = 0.0;
    for (int k = 0; k < D; ++k) sum += cofactor[i][k] * local[k];
    gradient[i] = sum / determinant;
  }
}

/// Whether the element is turned inside out at one of its nodes, although it need not be at the quadrature points.
/// Jacobians of 0 are allowed there: middles of edges at a quarter of their length make a crack tip.
template <int D>
bool isFolded(const ElementBasis& basis, const base::Vector3* const* nodes, double volume) {
  for (int at = 0; at < basis.atNodes.points; ++at) {
    double jacobian[D][D] = {}, cofactor[D][D], determinant;
    addJacobian<D>(basis.atNodes.gradient.data() + at * D * basis.atNodes.nodes, nodes, basis.atNodes.nodes, jacobian);
    invert(jacobian, cofactor, determinant);
    if (determinant < -roundOff * volume) return true;
  }
  return false;
}

template <int D>
bool integrateIn(const ElementBasis& basis, const base::Vector3* const* places, bool withProduct,
                 ElementIntegrals& result) {
  const mesh::ReferenceElement& reference = basis.reference;
  const int nodes = reference.nodes, functions = basis.functions(), perFunction = basis.gradients();
  const int entries = perFunction * functions;
  result.volume = 0.0;
  std::fill_n(result.value.begin(), nodes, 0.0);
  std::fill_n(result.gradient.begin(), entries, 0.0);
  if (withProduct) std::fill_n(result.product.begin(), entries * entries, 0.0);
  double centre[D][D] = {}, centreCofactor[D][D], centreDeterminant = 0.0;
  if (basis.modes > 0) {
    addJacobian<D>(basis.atCentre.gradient.data(), places, nodes, centre);
    if (!invert(centre, centreCofactor, centreDeterminant)) return false;
  }
  for (int point = 0; point < reference.points; ++point) {
    const double* local = reference.gradient.data() + point * D * nodes;
    double jacobian[D][D] = {};
    addJacobian<D>(local, places, nodes, jacobian);
    double cofactor[D][D], determinant;
    if (!invert(jacobian, cofactor, determinant)) return false;
    const double* value = reference.value.data() + point * nodes;
    double weight = reference.weight[point] * determinant;
    double gradient[ElementIntegrals::maximumDofs];
    for (int a = 0; a < nodes; ++a) transform<D>(cofactor, determinant, local + D * a, gradient + perFunction * a);
    if (basis.isRevolved) {
      double radius = 0.0;
      for (int a = 0; a < nodes; ++a) radius += value[a] * (*places[a])[0];
      if (!(radius > 0.0)) return false;
      weight *= 2.0 * pi * radius;
      for (int a = 0; a < nodes; ++a) gradient[perFunction * a + D] = value[a] / radius;
    }
    for (int m = 0; m < basis.modes; ++m) {
      transform<D>(centreCofactor, determinant, basis.modeGradient.data() + D * (point * basis.modes + m),
                   gradient + perFunction * (nodes + m));
    }
    result.volume += weight;
    for (int a = 0; a < nodes; ++a) result.value[a] += weight * value[a];
    for (int i = 0; i < entries; ++i) result.gradient[i] += weight * gradient[i];
    if (!withProduct) continue;
    for (int i = 0; i < entries; ++i) {
      const double factor = weight * gradient[i];
      double* row = result.product.data() + i * entries;
      for (int j = i / perFunction * perFunction; j < entries; ++j) row[j] += factor * gradient[j];
    }
  }
  return !isFolded<D>(basis, places, result.volume);
}

}  // namespace

bool integrate(const ElementBasis& basis, const base::Vector3* const* nodes, bool withProduct,
               ElementIntegrals& integrals) {
  return basis.reference.dimension == 3 ? integrateIn<3>(basis, nodes, withProduct, integrals)
                                        : integrateIn<2>(basis, nodes, withProduct, integrals);
}

}  // namespace harmos::elasticity
