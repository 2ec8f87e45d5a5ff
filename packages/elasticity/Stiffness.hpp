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
/// B is the strain of nodal displacements, C the material's stress from strain [stress] under the kinematics. Dofs are
/// numbered dimension * local node + component, components x, y, z. `thickness` [length] counts in 2-D only.
/// Formulation::bBar replaces the volume change by its element mean (Hughes, Int. J. Numer. Meth. Engng 15 (1980),
/// 1413-1418, doi:10.1002/nme.1620150914): for hex8, quad4, wedge6 and pyramid5, in 3-D and plane strain.
/// Formulation::incompatibleModes adds displacements 1 - xi^2 along each axis xi of hex8 and quad4, as ElementIntegrals
/// says; other elements of the part are as they are. Throws base::Error naming part, block and element: elements turned
/// inside out, folded or without volume, elements of another dimension than the kinematics, elements and nodes that are
/// not the mesh's and the part's, parts without an element that has incompatible modes, elements that B-bar cannot keep
/// from locking (tri3, tet4) or need not (quadratic ones, plane stress), and entries beyond base::largestNumber. Not
/// collective: the rank that owns the part assembles it. Nothing of the arguments is kept.
Teuchos::RCP<base::CrsMatrix> assembleStiffness(const mesh::Mesh& mesh, const mesh::Piece& piece,
                                                const Material& material, Formulation formulation,
                                                Kinematics kinematics, double thickness = 1.0);

}  // namespace harmos::elasticity
