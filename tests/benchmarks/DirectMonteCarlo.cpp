#include "DirectMonteCarlo.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <Amesos2_Solver.hpp>
#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_MultiVector.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::benchmarks {
namespace {

// Share of the largest singular value below which the coupling of the glues is left out.
constexpr double negligible = 1e-13;

stochastic::SpectralSystem systemOf(const RandomGlue& glue, const std::vector<double>& factors) {
  const auto projection = glue.projection(0, 1);
  return {glue.assembly(), projection, {glue.laws(factors)}};
}

void check(int info, const char* routine) {
  if (info != 0) throw base::Error(std::string("LAPACK ") + routine + " returned " + std::to_string(info));
}

/// Consistent or lumped mass of an interface times its mean stiffness, on the jumps pair by pair, as L of L L^T.
base::Matrix factoredStiffness(const RandomGlue& glue, std::size_t number) {
  const assembly::Interface& interface = glue.assembly().interfaces[glue.interfaceOf(number)];
  const auto [normal, tangential] = glue.stiffness(number);
  const base::Vector3& n = interface.frame[0][0];
  base::Matrix lower(2 * interface.pairs(), 2 * interface.pairs());
  for (const mesh::MassEntry& entry : interface.mass) {
    for (int a = 0; a < 2; ++a) {
      for (int b = 0; b < 2; ++b) {
        const double projector = n[a] * n[b];
        const double stiffness = normal * projector + tangential * ((a == b ? 1.0 : 0.0) - projector);
        lower(2 * entry.row + a, 2 * entry.column + b) += entry.value * stiffness;
      }
    }
  }
  int info = 0;
  Teuchos::LAPACK<int, double>().POTRF('L', lower.numRows(), lower.values(), lower.stride(), &info);
  check(info, "POTRF");
  for (int j = 1; j < lower.numCols(); ++j) std::fill_n(lower[j], j, 0.0);
  return lower;
}

base::Matrix product(Teuchos::ETransp transposeA, const base::Matrix& a, Teuchos::ETransp transposeB,
                     const base::Matrix& b) {
  base::Matrix c(transposeA == Teuchos::TRANS ? a.numCols() : a.numRows(),
                 transposeB == Teuchos::TRANS ? b.numRows() : b.numCols());
  c.multiply(transposeA, transposeB, 1.0, a, b, 0.0);
  return c;
}

base::Matrix part(const base::Matrix& matrix, int firstRow, int rows, int firstColumn, int columns) {
  return base::Matrix(Teuchos::Copy, matrix, rows, columns, firstRow, firstColumn);
}

}  // namespace

GluedMatrices::GluedMatrices(const RandomGlue& glue)
    : system_(systemOf(glue, {1.0, 1.0})), mean_(system_.meanMatrix()) {
  const substructure::CrsView mean = substructure::viewOf(*mean_, "mean");
  const std::size_t entries = mean.rowPointers[mean.rows];
  for (std::size_t g = 0; g < 2; ++g) {
    std::vector<double> factors(2, 1.0);
    factors[g] = 2.0;
    const auto other = systemOf(glue, factors).meanMatrix();
    const substructure::CrsView view = substructure::viewOf(*other, "other");
    for (std::size_t k = 0; k < entries; ++k) change_[g].push_back(view.values[k] - mean.values[k]);
  }
  right_ = system_.right();
  reader_.shape(system_.dofs(), 2);
  for (int c = 0; c < 2; ++c) {
    const latin::DisplacementResponse& response = glue.displacement(static_cast<std::size_t>(c));
    for (const auto& node : response.nodes()) {
      for (int axis = 0; axis < 2; ++axis) {
        reader_(system_.dofOf(node.body, node.node) + axis, c) += node.weight * response.direction()[axis];
      }
    }
  }
}

