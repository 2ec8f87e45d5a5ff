#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/substructure/BoundaryTerm.hpp>

namespace harmos::substructure {

/// Translations and small rotations, dofs x 3 or 6, about the first node and of about the same size.
base::Matrix rigidMotions(const std::vector<base::Vector3>& nodes, int dimension);

/// Whether what a boundary adds and holds resists every rigid motion, however softly; found by where it acts, so that
/// round-off of the stiffness has no say in it.
bool holdsRigidMotions(const BoundaryTerm& boundary, const std::vector<base::Vector3>& nodes);

/// Takes from each of the vectors, dofs x any number, the rigid motion that is closest to it (least squares).
void removeRigidMotions(const std::vector<base::Vector3>& nodes, int dimension, base::Matrix& vectors);

}  // namespace harmos::substructure
