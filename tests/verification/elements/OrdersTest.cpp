#include <gtest/gtest.h>

#include <cmath>

#include <harmos/elasticity/Stiffness.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/ReferenceElement.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

namespace harmos::verification {
namespace {

constexpr double youngsModulus = 1.0, poissonsRatio = 0.3;

/// Isotropic elasticity with the constants above.
struct Elastic : elasticity::Material {
  elasticity::ElasticityMatrix elasticity() const override {
    const double mu = youngsModulus / (2.0 + 2.0 * poissonsRatio);
    const double lambda = 2.0 * mu * poissonsRatio / (1.0 - 2.0 * poissonsRatio);
    elasticity::ElasticityMatrix c{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) c[i][j] = lambda + (i == j ? 2.0 * mu : 0.0);
      c[i + 3][i + 3] = mu;
    }
    return c;
  }
};

/// The gradient of a harmonic function: in balance without forces.
struct Exact {
  base::Vector3 displacement{};
  double gradient[3][3] = {};

  Exact(const base::Vector3& x, int dimension) {
    if (dimension == 2) {
      const double e = std::exp(2.0 * x[0]), c = std::cos(2.0 * x[1]), s = std::sin(2.0 * x[1]);
      displacement = {e * c, -e * s, 0.0};
      gradient[0][0] = 2.0 * e * c, gradient[0][1] = gradient[1][0] = -2.0 * e * s, gradient[1][1] = -2.0 * e * c;
      return;
    }
    const double r = std::sqrt(2.0), e = std::exp(r * x[0]);
    const double cy = std::cos(x[1]), sy = std::sin(x[1]), cz = std::cos(x[2]), sz = std::sin(x[2]);
    displacement = {r * e * cy * cz, -e * sy * cz, -e * cy * sz};
    gradient[0][0] = 2.0 * e * cy * cz, gradient[1][1] = gradient[2][2] = -e * cy * cz;
    gradient[0][1] = gradient[1][0] = -r * e * sy * cz;
    gradient[0][2] = gradient[2][0] = -r * e * cy * sz;
    gradient[1][2] = gradient[2][1] = e * sy * sz;
  }
};

/// Errors in the mean square.
struct Errors {
  double displacement = 0.0, gradient = 0.0;
};

/// A box of a mesh that is bent smoothly, the boundary held at the exact displacements.
mesh::Mesh bentBox(mesh::ElementType type, int cells) {
  const int dimension = mesh::dimensionOf(type);
  mesh::Box box;
  box.name = "box";
  box.element = type;
  box.upper = {1.0, 1.0, dimension == 3 ? 1.0 : 0.0};
  box.cells = {cells, cells, cells};
  mesh::Mesh mesh = mesh::boxes({box});
  for (base::Vector3& x : mesh.nodes) {
    const base::Vector3 y = x;
    for (int c = 0; c < dimension; ++c) x[c] += 0.06 * std::sin(3.0 * y[(c + 1) % dimension] + y[c]);
  }
  return mesh;
}

base::Matrix solve(const mesh::Mesh& mesh, const mesh::Piece& piece, elasticity::Formulation formulation,
                   elasticity::Kinematics kinematics) {
  const int dimension = mesh.dimension;
  const auto stiffness = elasticity::assembleStiffness(mesh, piece, Elastic(), formulation, kinematics);
  const mesh::Elements elements(mesh);
  substructure::BoundaryTerm held;
  held.dimension = dimension;
  held.diagonal.assign(mesh.nodes.size() * static_cast<std::size_t>(dimension), 0.0);
  base::Matrix load(static_cast<int>(held.diagonal.size()), 1), u;
  const double penalty = 1e9 * youngsModulus;
  for (const mesh::SideSet& set : mesh.sideSets) {
    for (std::size_t i = 0; i < set.element.size(); ++i) {
      for (const int node : elements.side(set.element[i], set.side[i])) {
        const Exact exact(mesh.nodes[node], dimension);
        for (int c = 0; c < dimension; ++c) {
          held.diagonal[node * dimension + c] = penalty;
          load(node * dimension + c, 0) = penalty * exact.displacement[c];
        }
      }
    }
  }
  substructure::SubstructureSolver(stiffness, held, {}, "box").solve(load, u);
  return u;
}

base::Vector3 inverseTimes(const double (&j)[3][3], const double* local, int dimension) {
  // J^-t times a gradient in the reference element.
  if (dimension == 2) {
    const double det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
    return {(j[1][1] * local[0] - j[1][0] * local[1]) / det, (j[0][0] * local[1] - j[0][1] * local[0]) / det, 0.0};
  }
  const base::Vector3 a{j[0][0], j[1][0], j[2][0]}, b{j[0][1], j[1][1], j[2][1]}, c{j[0][2], j[1][2], j[2][2]};
  const double det = dot(a, cross(b, c));
  return (1.0 / det) * (local[0] * cross(b, c) + local[1] * cross(c, a) + local[2] * cross(a, b));
}

Errors errorsOf(mesh::ElementType type, int cells, elasticity::Formulation formulation) {
  const mesh::Mesh mesh = bentBox(type, cells);
  const int dimension = mesh.dimension;
  const mesh::Piece piece = mesh::makePiece(mesh, "box", {"box"});
  const base::Matrix u =
      solve(mesh, piece, formulation,
            dimension == 3 ? elasticity::Kinematics::threeDimensional : elasticity::Kinematics::planeStrain);
  const mesh::ReferenceElement reference = mesh::referenceElement(type);
  const mesh::Elements elements(mesh);
  Errors errors;
  double volume = 0.0;
  for (int e = 0; e < elements.count(); ++e) {
    const int* nodes = elements.nodes(e);
    for (int p = 0; p < reference.points; ++p) {
      double jacobian[3][3] = {};
      base::Vector3 x{}, value{};
      for (int a = 0; a < reference.nodes; ++a) {
        const int at = p * reference.nodes + a;
        x = x + reference.value[at] * mesh.nodes[nodes[a]];
        for (int i = 0; i < dimension; ++i) {
          value[i] += reference.value[at] * u(dimension * nodes[a] + i, 0);
          for (int k = 0; k < dimension; ++k) {
            jacobian[i][k] += mesh.nodes[nodes[a]][i] * reference.gradient[dimension * at + k];
          }
        }
      }
      if (dimension == 2) jacobian[2][2] = 1.0;
      const double weight =
          reference.weight[p] * (jacobian[0][0] * (jacobian[1][1] * jacobian[2][2] - jacobian[1][2] * jacobian[2][1]) -
                                 jacobian[0][1] * (jacobian[1][0] * jacobian[2][2] - jacobian[1][2] * jacobian[2][0]) +
                                 jacobian[0][2] * (jacobian[1][0] * jacobian[2][1] - jacobian[1][1] * jacobian[2][0]));
      double gradient[3][3] = {};
      for (int a = 0; a < reference.nodes; ++a) {
        const base::Vector3 g =
            inverseTimes(jacobian, reference.gradient.data() + dimension * (p * reference.nodes + a), dimension);
        for (int i = 0; i < dimension; ++i) {
          for (int k = 0; k < dimension; ++k) gradient[i][k] += g[k] * u(dimension * nodes[a] + i, 0);
        }
      }
      const Exact exact(x, dimension);
      volume += weight;
      for (int i = 0; i < dimension; ++i) {
        errors.displacement += weight * std::pow(value[i] - exact.displacement[i], 2);
        for (int k = 0; k < dimension; ++k)
          errors.gradient += weight * std::pow(gradient[i][k] - exact.gradient[i][k], 2);
      }
    }
  }
  return {std::sqrt(errors.displacement / volume), std::sqrt(errors.gradient / volume)};
}

struct OrderCase {
  mesh::ElementType type;
  int coarse, fine;
  elasticity::Formulation formulation = elasticity::Formulation::fullIntegration;
};

class Orders : public ::testing::TestWithParam<OrderCase> {};

// A smooth solution: the energy (square root) of the error goes with h^p, displacements with h^(p+1). In one point per
// triangle and tetrahedron gradients are sampled where they are better than that.
TEST_P(Orders, AreThoseOfTheShapeFunctions) {
  const OrderCase& given = GetParam();
  const Errors coarse = errorsOf(given.type, given.coarse, given.formulation);
  const Errors fine = errorsOf(given.type, given.fine, given.formulation);
  const double ratio = std::log(static_cast<double>(given.fine) / given.coarse);
  const double degree = mesh::isQuadratic(given.type) ? 2.0 : 1.0;
  const double ofGradient = std::log(coarse.gradient / fine.gradient) / ratio;
  const double ofDisplacement = std::log(coarse.displacement / fine.displacement) / ratio;
  EXPECT_GT(ofGradient, degree - 0.25) << ofDisplacement;
  EXPECT_GT(ofDisplacement, degree + 0.75) << ofGradient;
}

using Type = mesh::ElementType;

INSTANTIATE_TEST_SUITE_P(
    Elements, Orders,
    ::testing::Values(OrderCase{Type::tri3, 8, 16}, OrderCase{Type::quad4, 8, 16},
                      OrderCase{Type::quad4, 8, 16, elasticity::Formulation::incompatibleModes},
                      OrderCase{Type::tri6, 4, 8}, OrderCase{Type::quad8, 4, 8}, OrderCase{Type::quad9, 4, 8},
                      OrderCase{Type::tet4, 4, 8}, OrderCase{Type::hex8, 4, 8},
                      OrderCase{Type::hex8, 4, 8, elasticity::Formulation::incompatibleModes},
                      OrderCase{Type::tet10, 2, 4}, OrderCase{Type::wedge15, 2, 4}, OrderCase{Type::hex20, 2, 4},
                      OrderCase{Type::hex27, 2, 4}),
    [](const auto& test) {
      return std::string(mesh::exodusName(test.param.type)) +
             (test.param.formulation == elasticity::Formulation::fullIntegration ? "" : "IncompatibleModes");
    });

}  // namespace
}  // namespace harmos::verification
