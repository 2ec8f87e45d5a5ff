#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Tpetra.hpp>
#include <harmos/mesh/Congruence.hpp>
#include <harmos/mesh/Mesh.hpp>

namespace harmos::substructure {

/// The rigid motion or mirror image that carries the representative body onto this one.
struct Congruence : mesh::Congruence {
  int representative = -1;  // index of the substructure whose operator is shared
};

/// One elastic body: a stiffness matrix and where its nodes are. It does not know where the matrix comes from.
///
/// Degrees of freedom are numbered node by node: dof = dimension * node + component.
struct Substructure {
  std::string name;
  int dimension = 3;
  std::vector<base::Vector3> nodes;               // coordinates [length], for rigid modes and output
  Teuchos::RCP<const base::CrsMatrix> stiffness;  // symmetric, square, on MPI_COMM_SELF; null on ranks that do not
                                                  // own this body, and for congruent bodies (their representative's)
  base::Matrix loads;                             // nodal forces [force], dofs x steps; 0 x 0 when there are none
  std::shared_ptr<const Congruence> congruence;   // null: has an operator of its own
};

}  // namespace harmos::substructure
