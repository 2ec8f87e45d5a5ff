#pragma once

#include <array>

#include <harmos/mortar/detail/FaceCoupling.hpp>

namespace harmos::mortar {

/// Functions psi_p = sum_q A_pq N_q of a face, biorthogonal to its corner functions on the part that is covered,
///
///     int psi_p N_q dS = delta_pq D_p,  D_p = int psi_p dS = int N_p dS,  sum_p psi_p = 1,
///
/// A = D M^-1 with M_pq = int N_p N_q dS over that part. Where corners are left out, their functions are shared out
/// among those neighbours along edges that are kept (if there are none, to the opposite corner), N'_p = sum_q S_pq N_q,
/// and psi is biorthogonal to these.
///
/// Source: Wohlmuth (2000), doi:10.1137/S0036142999350929; partly covered faces: Cichosz, Bischoff (2011),
/// doi:10.1016/j.cma.2010.11.004; Popp et al. (2013), doi:10.1137/120882743.
class DualBasis {
 public:
  /// `isKept`: for each corner, at least one. Where the common part is so thin that M is singular to round-off, the
  /// corner with the largest D_p gets the constant function and the others none.
  DualBasis(const FaceCoupling& face, std::array<bool, FaceShape::mostCorners> isKept);

  /// A_pq; rows of corners that are left out are 0.
  const CornerMatrix& coefficients() const { return coefficients_; }
  /// S_pq; rows of corners that are left out are 0.
  const CornerMatrix& shares() const { return shares_; }
  /// D_p [area]; 0 at corners that are left out.
  const CornerVector& areas() const { return areas_; }

 private:
  bool solve(const FaceCoupling& face, const std::array<bool, FaceShape::mostCorners>& isKept);

  CornerMatrix shares_{}, coefficients_{};
  CornerVector areas_{};
};

}  // namespace harmos::mortar
