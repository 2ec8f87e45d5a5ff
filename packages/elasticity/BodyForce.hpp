#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <harmos/base/Tensor3.hpp>
#include <harmos/elasticity/ElementPoints.hpp>

namespace harmos::elasticity {

/// A vector field that is affine in the place x, v(x) = constant + slope x: body forces [force/volume], or the
/// accelerations [length/time^2] that they come from.
struct AffineField {
  base::Vector3 constant{};  ///< at the origin
  base::Tensor3 slope{};     ///< per length

  /// Adds `scale` times another field.
  void add(double scale, const AffineField& other) {
    constant = constant + scale * other.constant;
    for (std::size_t i = 0; i < 3; ++i) slope[i] = slope[i] + scale * other.slope[i];
  }
};

/// Turns body forces of a part into nodal forces, f_a = int N_a b(x) dV, N_a the shape function of node a.
class BodyForce {
 public:
  /// Integrates over the part once, which it does not refer to later. Throws base::Error as visitElements(), and for
  /// negative radii. Not collective.
  explicit BodyForce(const ElasticPart& part);

  /// Adds the nodal forces [force] of b [force/volume] in the global axes to those of the part's dofs. Throws
  /// base::Error (input) when b leaves the plane where displacements do not.
  void addTo(double* forces, const AffineField& b) const;

  /// The body force [force/volume] at a load step and a point of an element, both counted from 0, in the global axes.
  using Field = std::function<base::Vector3(int step, const ElementPoints& at, int point)>;
  /// Adds the nodal forces of any b at all load steps to `forces`, dofs x load steps; b is taken at the integration
  /// points of the stiffness. Throws as the constructor and addTo(), and what `b` throws. Not collective.
  static void addTo(base::Matrix& forces, const ElasticPart& part, const Field& b);

 private:
  std::string name_;
  int components_;
  std::vector<std::array<double, 4>> moments_;  // per node: int N dV, int N x dV, with y and z
  std::vector<bool> isOnAxis_;
};

}  // namespace harmos::elasticity
