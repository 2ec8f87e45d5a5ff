#pragma once

// The one place where Tpetra's template parameters are fixed: double on Debian's explicit instantiation.
#include <Teuchos_RCP.hpp>
#include <Tpetra_CrsMatrix_fwd.hpp>
#include <Tpetra_MultiVector_fwd.hpp>

namespace harmos::base {

using LocalOrdinal = int;
using GlobalOrdinal = long long;
using CrsMatrix = Tpetra::CrsMatrix<double, LocalOrdinal, GlobalOrdinal>;
using MultiVector = Tpetra::MultiVector<double, LocalOrdinal, GlobalOrdinal>;

}  // namespace harmos::base
