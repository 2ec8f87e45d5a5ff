#pragma once

#include <utility>
#include <vector>

// Without the older rescaling of coordinates to integers, of which g++ 12 believes that it reads what is not set.
#define BOOST_GEOMETRY_NO_ROBUSTNESS
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {

/// All faces of a part, with what finds those that may touch another part: of a plate that carries hundreds of parts a
/// few do so for each of them.
class PartSkin {
 public:
  /// `faces`: see skin().
  PartSkin(const Mesh& mesh, std::vector<Face> faces);

  /// All of them, as they were given.
  const std::vector<Face>& faces() const { return faces_; }
  /// Those, in the same order, that lie in the box around another part or are at most a hundredth of their size away:
  /// more than matchFaces(), matchNodes() and findOverlap() let faces be apart that touch.
  std::vector<Face> near(const PartSkin& other) const;

 private:
  using Corner = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Box = boost::geometry::model::box<Corner>;
  using Tree = boost::geometry::index::rtree<std::pair<Box, int>, boost::geometry::index::quadratic<16>>;

  static std::vector<std::pair<Box, int>> boxesOf(const Mesh& mesh, const std::vector<Face>& faces);

  std::vector<Face> faces_;
  Tree tree_;  // of their boxes
};

}  // namespace harmos::mesh
