#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Tpetra.hpp>
#include <harmos/mesh/Mesh.hpp>

namespace harmos::substructure {

/// A rigid motion (or mirror) that carries the representative body onto this one: x -> Q x + c, node by node.
struct Congruence {
  int representative = -1;                          // index of the substructure whose operator is shared
  std::vector<int> node;                            // node[a]: this body's local node that is the image of a
  std::array<std::array<double, 3>, 3> rotation{};  // Q, orthogonal, determinant +1 or -1
};

/// One elastic body: a stiffness matrix and where its nodes are. It does not know where the matrix comes from.
///
/// Degrees of freedom are numbered node by node: dof = dimension * node + component.
struct Substructure {
  std::string name;
  int dimension = 3;
  std::vector<mesh::Point> nodes;                 // coordinates [length], for rigid modes and output
  Teuchos::RCP<const base::CrsMatrix> stiffness;  // symmetric, square, on MPI_COMM_SELF; null on ranks that do not
                                                  // own this body, and for congruent bodies (their representative's)
  base::Matrix loads;                             // nodal forces [force], dofs x steps; 0 x 0 when there are none
  std::shared_ptr<const Congruence> congruence;   // null: has an operator of its own
};

}  // namespace harmos::substructure
