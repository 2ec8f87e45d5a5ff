#include <harmos/elasticity/detail/ElementStrain.hpp>

#include <algorithm>
#include <array>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/elasticity/detail/ElementIntegrals.hpp>

namespace harmos::elasticity {
namespace {

/// Vectors whose product with (dN/dxi_j) is the gradient of N in space, and the determinant of the Jacobian.
struct Mapping {
  std::array<base::Vector3, 3> reciprocal{};
  double determinant = 0.0;
};

Mapping mappingAt(const mesh::ShapeFunctions& shape, int point, const std::vector<base::Vector3>& nodes) {
  std::array<base::Vector3, 3> tangent{};
  if (shape.dimension == 2) tangent[2] = {0.0, 0.0, 1.0};
  const double* local = shape.gradient.data() + static_cast<std::ptrdiff_t>(point) * shape.nodes * shape.dimension;
  for (int a = 0; a < shape.nodes; ++a) {
    for (int j = 0; j < shape.dimension; ++j) {
      tangent[j] = tangent[j] + local[shape.dimension * a + j] * nodes[a];
    }
  }
  Mapping mapping;
  mapping.determinant = base::dot(tangent[0], base::cross(tangent[1], tangent[2]));
  for (std::size_t j = 0; j < 3; ++j) {
    mapping.reciprocal[j] = (1.0 / mapping.determinant) * base::cross(tangent[(j + 1) % 3], tangent[(j + 2) % 3]);
  }
  return mapping;
}

}  // namespace

ElementStrain::ElementStrain(mesh::ElementType type, Formulation formulation, Kinematics kinematics,
                             const ElasticityMatrix& c, const std::vector<base::Vector3>& places)
    : basis_(type, formulation, kinematics),
      operators_(kinematics),
      formulation_(formulation),
      isAffine_(type == mesh::ElementType::tri3 || type == mesh::ElementType::tet4),
      dimension_(mesh::dimensionOf(type)),
      components_(operators_.components),
      shape_(mesh::shapeFunctions(type, places)),
      places_(places),
      determinant_(places.size()),
      gradient_(places.size() * static_cast<std::size_t>(basis_.functions() * operators_.gradients)) {
  for (const StrainOperator::Term& first : operators_.terms) {
    for (const StrainOperator::Term& second : operators_.terms) {
      c_[first.component][second.component][first.gradient][second.gradient] +=
          first.sign * second.sign * c[first.strain][second.strain];
    }
  }
}

bool ElementStrain::integrateOver(bool withProduct) {
  const base::Vector3* places[ElementIntegrals::maximumFunctions];
  for (std::size_t a = 0; a < nodes_.size(); ++a) places[a] = &nodes_[a];
  return integrate(basis_, places, withProduct, integrals_);
}

bool ElementStrain::set(const std::vector<base::Vector3>& nodes) {
  nodes_ = nodes;
  if (!integrateOver(false)) return false;
  const Mapping centre = basis_.modes > 0 ? mappingAt(basis_.atCentre, 0, nodes) : Mapping{};
  Mapping mapping;
  for (std::size_t p = 0; p < places_.size(); ++p) {
    const int point = static_cast<int>(p);
    if (p == 0 || !isAffine_) mapping = mappingAt(shape_, point, nodes);
    determinant_[p] = mapping.determinant;
    double* gradient = gradient_.data() + p * static_cast<std::size_t>(basis_.functions() * operators_.gradients);
    const double* local = shape_.gradient.data() + static_cast<std::ptrdiff_t>(point) * shape_.nodes * dimension_;
    double radius = 0.0;
    for (int a = 0; a < shape_.nodes; ++a) {
      base::Vector3 g{};
      for (int j = 0; j < dimension_; ++j) g = g + local[dimension_ * a + j] * mapping.reciprocal[j];
      std::copy_n(g.begin(), dimension_, gradient + operators_.gradients * a);
      radius += values(point)[a] * nodes[a][0];
    }
    for (int a = 0; a < shape_.nodes && basis_.isRevolved; ++a) {
      gradient[operators_.gradients * a + dimension_] = values(point)[a] / radius;
    }
    for (int m = 0; m < basis_.modes; ++m) {
      // As ElementIntegrals has it: the gradient at the centre times the ratio of the Jacobians.
      const double factor = -2.0 * places_[p][m] * centre.determinant / mapping.determinant;
      const base::Vector3 g = factor * centre.reciprocal[m];
      std::copy_n(g.begin(), dimension_, gradient + operators_.gradients * (shape_.nodes + m));
    }
  }
  return true;
}

void ElementStrain::displace(const base::Matrix& displacements) {
  const int columns = displacements.numRows();
  if (values_.numRows() != columns) values_.shape(columns, components_ * basis_.functions());
  std::copy_n(displacements.values(), columns * displacements.numCols(), values_.values());
  if (basis_.modes > 0) findModes();
  if (formulation_ != Formulation::bBar) return;
  std::vector<double> mean(6 * static_cast<std::size_t>(columns), 0.0);
  addStrain(integrals_.gradient.data(), 1.0 / integrals_.volume, mean.data());
  meanVolume_.assign(columns, 0.0);
  for (int j = 0; j < columns; ++j) meanVolume_[j] = mean[j] + mean[columns + j] + mean[2 * columns + j];
}

/// No force acts on the modes: K_mm alpha = -K_mu u.
void ElementStrain::findModes() {
  integrateOver(true);
  const int gradients = operators_.gradients, entries = gradients * basis_.functions();
  const int size = components_ * basis_.modes, first = components_ * shape_.nodes;
  const auto stiffness = [&](int row, int column) {  // of functions a <= b
    const int a = row / components_, i = row % components_, b = column / components_, j = column % components_;
    double sum = 0.0;
    for (int k = 0; k < gradients; ++k) {
      for (int l = 0; l < gradients; ++l) {
        sum += c_[i][j][k][l] * integrals_.product[(gradients * a + k) * entries + gradients * b + l];
      }
    }
    return sum;
  };
  const int columns = values_.numRows();
  base::Matrix matrix(size, size), right(size, columns);
  for (int column = 0; column < size; ++column) {
    for (int row = 0; row <= column; ++row) matrix(row, column) = stiffness(first + row, first + column);
    for (int node = 0; node < first; ++node) {
      const double k = stiffness(node, first + column);
      for (int j = 0; j < columns; ++j) right(column, j) -= k * values_(j, node);
    }
  }
  int info = 0;
  Teuchos::LAPACK<int, double>().POSV('U', size, right.numCols(), matrix.values(), matrix.stride(), right.values(),
                                      right.stride(), &info);
  if (info != 0) throw base::Error("the incompatible modes of an element are not resisted");
  for (int row = 0; row < size; ++row) {
    for (int j = 0; j < columns; ++j) values_(j, first + row) = right(row, j);
  }
}

void ElementStrain::addForces(int point, const Strain& stress, double volume, double* forces) const {
  const int gradients = operators_.gradients;
  const double* gradient = gradient_.data() + static_cast<std::ptrdiff_t>(point) * basis_.functions() * gradients;
  for (const StrainOperator::Term& term : operators_.terms) {
    const double traction = term.sign * volume * stress[term.strain];
    for (int a = 0; a < shape_.nodes; ++a) {
      forces[components_ * a + term.component] += traction * gradient[gradients * a + term.gradient];
    }
  }
}

void ElementStrain::addStrain(const double* gradient, double factor, double* strain) const {
  const int columns = values_.numRows();
  for (int f = 0; f < basis_.functions(); ++f) {
    for (const StrainOperator::Term& term : operators_.terms) {
      const double g = factor * term.sign * gradient[operators_.gradients * f + term.gradient];
      const double* from = values_[components_ * f + term.component];
      double* to = strain + term.strain * static_cast<std::size_t>(columns);
      for (int j = 0; j < columns; ++j) to[j] += g * from[j];
    }
  }
}

void ElementStrain::findStrain(int point, double* strain) const {
  const int columns = values_.numRows();
  std::fill_n(strain, 6 * columns, 0.0);
  addStrain(gradient_.data() + static_cast<std::ptrdiff_t>(point) * basis_.functions() * operators_.gradients, 1.0,
            strain);
  if (formulation_ != Formulation::bBar) return;
  for (int j = 0; j < columns; ++j) {
    const double change = (meanVolume_[j] - strain[j] - strain[columns + j] - strain[2 * columns + j]) / 3.0;
    for (int m = 0; m < 3; ++m) strain[m * columns + j] += change;
  }
}

}  // namespace harmos::elasticity
