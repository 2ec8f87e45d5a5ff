#pragma once

#include <map>
#include <utility>
#include <vector>

#include <harmos/mortar/JoinedSurface.hpp>
#include <harmos/mortar/detail/DualBasis.hpp>

namespace harmos::mortar {

/// Makes the points of an interface and their trace operators of the integrals over all faces of the mortar side. Keeps
/// references to both lists.
class PointBuilder {
 public:
  /// Numbers the points: a corner node has one for every smooth patch of covered faces around it, if enough of the area
  /// of these that belongs to it is covered. `faces`: of the mortar side; `creaseAngle` as for mesh::smoothPatches().
  PointBuilder(const std::vector<mesh::Face>& faces, const std::vector<FaceCoupling>& couplings, double creaseAngle);

  /// Nodes, patches, areas, normals (out of the mortar side), faces, operators (first of the mortar side, then of the
  /// other), and how many points were left out and which share of the mortar side's covered faces is not covered.
  JoinedSurface build() const;

  /// Leaves out points, in the order of build(), and gives their tractions to the other corners of their faces; where
  /// nothing of a face would be left, the corner with the largest share stays. Returns how many it left out.
  int leaveOut(const std::vector<bool>& unwanted);

 private:
  using Key = std::pair<int, int>;  // node, patch
  struct Rows;
  Key keyOf(std::size_t coupling, int corner) const;

  const std::vector<mesh::Face>& faces_;
  const std::vector<FaceCoupling>& couplings_;
  std::vector<std::vector<int>> patch_;  // by coupling and corner
  std::map<Key, int> number_;            // of the points that are kept
  int leftOut_ = 0;
};

}  // namespace harmos::mortar
