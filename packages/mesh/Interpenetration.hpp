#pragma once

#include <string>
#include <vector>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {

/// How far one body reaches into another.
struct Interpenetration {
  int elements = 0;       ///< at the surface of the first, of those looked at, that reach into the second
  int element = -1;       ///< mesh element number of the one that reaches farthest; -1: none does
  double depth = 0.0;     ///< of a point just beneath its face, from the surface of the second [length]
  base::Vector3 place{};  ///< of that point [length]
};

/// Looks for elements at the surface of one body that lie inside another. A point a tenth of the way from the middle of
/// each face to that of its element is inside where the surface of the other body goes once around it (winding number
/// above one half); so bodies that touch, and facets of one curved surface that cut each other, do not count.
///
/// `skin1`, `skin2`: all faces of each body, whose normals point outwards; quadratic ones count as those with straight
/// edges. Of the first body no more than 500 faces are looked at, evenly chosen among those in the box around the
/// second. Not collective. Source: Van Oosterom, Strackee (1983), doi:10.1109/TBME.1983.325207.
Interpenetration interpenetration(const Mesh& mesh, const std::vector<Face>& skin1, const std::vector<Face>& skin2);

/// Throws base::Error(input), starting with `where`, if one of two parts with these skins reaches into the other: says
/// which, how far and where.
void demandNoOverlap(const Mesh& mesh, const std::string& where, const std::string& part1,
                     const std::vector<Face>& skin1, const std::string& part2, const std::vector<Face>& skin2);

}  // namespace harmos::mesh
