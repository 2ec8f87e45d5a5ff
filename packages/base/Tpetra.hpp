#pragma once

// The one place where Tpetra's template parameters are fixed: double on Debian's explicit instantiation.
#include <Teuchos_RCP.hpp>
#include <Tpetra_CrsMatrix_fwd.hpp>
#include <Tpetra_MultiVector_fwd.hpp>
#include <Tpetra_Operator_fwd.hpp>

namespace harmos::base {

/// Numbers rows and columns on a rank.
using LocalOrdinal = int;
/// Numbers rows and columns over all ranks; Harmos' matrices live on one rank, where both numbers agree.
using GlobalOrdinal = long long;
/// Sparse matrix in compressed rows. Only declared here: include Tpetra_CrsMatrix.hpp to use one.
using CrsMatrix = Tpetra::CrsMatrix<double, LocalOrdinal, GlobalOrdinal>;
/// Block of vectors, one per column. Only declared here: include Tpetra_MultiVector.hpp to use one.
using MultiVector = Tpetra::MultiVector<double, LocalOrdinal, GlobalOrdinal>;
/// What can be applied to vectors. Only declared here: include Tpetra_Operator.hpp to use one.
using Operator = Tpetra::Operator<double, LocalOrdinal, GlobalOrdinal>;

}  // namespace harmos::base