Teuchos::RCP<base::CrsMatrix> GluedMatrices::matrix(const std::vector<double>& factors) const {
  using Values = base::CrsMatrix::local_matrix_device_type::values_type;
  const substructure::CrsView mean = substructure::viewOf(*mean_, "mean");
  Values values(Kokkos::ViewAllocateWithoutInitializing("values"), mean.rowPointers[mean.rows]);
  for (std::size_t k = 0; k < values.extent(0); ++k) {
    values(k) = mean.values[k] + (factors[0] - 1.0) * change_[0][k] + (factors[1] - 1.0) * change_[1][k];
  }
  const auto sum = Teuchos::rcp(new base::CrsMatrix(mean_->getCrsGraph(), values));
  sum->fillComplete(mean_->getDomainMap(), mean_->getRangeMap());
  return sum;
}

PointDisplacement GluedMatrices::read(const base::Matrix& solution) const {
  const base::Matrix found = product(Teuchos::TRANS, reader_, Teuchos::NO_TRANS, solution);
  return {found(0, 0), found(1, 0)};
}

RefactoringMonteCarlo::RefactoringMonteCarlo(const RandomGlue& glue, const GluedMatrices& matrices)
    : matrices_(matrices), matrix_(matrices.matrix({1.0, 1.0})) {
  solver_ = substructure::makeSolver(glue.stages().solver, matrix_, {});
  solver_->symbolicFactorization();
}

PointDisplacement RefactoringMonteCarlo::solve(const std::vector<double>& factors) {
  matrix_ = matrices_.matrix(factors);
  solver_->setA(matrix_, Amesos2::SYMBFACT);
  solver_->numericFactorization();
  base::MultiVector right(matrix_->getRowMap(), 1), left(matrix_->getRowMap(), 1);
  std::copy_n(matrices_.right().values(), matrices_.right().numRows(), right.getDataNonConst(0).begin());
  solver_->solve(&left, &right);
  base::Matrix solution(matrices_.right().numRows(), 1);
  const auto from = left.getData(0);
  std::copy(from.begin(), from.end(), solution.values());
  return matrices_.read(solution);
}

