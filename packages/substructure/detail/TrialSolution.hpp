#pragma once

#include <harmos/base/Matrix.hpp>

namespace harmos::substructure {

/// Columns of entries between -1 and 1, as if by chance and the same at every call.
base::Matrix randomForces(int rows, int columns);

/// What one solution tells of a factored symmetric matrix.
enum class Definiteness { positive, singular, indefinite };

/// Judges A by the solution x that its factor gave for b = randomForces(rows, 1), and by the `residual` b - A x.
///
/// For every null vector v of A the residual r = b - A x of any x has v.r = v.b. A pseudo-random b has a component of
/// about |b|/sqrt(rows) along v, so that no solver can hide a singular matrix; a regular one leaves rounding errors
/// only. An indefinite one is seen only where the energy b.x is negative.
Definiteness judge(const base::Matrix& b, const base::Matrix& x, const base::Matrix& residual);

}  // namespace harmos::substructure
