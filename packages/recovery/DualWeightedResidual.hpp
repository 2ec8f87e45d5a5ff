#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/elasticity/ElementPoints.hpp>
#include <harmos/recovery/TractionCorrection.hpp>

namespace harmos::recovery {

/// An adjoint among the fields of a part.
struct AdjointField {
  int solution;  ///< whose error it weighs, from 0
  int response;  ///< whose change that is, from 0; of one response there may be several
};

/// What a part adds to the mesh errors of responses.
struct PartResidual {
  std::vector<double> change;        ///< dJ of every response: the sum over the elements of dJ_E
  std::vector<double> absolute;      ///< the sum of |dJ_E|
  std::vector<double> uncorrected;   ///< dJ without the known tractions
  std::vector<double> work;          ///< int sigma : C^-1 : zeta dV, what the part adds to J on this mesh
  std::vector<double> absoluteWork;  ///< the sum of |int_E sigma : C^-1 : zeta dV|
  double errorEnergy = 0.0;          ///< int (sigma* - sigma) : C^-1 : (sigma* - sigma) dV [force length], solution 0
  double energy = 0.0;               ///< int sigma : C^-1 : sigma dV [force length], of solution 0
};

/// Change of responses J from this mesh to an infinitely fine one, the share of one part: of its elements E
///   dJ_E = int_E (sigma* - sigma) : C^-1 : (zeta* - zeta) dV
/// with sigma, zeta the stresses of the solution and of the adjoint of a response on this mesh, and sigma*, zeta* those
/// recovered from them (StressRecovery) and corrected where tractions are known (correctTractions()).
///
/// displacements: dofs x (solutions + adjoints), the solutions [length], such as those of several load steps, then
/// `adjoints` [unit of J per force], one column each: dJ is the sum over the adjoints of a response. Tractions of
/// `faces` likewise, temperatures of the solutions only. `skipped`: nodes at which a concentrated force acts. Throws as
/// these two. Not collective. Source: Becker, Rannacher (2001), doi:10.1017/S0962492901000010; Prudhomme, Oden (1999),
/// doi:10.1016/S0045-7825(98)00343-0.
PartResidual dualWeightedResidual(const elasticity::ElasticPart& part, const base::Matrix& displacements,
                                  const std::vector<AdjointField>& adjoints, const std::vector<bool>& boundary,
                                  const std::vector<KnownFace>& faces, const std::vector<bool>& skipped);

}  // namespace harmos::recovery
