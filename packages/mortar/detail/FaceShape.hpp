#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace harmos::mortar {

/// A place in the parent domain of a face: [-1, 1] on an edge, the second one 0; the triangle (0, 0), (1, 0), (0, 1);
/// the square [-1, 1]^2. No dimension.
using Parent = std::array<double, 2>;

/// Shape functions of a face: edge2 and edge3 in the plane; tri3, quad4, tri6, quad8 and quad9 in space. Nodes as in
/// Exodus and Shards: corners, then mid-edge nodes, then the centre.
class FaceShape {
 public:
  /// Nodes of the largest face.
  static constexpr int mostNodes = 9;
  /// Corners of the largest face.
  static constexpr int mostCorners = 4;
  using Values = std::array<double, mostNodes>;
  using Gradients = std::array<std::array<double, 2>, mostNodes>;

  /// The shape of a face of so many nodes (2 or 3 of an edge where `dimension` is 2; 3, 4, 6, 8 or 9 in 3-D), which is
  /// not checked.
  static const FaceShape& of(int dimension, std::size_t nodes);

  /// How many nodes the face has.
  int nodes() const { return nodes_; }
  /// How many of them are corners; they come first.
  int corners() const { return corners_; }
  /// 1 on an edge, else 2.
  int parentDimension() const { return corners_ == 2 ? 1 : 2; }
  /// Of the shape functions in parent coordinates.
  int polynomialDegree() const { return degree_; }
  /// Whether there are nodes besides corners.
  bool isQuadratic() const { return nodes_ > corners_; }
  /// Where the nodes are.
  const std::vector<Parent>& places() const { return places_; }
  /// The corners of the parts, triangles and squares between nodes, by which a curved face is replaced; one, the face
  /// itself, if it is linear.
  const std::vector<std::vector<Parent>>& parts() const { return parts_; }

  /// N_j, one for each node.
  Values values(const Parent& at) const;
  /// The linear (bilinear) functions of its corners; 0 for those that it does not have.
  std::array<double, mostCorners> cornerValues(const Parent& at) const {
    if (corners_ == 3) return {1.0 - at[0] - at[1], at[0], at[1], 0.0};
    if (corners_ == 2) return {0.5 * (1.0 - at[0]), 0.5 * (1.0 + at[0]), 0.0, 0.0};
    const double low = 0.25 * (1.0 - at[1]), high = 0.25 * (1.0 + at[1]);
    return {(1.0 - at[0]) * low, (1.0 + at[0]) * low, (1.0 + at[0]) * high, (1.0 - at[0]) * high};
  }
  /// N_j and their derivatives to both parent coordinates.
  void evaluate(const Parent& at, Values& values, Gradients& gradients) const;

 private:
  FaceShape(int nodes, int corners, int degree, std::vector<std::vector<Parent>> parts);
  void triangle(const Parent& at, Values& values, Gradients& gradients) const;
  void square(const Parent& at, Values& values, Gradients& gradients) const;

  int nodes_, corners_, degree_;
  std::vector<Parent> places_;
  std::vector<std::vector<Parent>> parts_;
};

}  // namespace harmos::mortar
