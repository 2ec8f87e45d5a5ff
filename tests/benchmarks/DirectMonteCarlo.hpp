#pragma once

#include <array>
#include <memory>
#include <vector>

#include <harmos/stochastic/SpectralSystem.hpp>
#include <harmos/substructure/SolverFactory.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

#include "RandomGlue.hpp"

namespace harmos::benchmarks {

/// Displacement of A [length], along x and y.
using PointDisplacement = std::array<double, 2>;

/// The glued assembly as one matrix K(f) = K_0 + f_1 K_1 + f_2 K_2 of the moduli over their means. What its assembly
/// costs is charged to nobody.
class GluedMatrices {
 public:
  explicit GluedMatrices(const RandomGlue& glue);

  /// K(f); the same structure for all f.
  Teuchos::RCP<base::CrsMatrix> matrix(const std::vector<double>& factors) const;
  const base::Matrix& right() const { return right_; }
  /// Rows, one column per component of A: u_A = R^T u.
  const base::Matrix& reader() const { return reader_; }
  const stochastic::SpectralSystem& system() const { return system_; }
  PointDisplacement read(const base::Matrix& solution) const;

 private:
  stochastic::SpectralSystem system_;
  Teuchos::RCP<base::CrsMatrix> mean_;
  std::array<std::vector<double>, 2> change_;  // values of K_1, K_2
  base::Matrix right_, reader_;
};

/// Monte Carlo that factors K(f) for each draw; CHOLMOD's symbolic factorisation is made once.
class RefactoringMonteCarlo {
 public:
  RefactoringMonteCarlo(const RandomGlue& glue, const GluedMatrices& matrices);
  PointDisplacement solve(const std::vector<double>& factors);

 private:
  const GluedMatrices& matrices_;
  Teuchos::RCP<base::CrsMatrix> matrix_;
  Teuchos::RCP<substructure::DirectSolver> solver_;
};

/// Monte Carlo on the jumps of both glues, to which the mean assembly is condensed once.
///
/// K(f) = K + J^T L D L^T J, with J the jumps, L L^T their mean stiffness and D = diag(f - 1). With T = L^T J K^-1 J^T
/// L, g = L^T J K^-1 b and h = L^T J K^-1 r: (I + T D) y = g, u_A = r^T K^-1 b - h^T D y (Woodbury).
class CondensedMonteCarlo {
 public:
  CondensedMonteCarlo(const RandomGlue& glue, const GluedMatrices& matrices);

  /// One dense factorisation of the size of the jumps.
  PointDisplacement solveDense(const std::vector<double>& factors) const;
  /// The same to round-off in the eigenvectors of each glue by itself, which are coupled by a matrix of low rank.
  PointDisplacement solve(const std::vector<double>& factors) const;
  /// To be called before solve().
  void diagonalise();
  int jumps() const { return compliance_.numRows(); }
  int rank() const { return rank_; }

 private:
  int size_ = 0;             // jumps of one glue
  base::Matrix compliance_;  // T
  base::Matrix driven_;      // g
  base::Matrix read_;        // h, one column per component
  PointDisplacement mean_{};
  // In the eigenvectors of the two diagonal blocks of T, whose coupling is P Q^T:
  std::array<std::vector<double>, 2> values_;
  std::array<base::Matrix, 2> coupling_, rotatedDriven_, rotatedRead_;
  int rank_ = 0;
};

}  // namespace harmos::benchmarks
