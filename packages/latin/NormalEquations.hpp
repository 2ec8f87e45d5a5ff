#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>

namespace harmos::latin {

/// V^T V, both triangles; the share of this rank where the rows of V are spread over ranks. For few long columns, which
/// BLAS copies before it multiplies them.
base::Matrix gramMatrix(const base::Matrix& columns);

/// Coefficients c of least squares from the normal equations G c = b of the leading `size` columns.
///
/// Columns are scaled to length one and eliminated in the order of their independence (Cholesky with diagonal
/// pivoting); columns that depend on the others to within round-off get the coefficient 0, and so do columns whose
/// squared length is not above `floor`.
std::vector<double> solveNormalEquations(const base::Matrix& gram, int size, const double* right, double floor = 0.0);

}  // namespace harmos::latin
