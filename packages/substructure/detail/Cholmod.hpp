#pragma once

// Private to this package; heavy.
#include <algorithm>
#include <cassert>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <cholmod.h>

#include <harmos/substructure/SingleFactor.hpp>
#include <harmos/substructure/SolverOptions.hpp>
#include <harmos/substructure/TraceFactor.hpp>
#include <harmos/substructure/detail/SolverAdapter.hpp>
#include <harmos/substructure/detail/TooLarge.hpp>

namespace harmos::substructure {

/// CHOLMOD's supernodal Cholesky factorisation as an Amesos2 solver, for symmetric positive definite matrices on one
/// process. A numeric factorisation after the first reuses the symbolic one; block solves reuse their workspaces and
/// read and write the vectors in place. Throws std::runtime_error when the matrix is not positive definite,
/// TooLarge when it does not fit.
///
/// Systems that are loaded and read at some rows only (the trace) need nothing but the part of the factor that belongs
/// to these rows when they are eliminated last: A = L L^T gives A^-1 = (L_bb L_bb^T)^-1 on the trace. They are ordered
/// last when that takes fewer operations than a solve with the sparse factor.
///
/// Source: Chen, Davis, Hager, Rajamanickam, ACM Trans. Math. Softw. 35(3) (2008), doi:10.1145/1391989.1391995.
template <class Matrix, class Vector>
class Cholmod : public Amesos2::SolverCore<Cholmod, Matrix, Vector> {
  friend class Amesos2::SolverCore<harmos::substructure::Cholmod, Matrix, Vector>;
  using Core = Amesos2::SolverCore<harmos::substructure::Cholmod, Matrix, Vector>;
  using Vectors = Amesos2::MultiVecAdapter<Vector>;

 public:
  static constexpr const char* name = "Cholmod";