CondensedMonteCarlo::CondensedMonteCarlo(const RandomGlue& glue, const GluedMatrices& matrices) {
  // J as pairs of dofs: jump = u(second) - u(first).
  std::vector<std::pair<int, int>> jumps;
  for (std::size_t g = 0; g < 2; ++g) {
    const assembly::Interface& interface = glue.assembly().interfaces[glue.interfaceOf(g)];
    for (int p = 0; p < interface.pairs(); ++p) {
      for (int c = 0; c < 2; ++c) {
        jumps.emplace_back(matrices.system().dofOf(interface.body1, interface.trace1.node(p)) + c,
                           matrices.system().dofOf(interface.body2, interface.trace2.node(p)) + c);
      }
    }
  }
  const int count = static_cast<int>(jumps.size());
  size_ = count / 2;
  std::vector<int> trace;
  for (const auto& [first, second] : jumps) {
    trace.push_back(first);
    trace.push_back(second);
  }
  std::sort(trace.begin(), trace.end());
  substructure::BoundaryTerm none;
  none.dimension = glue.assembly().dimension;
  const substructure::SubstructureSolver solver(matrices.matrix({1.0, 1.0}), none, glue.stages().solver, "the assembly",
                                                trace);
  if (!solver.solvesTrace()) throw base::Error("condensing on the jumps needs CHOLMOD");

  const auto rowOf = [&](int dof) {
    return static_cast<int>(std::lower_bound(trace.begin(), trace.end(), dof) - trace.begin());
  };
  base::Matrix forces(static_cast<int>(trace.size()), count), traces;
  for (int j = 0; j < count; ++j) {
    const auto& [first, second] = jumps[j];
    forces(rowOf(first), j) = -1.0;
    forces(rowOf(second), j) = 1.0;
  }
  solver.solveTrace(forces, traces, substructure::Precision::exact);
  compliance_.shape(count, count);
  for (int j = 0; j < count; ++j) {
    for (int i = 0; i < count; ++i) {
      const auto& [first, second] = jumps[i];
      compliance_(i, j) = traces(rowOf(second), j) - traces(rowOf(first), j);
    }
  }
  base::Matrix sources(matrices.right().numRows(), 3), fields;
  std::copy_n(matrices.right().values(), sources.numRows(), sources[0]);
  for (int c = 0; c < 2; ++c) std::copy_n(matrices.reader()[c], sources.numRows(), sources[1 + c]);
  solver.solve(sources, fields);
  base::Matrix onJumps(count, 3);
  for (int i = 0; i < count; ++i) {
    const auto& [first, second] = jumps[i];
    for (int c = 0; c < 3; ++c) onJumps(i, c) = fields(second, c) - fields(first, c);
  }
  mean_ = matrices.read(part(fields, 0, fields.numRows(), 0, 1));

  const Teuchos::BLAS<int, double> blas;
  for (std::size_t g = 0; g < 2; ++g) {
    const base::Matrix lower = factoredStiffness(glue, g);
    const int first = static_cast<int>(g) * size_;
    blas.TRMM(Teuchos::LEFT_SIDE, Teuchos::LOWER_TRI, Teuchos::TRANS, Teuchos::NON_UNIT_DIAG, size_, count, 1.0,
              lower.values(), lower.stride(), &compliance_(first, 0), compliance_.stride());
    blas.TRMM(Teuchos::RIGHT_SIDE, Teuchos::LOWER_TRI, Teuchos::NO_TRANS, Teuchos::NON_UNIT_DIAG, count, size_, 1.0,
              lower.values(), lower.stride(), compliance_[first], compliance_.stride());
    blas.TRMM(Teuchos::LEFT_SIDE, Teuchos::LOWER_TRI, Teuchos::TRANS, Teuchos::NON_UNIT_DIAG, size_, 3, 1.0,
              lower.values(), lower.stride(), &onJumps(first, 0), onJumps.stride());
  }
  driven_ = part(onJumps, 0, count, 0, 1);
  read_ = part(onJumps, 0, count, 1, 2);
}

PointDisplacement CondensedMonteCarlo::solveDense(const std::vector<double>& factors) const {
  const int count = jumps();
  base::Matrix matrix(compliance_), y(driven_);
  for (int j = 0; j < count; ++j) {
    const double change = factors[j < size_ ? 0 : 1] - 1.0;
    for (int i = 0; i < count; ++i) matrix(i, j) *= change;
    matrix(j, j) += 1.0;
  }
  std::vector<int> pivots(count);
  int info = 0;
  Teuchos::LAPACK<int, double>().GESV(count, 1, matrix.values(), matrix.stride(), pivots.data(), y.values(), y.stride(),
                                      &info);
  check(info, "GESV");
  PointDisplacement result = mean_;
  for (int c = 0; c < 2; ++c) {
    for (int i = 0; i < count; ++i) {
      result[c] -= read_(i, c) * (factors[i < size_ ? 0 : 1] - 1.0) * y(i, 0);
    }
  }
  return result;
}

