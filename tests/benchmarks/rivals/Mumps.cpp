#include "Mumps.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include <mpi.h>

#include <harmos/base/Error.hpp>
#include <harmos/substructure/NestedDissection.hpp>

namespace harmos::benchmarks {
namespace {

constexpr int start = -1, end = -2, analyse = 1, factorise = 2, solution = 3;  // MUMPS' jobs

}  // namespace

Mumps::Mumps(const SparseMatrix& structure, Kind kind, int last) : kind_(kind), last_(last) {
  for (int i = 0; i < structure.rows(); ++i) {
    for (std::size_t k = structure.pointers[i]; k < structure.pointers[i + 1]; ++k) {
      if (kind == Kind::positiveDefinite && structure.columns[k] > i) continue;
      rows_.push_back(i + 1);
      columns_.push_back(structure.columns[k] + 1);
    }
  }
  values_.resize(rows_.size());
  lastRows_.resize(last);
  std::iota(lastRows_.begin(), lastRows_.end(), structure.rows() - last + 1);
  std::vector<int> ordered(last);
  std::iota(ordered.begin(), ordered.end(), structure.rows() - last);
  const substructure::NestedDissection dissection(structure.rows(), structure.pointers.data(), structure.columns.data(),
                                                  ordered);
  for (const int position : dissection.ordering().position) order_.push_back(position + 1);

  mumps_.sym = kind == Kind::positiveDefinite ? 1 : 0;
  mumps_.par = 1;
  mumps_.comm_fortran = MPI_Comm_c2f(MPI_COMM_SELF);
  run(start);
  const auto setting = [&](int number) -> int& { return mumps_.icntl[number - 1]; };
  for (const int stream : {1, 2, 3, 4}) setting(stream) = 0;  // says nothing
  setting(6) = 0;                                             // no permutation for the sake of the diagonal
  setting(7) = 1;                                             // in the order given
  setting(14) = 50;                                           // per cent of memory for pivoting
  mumps_.n = structure.rows();
  mumps_.nnz = static_cast<MUMPS_INT8>(rows_.size());
  mumps_.irn = rows_.data();
  mumps_.jcn = columns_.data();
  mumps_.a = values_.data();
  mumps_.perm_in = order_.data();
  if (last > 0) {
    setting(19) = 1;  // the Schur complement, on one process
    mumps_.size_schur = last;
    mumps_.listvar_schur = lastRows_.data();
  }
  run(analyse);
}

Mumps::~Mumps() {
  mumps_.job = end;
  dmumps_c(&mumps_);
}

void Mumps::run(int job) {
  mumps_.job = job;
  dmumps_c(&mumps_);
  if (mumps_.infog[0] < 0) {
    throw base::Error("MUMPS, job " + std::to_string(job) + ": error " + std::to_string(mumps_.infog[0]) + ", " +
                      std::to_string(mumps_.infog[1]));
  }
}

void Mumps::factor(const SparseMatrix& matrix) {
  std::size_t at = 0;
  for (int i = 0; i < matrix.rows(); ++i) {
    for (std::size_t k = matrix.pointers[i]; k < matrix.pointers[i + 1]; ++k) {
      if (kind_ == Kind::general || matrix.columns[k] <= i) values_[at++] = matrix.values[k];
    }
  }
  schur_.shape(last_, last_);
  mumps_.schur = schur_.values();
  run(factorise);
  if (kind_ != Kind::positiveDefinite) return;
  // MUMPS fills the rows of the lower triangle: the columns of the upper one.
  for (int j = 0; j < last_; ++j) {
    for (int i = 0; i < j; ++i) schur_(j, i) = schur_(i, j);
  }
}

void Mumps::solve(base::Matrix& x) {
  mumps_.nrhs = x.numCols();
  mumps_.lrhs = x.stride();
  mumps_.rhs = x.values();
  run(solution);
}

void Mumps::condense(base::Matrix& f) {
  base::Matrix reduced(last_, f.numCols());
  mumps_.nrhs = f.numCols();
  mumps_.lrhs = f.stride();
  mumps_.rhs = f.values();
  mumps_.redrhs = reduced.values();
  mumps_.lredrhs = reduced.stride();
  mumps_.icntl[25] = 1;
  run(solution);
  base::Matrix held(last_, f.numCols());  // back substitution with jumps that are 0
  mumps_.redrhs = held.values();
  mumps_.icntl[25] = 2;
  run(solution);
  mumps_.icntl[25] = 0;
  for (int c = 0; c < f.numCols(); ++c) std::copy_n(reduced[c], last_, f[c] + f.numRows() - last_);
}

}  // namespace harmos::benchmarks
