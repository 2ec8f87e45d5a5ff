#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace harmos::mortar {

/// A corner node of the mortar side and a smooth patch of faces around it, counted from 0 at every node.
using PointKey = std::pair<int, int>;

/// The points that are left where nodes at creases have none.
struct SmoothPoints {
  std::set<PointKey> kept;
  std::map<int, PointKey> adopted;  // by faces none of whose own points are kept: the point that stands for all of them
};

/// Leaves out the points of nodes that have several, one in every patch around them, as mortar methods do where
/// interfaces meet. Ties would hold such a node once for each patch, and thereby differences of what the other side
/// sees of them, which makes that side too stiff and which hardly anything determines where it is as coarse.
///
/// A face without a point of its own that is kept adopts one of a neighbour in its patch, along an edge if it can;
/// where there is none, it keeps its first. `points`: of the corners of each face, those that there are.
///
/// Source: Wohlmuth (2000), doi:10.1137/S0036142999350929, of multipliers at the ends of an interface.
SmoothPoints withoutCreases(const std::vector<std::vector<PointKey>>& points);

}  // namespace harmos::mortar
