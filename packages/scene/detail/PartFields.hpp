#pragma once

#include <vector>

#include <Teuchos_Comm.hpp>

#include <harmos/base/Matrix.hpp>
#include <harmos/recovery/TractionCorrection.hpp>
#include <harmos/scene/Problem.hpp>
#include <harmos/scene/detail/PartPieces.hpp>

namespace harmos::scene {

/// A part of the scene as one, with fields on its nodes.
struct WholePart : PartPieces {
  base::Matrix displacements;              ///< dofs x columns; of nodes of several bodies the mean
  std::vector<bool> boundary;              ///< per node: it lies on the surface of the part
  std::vector<bool> skipped;               ///< per node: a concentrated force acts there
  std::vector<recovery::KnownFace> faces;  ///< of the surface, where tractions are known in all columns
};

/// The parts of a problem (partPieces()), complete on every rank. `fields`: a column for each, and for each body its
/// displacements (empty: of bodies of other ranks). The first are solutions, at `steps`, with the prescribed tractions
/// of these load steps; `loads`: the forces on nodes of the first columns behind them. Collective.
std::vector<WholePart> wholeParts(const Problem& problem, std::vector<PartPieces> pieces,
                                  const std::vector<std::vector<std::vector<double>>>& fields,
                                  const std::vector<int>& steps, const std::vector<latin::ResponseGradient>& loads,
                                  const Teuchos::Comm<int>& comm);

}  // namespace harmos::scene
