#pragma once

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <harmos/base/Matrix.hpp>
#include <harmos/substructure/DistributedSolver.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

namespace harmos::latin {

/// The matrix G [-] of the macro problem, symmetric, factored by every rank for itself, or, from
/// SolverOptions::sharedFrom unknowns on and on several ranks, by all of them together.
class MacroFactor {
 public:
  /// What a body of this rank adds to G.
  struct Share {
    std::vector<int> unknowns;  ///< of the interfaces of the body
    base::Matrix values;        ///< between them, symmetric but for round-off
  };
  /// G is not positive definite: round-off hides what its smallest eigenvalue is, whatever its sign, or it is negative.
  class NotPositiveDefinite : public std::runtime_error {
   public:
    NotPositiveDefinite(double smallest, std::vector<double> itsMotion)
        : std::runtime_error("the macro problem is not positive definite"),
          eigenvalue(smallest),
          motion(std::move(itsMotion)) {}
    double eigenvalue;           ///< the smallest one, to a factor of ten
    std::vector<double> motion;  ///< its eigenvector, of length 1
  };

  /// Collective. `coupled`: the unknowns of the interfaces of every body of the assembly, between which G may have
  /// entries. Throws the same on all ranks: NotPositiveDefinite, or base::Error where memory does not suffice.
  /// `isKnownRegular`: a positive eigenvalue may be as small as its round-off.
  MacroFactor(int unknowns, const std::vector<std::vector<int>>& coupled, const std::vector<Share>& shares,
              const substructure::SolverOptions& options, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
              bool isKnownRegular = false);

  /// Collective. c = G^-1 right; both are the same on all ranks, and different objects.
  void solve(const base::Matrix& right, base::Matrix& c) const {
    shared_ ? shared_->solve(right, c) : own_->solve(right, c);
  }
  /// 1 over the smallest eigenvalue of G, about, at least 1.
  double softness() const { return softness_; }

 private:
  int unknowns_;
  std::unique_ptr<substructure::SubstructureSolver> own_;
  std::unique_ptr<substructure::DistributedSolver> shared_;  // instead of it
  double softness_ = 1.0;
};

}  // namespace harmos::latin
