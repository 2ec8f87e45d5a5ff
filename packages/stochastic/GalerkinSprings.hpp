#pragma once

#include <memory>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/interface/Interface.hpp>
#include <harmos/stochastic/Projection.hpp>

namespace harmos::stochastic {

/// Galerkin's local stage of an interface whose stiffness is random: the residual of the graph t = k(xi) delta is
/// orthogonal to the basis.
///
/// With G_ab = E[k psi_a psi_b] of a component, the coefficients of the traction on the line delta = delta_free - H t
/// are t = (I + H G)^-1 G delta_free = V diag(lambda / (1 + H lambda)) V^T delta_free, G = V diag(lambda) V^T, at all
/// nodes with one decomposition.
class GalerkinSprings {
 public:
  /// `laws`: at the points. Their stiffness is found by a probe on lines of the given compliance [length/stress].
  /// Throws base::Error (input) naming the interface when the laws are not affine, have a random stiffness and act
  /// without a jump too, or when a matrix G is not positive definite.
  GalerkinSprings(const interface::Interface& interface,
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
  struct Probe {
    std::vector<double> stiffness[3];  // per component, at the points
    double offset = 0.0;               // largest traction without a free jump
  };

  Probe probe(const interface::Interface& interface, const std::vector<std::shared_ptr<const laws::InterfaceLaw>>& laws,
              int step, double compliance) const;
  Decomposition decompose(const std::string& name, std::vector<double> stiffness, const Projection& projection) const;

  bool isRandom_ = false;
  std::vector<Decomposition> decompositions_;  // the different ones
  std::vector<std::size_t> which_;             // of each load step and component
};

}  // namespace harmos::stochastic
