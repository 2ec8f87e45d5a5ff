#pragma once

// Private to this package: what Harmos' own Amesos2 solvers have in common. Heavy; include it in .cpp files only.
#include <memory>

#include <Amesos2_SolverCore.hpp>
#include <Amesos2_SolverCore_def.hpp>
#include <Amesos2_Util.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_MultiVector.hpp>

#include <harmos/substructure/NestedDissection.hpp>

namespace harmos::substructure {

/// The arrays of an adapter's matrix, not copied.
template <class Adapter>
struct CompressedRows {
  Kokkos::View<const std::size_t*, Kokkos::HostSpace> pointers;
  Kokkos::View<int*, Kokkos::HostSpace> columns;
  Kokkos::View<double*, Kokkos::HostSpace> values;

  explicit CompressedRows(const Adapter& matrix) {
    matrix.returnRowPtr_kokkos_view(pointers);
    matrix.returnColInd_kokkos_view(columns);
    matrix.returnValues_kokkos_view(values);
  }
  int rows() const { return static_cast<int>(pointers.extent(0)) - 1; }
};

/// First entry of a column-major block of vectors, not copied: Amesos2's own helpers copy blocks of several vectors.
template <class Adapter>
const double* valuesOf(const Teuchos::Ptr<const Adapter>& vectors) {
  return vectors->getVector(0)->getLocalViewHost(Tpetra::Access::ReadOnly).data();
}
template <class Adapter>
double* valuesOf(const Teuchos::Ptr<Adapter>& vectors) {
  return vectors->getVectorNonConst(0)->getLocalViewHost(Tpetra::Access::ReadWrite).data();
}

}  // namespace harmos::substructure
