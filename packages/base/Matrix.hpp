#pragma once

#include <Teuchos_SerialDenseMatrix.hpp>

namespace harmos::base {

/// Dense column-major matrix: rows are degrees of freedom, columns are load steps (and, in studies, configurations).
/// The unit is that of what it holds.
using Matrix = Teuchos::SerialDenseMatrix<int, double>;

}  // namespace harmos::base
