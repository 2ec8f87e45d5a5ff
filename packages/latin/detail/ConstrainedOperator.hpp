#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Tpetra.hpp>
#include <harmos/substructure/BoundaryTerm.hpp>

namespace harmos::latin {

/// A = K + k h + s of a body, the projector P onto the directions that no boundary holds, and the degrees of freedom
/// that interfaces load: products, not solves.
class ConstrainedOperator {
 public:
  /// `stiffness`: K [force/length], which is shared.
  ConstrainedOperator(Teuchos::RCP<const base::CrsMatrix> stiffness, substructure::BoundaryTerm term);
  /// Whether another term of the same K makes the same A and P, up to round-off.
  bool has(const substructure::BoundaryTerm& term) const { return substructure::areEqual(term_, term); }

  const Teuchos::RCP<const base::CrsMatrix>& stiffness() const { return stiffness_; }  ///< K
  const substructure::BoundaryTerm& term() const { return term_; }                     ///< k h, s and P
  /// Degrees of freedom, ascending, of the nodes that interfaces load.
  const std::vector<int>& trace() const { return trace_; }
  /// Degrees of freedom, ascending, of the nodes that boundaries hold.
  const std::vector<int>& heldDofs() const { return heldDofs_; }
  /// Where a degree of freedom stands in trace(), or -1.
  int traceRow(int dof) const { return placeOf(trace_, dof); }
  /// Where a degree of freedom stands in heldDofs(), or -1.
  int heldRow(int dof) const { return placeOf(heldDofs_, dof); }
  /// Place of a node among those that are held, or -1.
  int heldPlace(int node) const;

  /// P x, all rows.
  void project(base::Matrix& vectors) const;
  /// The same for the rows of trace().
  void projectTrace(base::Matrix& vectors) const;
  /// These rows, ascending and whole nodes, of A u.
  void multiply(const double* u, const std::vector<int>& rows, double* result) const;
  /// Adds the columns of A that belong to these dofs, ascending, to those of `to`, all rows.
  void addColumns(const std::vector<int>& dofs, base::Matrix& to) const;
  /// Euclidean norm of the diagonal of K + k h [force/length].
  double stiffnessNorm() const;
  /// Adds to forces[j] what round-off leaves in A u[j], in three shares, with e the spacing of numbers at 1 and a the
  /// diagonal of K + k h:
  /// - sum over j of +-e (a_ii a_jj)^1/2 u_j over the entries of K, signs by their places: what solves and factors do,
  ///   spared by no symmetry;
  /// - the same of u_j - u_i, signs by components and values of the entries: congruent elements are rounded alike, and
  ///   what they do to what neighbours move relative to each other adds up;
  /// - what the entries of K as they are make of translations, of which they should make nothing.
  /// Signs depend on `seed` besides.
  void addRoundOff(unsigned seed, const std::vector<const double*>& u, const std::vector<double*>& forces) const;

 private:
  static int placeOf(const std::vector<int>& dofs, int dof);
  std::vector<double> diagonal() const;
  void projectNode(const substructure::BoundaryTerm::NodeTensor& held, int row, base::Matrix& vectors) const;

  Teuchos::RCP<const base::CrsMatrix> stiffness_;
  substructure::BoundaryTerm term_;
  std::vector<int> trace_;
  std::vector<int> heldDofs_;
};

}  // namespace harmos::latin
