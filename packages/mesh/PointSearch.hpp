#pragma once

#include <vector>

#include <harmos/mesh/Mesh.hpp>

namespace harmos::mesh {

/// Finds the points near a given one: a balanced k-d tree over a copy of the points, O(n log n) to build and about
/// O(log n) per query. Results do not depend on how ties are ordered in the tree.
/// Source: Bentley (1975), doi:10.1145/361002.361007.
class PointSearch {
 public:
  /// Builds the tree; the points [length] may be none, and several may lie at one place.
  explicit PointSearch(std::vector<base::Vector3> points);

  /// The point that is nearest to a place.
  struct Nearest {
    int index = -1;         // of the lowest-numbered among equally near points; -1 if there are no points
    double distance = 0.0;  // [length]
  };
  /// The nearest of the points to `point` [length].
  Nearest nearest(const base::Vector3& point) const;
  /// Indices of the points that are at most `radius` [length] away from `point`, ascending.
  std::vector<int> within(const base::Vector3& point, double radius) const;

 private:
  void build(std::size_t begin, std::size_t end);
  template <typename Visit>
  void visit(const base::Vector3& point, std::size_t begin, std::size_t end, double& radius, const Visit& found) const;

  std::vector<base::Vector3> points_;  // once the tree is built, in its order
  std::vector<int> order_;             // of the tree: the middle of a range is its root
  std::vector<int> axis_;              // that the root of each range splits
};

}  // namespace harmos::mesh
