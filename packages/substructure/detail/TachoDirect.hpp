#pragma once

// Private to this package; heavy.
#include <Tacho_Driver.hpp>

#include <harmos/substructure/detail/SolverAdapter.hpp>

namespace harmos::substructure {

/// Tacho's supernodal Cholesky factorisation as an Amesos2 solver, for symmetric positive definite matrices on one
/// process. Amesos2's own adapter of Trilinos 13.2 never calls Driver::initialize() and crashes from 1024 unknowns on;
/// and without METIS in Tacho the order has to come from here. Throws std::runtime_error when the matrix is not
/// positive definite.
///
/// Source: Kim, Edwards, Rajamanickam, "Tacho: memory-scalable task parallel sparse Cholesky factorization", IPDPSW
/// 2018.
template <class Matrix, class Vector>
class TachoDirect : public Amesos2::SolverCore<TachoDirect, Matrix, Vector> {
  friend class Amesos2::SolverCore<harmos::substructure::TachoDirect, Matrix, Vector>;
  using Core = Amesos2::SolverCore<harmos::substructure::TachoDirect, Matrix, Vector>;
  using Vectors = Amesos2::MultiVecAdapter<Vector>;
  using Driver = Tacho::Driver<double, Kokkos::Device<Kokkos::Serial, Kokkos::HostSpace>>;

 public:
  static constexpr const char* name = "Tacho";

  TachoDirect(Teuchos::RCP<const Matrix> a, Teuchos::RCP<Vector> x, Teuchos::RCP<const Vector> b) : Core(a, x, b) {
    driver_.setMatrixType(2, true);
  }
  ~TachoDirect() override { driver_.release(); }
  TachoDirect(const TachoDirect&) = delete;
  TachoDirect& operator=(const TachoDirect&) = delete;

 private:
  int preOrdering_impl() { return 0; }

  int symbolicFactorization_impl() {
    const Rows rows(*this->matrixA_);
    const NestedDissection dissection(rows.rows(), rows.pointers.data(), rows.columns.data());
    this->setNnzLU(static_cast<std::size_t>(dissection.factorSize().nonzeros));
    const typename Driver::size_type_array pointers(const_cast<std::size_t*>(rows.pointers.data()),
                                                    rows.pointers.extent(0));
    const typename Driver::ordinal_type_array columns(rows.columns.data(), rows.columns.extent(0));
    driver_.analyze(rows.rows(), pointers, columns, copyOf(dissection.ordering().old),
                    copyOf(dissection.ordering().position), true);
    driver_.initialize();
    return 0;
  }

  int numericFactorization_impl() {
    const Rows rows(*this->matrixA_);
    driver_.factorize(typename Driver::value_type_array(rows.values.data(), rows.values.extent(0)));
    return 0;
  }

  int solve_impl(const Teuchos::Ptr<Vectors> x, const Teuchos::Ptr<const Vectors> b) const {
    const std::size_t rows = this->globalNumRows_;
    const std::size_t columns = x->getGlobalNumVectors();
    if (columns > 1 && (x->getStride() != rows || b->getStride() != rows)) {
      throw std::runtime_error("Tacho: blocks of vectors must be stored without gaps");
    }
    if (work_.extent(1) < columns) {
      work_ = Block(Kokkos::ViewAllocateWithoutInitializing("work"), rows, columns);
    }
    driver_.solve(Block(valuesOf(x), rows, columns), Block(const_cast<double*>(valuesOf(b)), rows, columns),
                  Block(work_.data(), rows, columns));
    return 0;
  }

  bool matrixShapeOK_impl() const { return this->globalNumRows_ == this->globalNumCols_; }
  void setParameters_impl(const Teuchos::RCP<Teuchos::ParameterList>&) {}
  Teuchos::RCP<const Teuchos::ParameterList> getValidParameters_impl() const { return Teuchos::parameterList(); }
  bool loadA_impl(Amesos2::EPhase) { return true; }

  using Rows = CompressedRows<Amesos2::MatrixAdapter<Matrix>>;
  using Block = typename Driver::value_type_matrix;

  static typename Driver::ordinal_type_array copyOf(const std::vector<int>& source) {
    typename Driver::ordinal_type_array view(Kokkos::ViewAllocateWithoutInitializing("order"), source.size());
    std::copy(source.begin(), source.end(), view.data());
    return view;
  }

  mutable Driver driver_;
  mutable Block work_;  // kept between solves
};

}  // namespace harmos::substructure

template <>
struct Amesos2::solver_traits<harmos::substructure::TachoDirect> {
  using supported_scalars = Amesos2::Meta::make_list1<double>;
};
