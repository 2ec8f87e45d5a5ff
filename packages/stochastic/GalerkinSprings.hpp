#pragma once

#include <memory>
#include <vector>

#include <harmos/assembly/Interface.hpp>
#include <harmos/base/Matrix.hpp>
#include <harmos/stochastic/Projection.hpp>

namespace harmos::stochastic {

/// Galerkin's local stage of an interface whose stiffness is random: the residual of the graph t = k(xi) delta is
/// orthogonal to the basis.
///
/// With G_ab = E[k psi_a psi_b] of a component and t = k delta + c, the coefficients of the traction on the line
/// delta = delta_free - H t are t = (I + H G)^-1 (G delta_free + c) = V (I + H diag(lambda))^-1 (diag(lambda) V^T
/// delta_free + V^T c), G = V diag(lambda) V^T, at all nodes with one decomposition. k: [stress/length], c:
/// offset [stress], xi: germs, H: [length/stress]; delta_free, delta: [length].
class GalerkinSprings {
 public:
  /// `laws`: at the points. Their stiffness is found by a probe on lines of the given compliance [length/stress].
  /// Throws base::Error (input) naming the interface when a law is not affine or a matrix G not positive definite, or a
  /// component rigid at some points only. Not collective.
  GalerkinSprings(const assembly::Interface& interface,
                  const std::vector<std::shared_ptr<const laws::InterfaceLaw>>& laws, const Projection& projection,
                  int steps, double compliance);

  /// The stiffness of a component is random. When it is not, the law at the points and their projection are exact.
  bool isRandom() const { return isRandom_; }
  /// Coefficients of the tractions [stress] from those of the free jumps [length]: (pairs x 3) x terms, both in the
  /// frame of the law; `lines` give the compliances.
  void solve(int step, const std::vector<laws::LocalLine>& lines, const base::Matrix& freeJumps,
             base::Matrix& tractions) const;

 private:
  struct Decomposition {
    std::vector<double> stiffness;  // at the points
    std::vector<double> values;     // lambda
    base::Matrix vectors;           // V
  };
  struct Component {
    std::size_t decomposition;
    std::vector<double> offset;  // V^T c; of a rigid component the jump
  };

  static Decomposition decompose(const std::string& name, std::vector<double> stiffness, const Projection& projection);

  bool isRandom_ = false;
  std::vector<Decomposition> decompositions_;  // the different ones
  std::vector<Component> components_;          // of each load step, three
};

}  // namespace harmos::stochastic
