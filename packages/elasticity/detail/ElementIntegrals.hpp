#pragma once

#include <array>

#include <harmos/elasticity/detail/ElementBasis.hpp>
#include <harmos/mesh/Mesh.hpp>

namespace harmos::elasticity {

/// Integrals over one element from which stiffness, loads and mean stress follow without further loops over points.
///
/// With g_a = grad N_a [1/length] of nodes and then incompatible modes, flattened to one vector of functions x
/// gradients entries; in axisymmetry N_a / r is a third gradient, and dV = 2 pi r dA. Incompatible modes have int g dV
/// = 0, so that elements of any shape reproduce constant stress: their gradients are those at the centre of the
/// element, times its Jacobian over the local one (Taylor, Beresford, Wilson, Int. J. Numer. Meth. Engng 10 (1976),
/// 1211-1219, doi:10.1002/nme.1620100602).
struct ElementIntegrals {
  static constexpr int maximumFunctions = 27;
  static constexpr int maximumDofs = 3 * maximumFunctions;

  double volume = 0.0;                                      ///< int dV
  std::array<double, maximumFunctions> value{};             ///< int N_a dV of the nodes
  std::array<double, maximumDofs> gradient{};               ///< int g dV
  std::array<double, maximumDofs * maximumDofs> product{};  ///< int g g^t dV, row-major, upper triangle of node blocks
};

/// Integrates over the element with nodes at these places (unit thickness in 2-D); `product` only when asked for.
/// Returns false when the Jacobian is not positive at some quadrature point or, of quadratic elements, negative at a
/// node: an element turned inside out, folded, or without volume.
bool integrate(const ElementBasis& basis, const base::Vector3* const* nodes, bool withProduct,
               ElementIntegrals& integrals);

}  // namespace harmos::elasticity
