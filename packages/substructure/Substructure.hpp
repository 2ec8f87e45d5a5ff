#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Tpetra.hpp>
#include <harmos/mesh/Congruence.hpp>
#include <harmos/mesh/Mesh.hpp>

/// Bodies as the solver sees them: a stiffness matrix each, its factor, and solves with it.
namespace harmos::substructure {

/// The rigid motion or mirror image that carries the representative body onto this one: x -> Q x + c, and K = R K' R^t
/// with K' its stiffness matrix and R the renumbering that turns every node by Q.
struct Congruence : mesh::Congruence {
  int representative = -1;  // index of the body whose operator is shared; has one of its own

  /// The representative's node of each node of the body, both from 0.
  std::vector<int> toRepresentative() const {
    std::vector<int> result(node.size());
    for (std::size_t a = 0; a < node.size(); ++a) result[node[a]] = static_cast<int>(a);
    return result;
  }
};

/// One elastic body: a stiffness matrix and where its nodes are. It does not know where the matrix comes from.
///
/// Degrees of freedom are numbered node by node: dof = dimension * node + component, components x, y, z.
struct Substructure {
  std::string name;                  // its own, that no other body has
  std::string part;                  // that users know and it is a piece of; empty: it is whole, and has its own name
  int dimension = 3;                 // 2 or 3
  std::vector<base::Vector3> nodes;  // coordinates [length], for rigid modes and output
  /// K [force/length], dofs x dofs, symmetric, both triangles stored, on MPI_COMM_SELF. Null on ranks that do not own
  /// this body, and for congruent bodies (their representative's counts).
  Teuchos::RCP<const base::CrsMatrix> stiffness;
  base::Matrix loads;                            // nodal forces [force], dofs x steps; 0 x 0 when there are none
  std::shared_ptr<const Congruence> congruence;  // null: has an operator of its own
  bool iterates = false;                         // its operator is too large to be factored: solved iteratively

  /// What messages call it: the name of the part, whatever pieces it is cut into.
  const std::string& partName() const { return part.empty() ? name : part; }
};

}  // namespace harmos::substructure
