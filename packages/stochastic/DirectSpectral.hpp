#pragma once

#include <memory>
#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/base/Timers.hpp>
#include <harmos/latin/Response.hpp>
#include <harmos/stochastic/Projection.hpp>
#include <harmos/stochastic/Realisations.hpp>
#include <harmos/stochastic/SpectralSystem.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

namespace harmos::stochastic {

/// The spectral stochastic finite element method on the whole assembly, without LATIN: the rival that it is compared
/// with, and an independent solution of the same Galerkin equations.
///
/// Source: Ghanem, Spanos, Stochastic Finite Elements (1991); Ghanem, Kruger (1996), doi:10.1016/0045-7825(95)00909-4
/// for conjugate gradients preconditioned by the factored mean matrix.
class DirectSpectral {
 public:
  /// What solves the equations of SpectralSystem.
  enum class Solver {
    conjugateGradients,  ///< the operator is applied block by block and never assembled
    factorisation        ///< of the assembled matrix of all polynomials
  };

  /// On one process, which owns all bodies. `assembly` must outlive this object. Throws base::Error (input) as
  /// SpectralSystem. Time is charged to "assemble".
  DirectSpectral(const assembly::Assembly& assembly, std::shared_ptr<const Projection> projection,
                 const Realisations& laws, const substructure::SolverOptions& solver, base::Timers& timers);

  /// Solves for all load steps; `tolerance` is the relative residual of the conjugate gradients. Time is charged to
  /// "factor" and "solve". Throws base::Error when a matrix is not positive definite, or (not converged) when 1000
  /// iterations do not do.
  void solve(Solver solver, double tolerance = 1e-10);

  /// Of the last solve, terms x load steps [length].
  base::Matrix coefficients(const latin::DisplacementResponse& response) const;
  /// Degrees of freedom of all bodies times polynomials, held ones included.
  int unknowns() const { return system_.dofs() * projection_->terms(); }
  /// Of the conjugate gradients in the last solve; 0 of a factorisation.
  int iterations() const { return iterations_; }

 private:
  substructure::SubstructureSolver factored(const Teuchos::RCP<base::CrsMatrix>& matrix, int dimension) const;
  void iterate(double tolerance);
  void factor();

  std::shared_ptr<const Projection> projection_;
  substructure::SolverOptions solver_;
  base::Timers& timers_;
  SpectralSystem system_;
  base::Matrix solution_;  // (dofs x terms) x load steps, polynomials of a dof together
  int iterations_ = 0;
};

}  // namespace harmos::stochastic
