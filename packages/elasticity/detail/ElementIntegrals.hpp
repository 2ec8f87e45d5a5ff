#pragma once

#include <array>

#include <harmos/elasticity/detail/ReferenceElement.hpp>
#include <harmos/mesh/Mesh.hpp>

namespace harmos::elasticity {

/// Integrals over one element from which stiffness, loads and mean stress follow without further loops over points.
///
/// With g_a = grad N_a [1/length], flattened to one vector of nodes x dimension entries:
struct ElementIntegrals {
  static constexpr int maximumNodes = 8;
  static constexpr int maximumDofs = 24;

  double volume = 0.0;                                      ///< int dV
  std::array<double, maximumNodes> value{};                 ///< int N_a dV
  std::array<double, maximumDofs> gradient{};               ///< int g dV
  std::array<double, maximumDofs * maximumDofs> product{};  ///< int g g^t dV, row-major, upper triangle of node blocks
};

/// Integrates over the element with the given corners (unit thickness in 2-D); `product` only when asked for.
/// Returns false when the Jacobian is not positive at some point: an element turned inside out or without volume.
bool integrate(const ReferenceElement& reference, const base::Vector3* const* corners, bool withProduct,
               ElementIntegrals& integrals);

}  // namespace harmos::elasticity
