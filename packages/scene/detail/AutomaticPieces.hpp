#pragma once

#include <map>
#include <set>
#include <string>

#include <Teuchos_Comm.hpp>

#include <harmos/assembly/Interface.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/scene/Bodies.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::scene {

/// Into how many pieces parts are cut that the scene leaves as they are, or which of them are not factored.
struct PieceChoice {
  std::map<std::string, int> pieces;  ///< by name of the part, more than 1; those of other parts are given
  std::set<std::string> iterated;     ///< names of parts that are solved iteratively; only where nothing is cut
  std::string text;                   ///< what it saves, a sentence; empty: nothing is chosen
};

/// Cuts large parts without "Pieces" where that takes clearly less time by the model of estimateCost(), or where they
/// do not fit as they are: into `freeBytes` [byte] of all ranks, or into the numbers of solvers. With several ranks the
/// time is that of the busiest one. `whole`: bodies as the scene gives them, and their `interfaces`.
///
/// Nothing is cut where no cuts were measured: where loads are found, laws soften, the accuracy is high, or the
/// iteration is not the accelerated one of displacements; nor are parts that an interface divides. Where the scene does
/// not fit, nor in pieces, large parts without "Linear Solver" are solved iteratively, those with the largest factors
/// first, as many as are needed and if it fits then. Of unknowns, entries and neighbours of pieces that do not exist
/// yet only the order is known, so that little gains are left. The same on every rank. Throws base::Error when METIS
/// fails.
PieceChoice choosePieces(const Scene& scene, const mesh::Mesh& mesh, const Bodies& whole,
                         const std::vector<assembly::Interface>& interfaces, int dimension, int ranks,
                         double freeBytes);

}  // namespace harmos::scene