  /// `trace`: rows, ascending; empty: all. `options`: say whether it is worth its dense factor.
  Cholmod(Teuchos::RCP<const Matrix> a, Teuchos::RCP<Vector> x, Teuchos::RCP<const Vector> b, std::vector<int> trace,
          SolverOptions options)
      : Core(a, x, b), trace_(std::move(trace)), options_(std::move(options)) {
    cholmod_start(&common_);
    common_.print = 0;
    common_.supernodal = CHOLMOD_SUPERNODAL;
    // Wider supernodes than by default: a third less time to factor for a quarter more memory.
    common_.nrelax[0] = 16;
    common_.nrelax[1] = 48;
    common_.nrelax[2] = 128;
    common_.zrelax[1] = 0.3;
    common_.zrelax[2] = 0.1;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_GIVEN;
  }
  ~Cholmod() override {
    cholmod_free_factor(&factor_, &common_);
    cholmod_free_dense(&work_, &common_);
    cholmod_free_dense(&extraWork_, &common_);
    cholmod_finish(&common_);
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;

  /// Once factored: L_bb of the trace, or null when the trace was not ordered last.
  std::unique_ptr<TraceFactor> traceFactor() const {
    if (!traceIsLast_) return nullptr;
    const auto* permutation = static_cast<const int*>(factor_->Perm);
    const auto* firstColumn = static_cast<const int*>(factor_->super);
    const auto* firstIndex = static_cast<const int*>(factor_->pi);
    const auto* firstValue = static_cast<const int*>(factor_->px);
    const auto* rows = static_cast<const int*>(factor_->s);
    const auto* values = static_cast<const double*>(factor_->x);
    // CHOLMOD postorders the elimination tree: trace and other rows may alternate, but nothing else lies above a row of
    // the trace in that tree. A supernode may still hold other rows below a column of the trace: those of a sibling
    // that was merged into their common parent. L is zero there.
    std::vector<int> inTrace(factor_->n, -1), number(factor_->n, -1);
    for (std::size_t i = 0; i < trace_.size(); ++i) inTrace[trace_[i]] = static_cast<int>(i);
    auto result = std::make_unique<TraceFactor>();
    result->isToBeInverted = isToBeInverted_;
    for (std::size_t k = 0; k < factor_->n; ++k) {
      const int at = inTrace[permutation[k]];
      if (at < 0) continue;
      number[k] = static_cast<int>(result->order.size());
      result->order.push_back(at);
    }
    const auto count = static_cast<int>(trace_.size());
    result->lower = LowerTriangle(count);
    for (std::size_t super = 0; super < factor_->nsuper; ++super) {
      const int height = firstIndex[super + 1] - firstIndex[super];
      for (int j = firstColumn[super]; j < firstColumn[super + 1]; ++j) {
        const int column = number[j];
        if (column < 0) continue;
        const int within = j - firstColumn[super];
        for (int i = within; i < height; ++i) {
          const int row = number[rows[firstIndex[super] + i]];
          if (row >= 0) result->lower(row, column) = values[firstValue[super] + within * height + i];
        }
      }
    }
    return result;
  }

  /// Once factored: the factor in single precision, or null when it is not supernodal.
  std::unique_ptr<SingleFactor> singleFactor() const {
    if (!factor_->is_super) return nullptr;
    const auto* permutation = static_cast<const int*>(factor_->Perm);
    const auto* firstColumn = static_cast<const int*>(factor_->super);
    const auto* firstIndex = static_cast<const int*>(factor_->pi);
    const auto* firstValue = static_cast<const int*>(factor_->px);
    const auto* rows = static_cast<const int*>(factor_->s);
    const auto* values = static_cast<const double*>(factor_->x);
    auto result =
        std::make_unique<SingleFactor>(std::vector<int>(permutation, permutation + factor_->n), factor_->xsize);
    for (std::size_t s = 0; s < factor_->nsuper; ++s) {
      result->add(firstColumn[s + 1] - firstColumn[s], firstIndex[s + 1] - firstIndex[s], rows + firstIndex[s],
                  values + firstValue[s]);
    }
    return result;
  }

 private:
  int preOrdering_impl() { return 0; }

  int symbolicFactorization_impl() {
    const Rows rows(*this->matrixA_);
    NestedDissection dissection(rows.rows(), rows.pointers.data(), rows.columns.data());
    const double entries = dissection.factorSize().nonzeros;
    const auto size = static_cast<double>(trace_.size());
    traceIsLast_ = options_.keepsDense(size, entries);
    isToBeInverted_ = options_.inverts(size, entries);
    if (traceIsLast_) {
      dissection = NestedDissection(rows.rows(), rows.pointers.data(), rows.columns.data(), trace_);
    }
    std::vector<int> order = dissection.ordering().old;
    cholmod_free_factor(&factor_, &common_);
    std::vector<int> pointers;
    cholmod_sparse matrix = lowerTriangle(rows, pointers);
    factor_ = cholmod_analyze_p(&matrix, order.data(), nullptr, 0, &common_);
    check();
    return 0;
  }

  int numericFactorization_impl() {
    const Rows rows(*this->matrixA_);
    std::vector<int> pointers;
    cholmod_sparse matrix = lowerTriangle(rows, pointers);
    cholmod_factorize(&matrix, factor_, &common_);
    check();
    this->setNnzLU(factor_->is_super ? factor_->xsize : factor_->nzmax);
    return 0;
  }

  int solve_impl(const Teuchos::Ptr<Vectors> x, const Teuchos::Ptr<const Vectors> b) const {
    cholmod_dense right = dense(const_cast<double*>(valuesOf(b)), b->getGlobalNumVectors(), b->getStride());
    cholmod_dense left = dense(valuesOf(x), x->getGlobalNumVectors(), x->getStride());
    cholmod_dense* target = &left;
    assert(left.d == left.nrow && "SubstructureSolver::solve() has let gaps between the columns of a solution pass");
    cholmod_solve2(CHOLMOD_A, factor_, &right, nullptr, &target, nullptr, &work_, &extraWork_, &common_);
    check();
    return 0;
  }

  bool matrixShapeOK_impl() const { return this->globalNumRows_ == this->globalNumCols_; }
  void setParameters_impl(const Teuchos::RCP<Teuchos::ParameterList>&) {}
  Teuchos::RCP<const Teuchos::ParameterList> getValidParameters_impl() const { return Teuchos::parameterList(); }
  bool loadA_impl(Amesos2::EPhase) { return true; }

  using Rows = CompressedRows<Amesos2::MatrixAdapter<Matrix>>;

  /// Rows of a symmetric matrix are its columns; CHOLMOD skips the entries above the diagonal. It wants int pointers.
  static cholmod_sparse lowerTriangle(const Rows& rows, std::vector<int>& pointers) {
    pointers.assign(rows.pointers.data(), rows.pointers.data() + rows.pointers.extent(0));
    cholmod_sparse matrix{};
    matrix.nrow = matrix.ncol = static_cast<std::size_t>(rows.rows());
    matrix.nzmax = rows.columns.extent(0);
    matrix.p = pointers.data();
    matrix.i = rows.columns.data();
    matrix.x = rows.values.data();
    matrix.stype = -1;
    matrix.itype = CHOLMOD_INT;
    matrix.xtype = CHOLMOD_REAL;
    matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = 1;
    matrix.packed = 1;
    return matrix;
  }

  cholmod_dense dense(double* values, std::size_t columns, std::size_t stride) const {
    cholmod_dense block{};
    block.nrow = this->globalNumRows_;
    block.ncol = columns;
    block.d = std::max<std::size_t>(stride, block.nrow);
    block.nzmax = block.d * columns;
    block.x = values;
    block.xtype = CHOLMOD_REAL;
    block.dtype = CHOLMOD_DOUBLE;
    return block;
  }

  void check() const {
    const int status = common_.status;
    common_.status = CHOLMOD_OK;
    if (status == CHOLMOD_OUT_OF_MEMORY) throw TooLarge("Cholmod: out of memory");
    if (status == CHOLMOD_TOO_LARGE) throw TooLarge("Cholmod: the factor is too large for 32-bit indices");
    if (status < 0) throw std::runtime_error("Cholmod: error " + std::to_string(status));
    if (status == CHOLMOD_NOT_POSDEF || (factor_ && factor_->minor < factor_->n)) {
      throw std::runtime_error("Cholmod: the matrix is not positive definite");
    }
  }

  std::vector<int> trace_;
  SolverOptions options_;
  bool traceIsLast_ = false;
  bool isToBeInverted_ = false;
  mutable cholmod_common common_{};
  mutable cholmod_factor* factor_ = nullptr;
  mutable cholmod_dense* work_ = nullptr;       // kept between solves
  mutable cholmod_dense* extraWork_ = nullptr;  // kept between solves
};

}  // namespace harmos::substructure

template <>
struct Amesos2::solver_traits<harmos::substructure::Cholmod> {
  using supported_scalars = Amesos2::Meta::make_list1<double>;
};
