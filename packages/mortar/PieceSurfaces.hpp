#pragma once

#include <array>
#include <string>
#include <vector>

#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/PieceMap.hpp>
#include <harmos/mortar/JoinSurfaces.hpp>

namespace harmos::mortar {

/// The surfaces of a joined interface between pieces of its parts.
struct PieceSurfaces {
  /// One for every pair of pieces that points join, by ascending pieces. Every point has its unknowns in one of them. A
  /// face is in the surface of its first point; those of its points that are in others are copies without area there.
  std::vector<mesh::InterfaceSurface> surfaces;
  std::array<int, 2> crossed{};  // points whose nodes on that side are in no common piece; they are in no surface
  base::Vector3 firstCrossed{};  // place of the first of them [length]
};

/// Divides an interface named `name` among pieces. `pieces`: all, as `map` has them; both sides as they were joined.
PieceSurfaces divideByPieces(const std::string& name, const JoinedSurface& joined, const Side& side1, const Side& side2,
                             const std::vector<mesh::Piece>& pieces, const mesh::PieceMap& map);

}  // namespace harmos::mortar
