#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Tpetra.hpp>
#include <harmos/substructure/BoundaryTerm.hpp>

namespace harmos::substructure {

/// Products with A = P (K + k h + s) P + d (1 - P), see BoundaryTerm, in which K multiplies differences of
/// displacements between a node and those around it: sum over j of K_ij (u_j - u_i) instead of K_ij u_j.
///
/// An exact K annihilates translations; the rounded entries of one that is stored resist them like springs to the
/// ground, of about 1e-16 |K|, and those of congruent elements all alike, so that what they do adds up along a slender
/// part. Here they meet only what neighbours move relative to each other. Where K does resist a translation, as in
/// axisymmetry, that is kept.
class DifferenceProduct {
 public:
  /// `stiffness`: K [force/length], symmetric, both triangles stored, which is shared; as SubstructureSolver wants
  /// both.
  DifferenceProduct(Teuchos::RCP<const base::CrsMatrix> stiffness, BoundaryTerm boundary);

  /// P (b - A x) [force]: what x leaves of the equations in the directions that are not held, dofs x any number.
  base::Matrix residual(const base::Matrix& b, const base::Matrix& x) const;

 private:
  void project(base::Matrix& vectors) const;
  void subtractAdded(const double* x, double* from) const;

  Teuchos::RCP<const base::CrsMatrix> stiffness_;
  BoundaryTerm boundary_;
  std::vector<double> ofTranslation_;  // K times unit translations, `dimension` per row; empty: all are zero
};

}  // namespace harmos::substructure