void CondensedMonteCarlo::diagonalise() {
  const Teuchos::LAPACK<int, double> lapack;
  std::array<base::Matrix, 2> vectors;
  std::vector<double> work(40 * size_);
  int info = 0;
  for (std::size_t g = 0; g < 2; ++g) {
    const int first = static_cast<int>(g) * size_;
    vectors[g] = part(compliance_, first, size_, first, size_);
    values_[g].resize(size_);
    lapack.SYEV('V', 'L', size_, vectors[g].values(), vectors[g].stride(), values_[g].data(), work.data(),
                static_cast<int>(work.size()), &info);
    check(info, "SYEV");
    rotatedDriven_[g] = product(Teuchos::TRANS, vectors[g], Teuchos::NO_TRANS, part(driven_, first, size_, 0, 1));
    rotatedRead_[g] = product(Teuchos::TRANS, vectors[g], Teuchos::NO_TRANS, part(read_, first, size_, 0, 2));
  }
  base::Matrix coupling =
      product(Teuchos::TRANS, vectors[0], Teuchos::NO_TRANS,
              product(Teuchos::NO_TRANS, part(compliance_, 0, size_, size_, size_), Teuchos::NO_TRANS, vectors[1]));
  base::Matrix left(size_, size_), right(size_, size_);
  std::vector<double> singular(size_);
  lapack.GESVD('S', 'S', size_, size_, coupling.values(), coupling.stride(), singular.data(), left.values(),
               left.stride(), right.values(), right.stride(), work.data(), static_cast<int>(work.size()), nullptr,
               &info);
  check(info, "GESVD");
  rank_ = static_cast<int>(std::count_if(singular.begin(), singular.end(),
                                         [&](double value) { return value > negligible * singular.front(); }));
  coupling_[0] = part(left, 0, size_, 0, rank_);
  coupling_[1].shape(size_, rank_);
  for (int j = 0; j < rank_; ++j) {
    for (int i = 0; i < size_; ++i) coupling_[1](i, j) = singular[j] * right(j, i);
  }
}

PointDisplacement CondensedMonteCarlo::solve(const std::vector<double>& factors) const {
  // z_1 = R_1 (g_1 - d_2 P s), z_2 = R_2 (g_2 - d_1 Q t) with R = (I + d Lambda)^-1, s = Q^T z_2, t = P^T z_1.
  std::array<double, 2> change = {factors[0] - 1.0, factors[1] - 1.0};
  std::array<base::Matrix, 2> scaled, reduced;  // R P or R Q; its product with P or Q, and with g
  for (std::size_t g = 0; g < 2; ++g) {
    scaled[g] = coupling_[g];
    for (int j = 0; j < rank_; ++j) {
      for (int i = 0; i < size_; ++i) scaled[g](i, j) /= 1.0 + change[g] * values_[g][i];
    }
    reduced[g] = product(Teuchos::TRANS, scaled[g], Teuchos::NO_TRANS, coupling_[g]);
  }
  const base::Matrix freeT = product(Teuchos::TRANS, scaled[0], Teuchos::NO_TRANS, rotatedDriven_[0]);
  const base::Matrix freeS = product(Teuchos::TRANS, scaled[1], Teuchos::NO_TRANS, rotatedDriven_[1]);
  base::Matrix matrix = product(Teuchos::NO_TRANS, reduced[0], Teuchos::NO_TRANS, reduced[1]);
  matrix.scale(-change[0] * change[1]);
  for (int i = 0; i < rank_; ++i) matrix(i, i) += 1.0;
  base::Matrix t = product(Teuchos::NO_TRANS, reduced[0], Teuchos::NO_TRANS, freeS);
  t.scale(-change[1]);
  t += freeT;
  std::vector<int> pivots(rank_);
  int info = 0;
  Teuchos::LAPACK<int, double>().GESV(rank_, 1, matrix.values(), matrix.stride(), pivots.data(), t.values(), t.stride(),
                                      &info);
  check(info, "GESV");
  base::Matrix s = product(Teuchos::NO_TRANS, reduced[1], Teuchos::NO_TRANS, t);
  s.scale(-change[0]);
  s += freeS;
  PointDisplacement result = mean_;
  for (std::size_t g = 0; g < 2; ++g) {
    const base::Matrix pull = product(Teuchos::NO_TRANS, coupling_[g], Teuchos::NO_TRANS, g == 0 ? s : t);
    for (int i = 0; i < size_; ++i) {
      const double z = (rotatedDriven_[g](i, 0) - change[1 - g] * pull(i, 0)) / (1.0 + change[g] * values_[g][i]);
      for (int c = 0; c < 2; ++c) result[c] -= rotatedRead_[g](i, c) * change[g] * z;
    }
  }
  return result;
}

}  // namespace harmos::benchmarks
