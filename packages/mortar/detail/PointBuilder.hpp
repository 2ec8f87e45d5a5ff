#pragma once

#include <map>
#include <set>
#include <vector>

#include <harmos/mortar/JoinedSurface.hpp>
#include <harmos/mortar/detail/CreaseNodes.hpp>
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

  /// Leaves out the points of nodes at creases (see withoutCreases()), and gives their tractions to the other corners
  /// of their faces.
  void leaveOutCreases();

  /// Leaves out points, in the order of build(), and gives their tractions to the other corners of their faces; where
  /// nothing of a face would be left, the corner with the largest share stays. Returns how many it left out.
  int leaveOut(const std::vector<bool>& unwanted);

 private:
  struct Rows;
  PointKey keyOf(std::size_t coupling, int corner) const;
  /// Of a point, -1 if it is not kept.
  int numberOf(const PointKey& key) const;
  void keep(const std::set<PointKey>& points);
  using Corners = std::map<PointKey, int>;  // numbers in JoinedSurface::face of corners at creases
  /// Lists a face, `points` of whose corners are -1 where there is none.
  void addFace(std::size_t coupling, const std::vector<int>& points, Corners& corners, JoinedSurface& surface) const;

  const std::vector<mesh::Face>& faces_;
  const std::vector<FaceCoupling>& couplings_;
  std::vector<std::vector<int>> patch_;  // by coupling and corner
  std::map<PointKey, int> number_;       // of the points that are kept
  std::set<PointKey> creased_;           // points that were left out at creases
  std::map<int, PointKey> adopted_;      // by coupling
  int leftOut_ = 0;
};

}  // namespace harmos::mortar
