#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>

namespace harmos::latin {

/// Eigenvalues of a symmetric matrix in ascending order; the columns of `matrix` become the eigenvectors. Throws
/// base::Error when LAPACK fails.
std::vector<double> symmetricEigen(base::Matrix& matrix);

}  // namespace harmos::latin
