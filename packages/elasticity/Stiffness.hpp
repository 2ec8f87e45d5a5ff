#pragma once

#include <vector>

#include <harmos/base/Tpetra.hpp>
#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/elasticity/Material.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::elasticity {

/// Stiffness matrix of a part, K = int B^t C B dV [force/length], symmetric to the last bit, on MPI_COMM_SELF.
///
/// Dofs are numbered dimension * local node + component. `thickness` [length] counts in 2-D only. Formulation::bBar
/// replaces the volume change by its element mean (Hughes, Int. J. Numer. Meth. Engng 15 (1980), 1413-1418,
/// doi:10.1002/nme.1620150914): for hex8, quad4, wedge6 and pyramid5, in 3-D and plane strain.
/// Throws base::Error naming part, block and element: elements turned inside out or without volume, elements of another
/// dimension than the kinematics, and those that B-bar cannot keep from locking (tri3, tet4) or need not (plane
/// stress).
Teuchos::RCP<base::CrsMatrix> assembleStiffness(const mesh::Mesh& mesh, const mesh::Piece& piece,
                                                const Material& material, Formulation formulation,
                                                Kinematics kinematics, double thickness = 1.0);

/// Nodal forces of a uniform body force, f_a = force int N_a dV [force], one entry per dof of the part.
///
/// force [force/volume]; its third component must be 0 in 2-D. Throws base::Error as assembleStiffness does.
std::vector<double> bodyForce(const mesh::Mesh& mesh, const mesh::Piece& piece, const base::Vector3& force,
                              Kinematics kinematics, double thickness = 1.0);

}  // namespace harmos::elasticity
