#pragma once

#include <optional>
#include <vector>

#include <harmos/mortar/detail/FaceShape.hpp>
#include <harmos/mortar/detail/Plane.hpp>

namespace harmos::mortar {

/// A face as it is seen along the normal of a plane: finds the parent coordinates of places on the plane, so that
/// x = sum_j N_j x_j holds there exactly, also outside of the face.
class FlatFace {
 public:
  /// `points`: coordinates of mesh nodes [length]; `nodes`: those of the face. The face must not be seen on edge.
  FlatFace(const FaceShape& shape, const std::vector<base::Vector3>& points, const std::vector<int>& nodes,
           const Plane& plane);

  /// Which shape functions belong to the parent coordinates.
  const FaceShape& shape() const { return shape_; }
  /// How far the face is from an affine image of its parent, over its size; 0 if it is one but for round-off [-].
  double distortion() const { return distortion_; }
  /// Mean length of its edges [length].
  double size() const { return size_; }
  /// The parent coordinates of a place: in closed form where the corners alone tell where the face is, otherwise by
  /// Newton's method. Where that does not converge, far outside of a distorted face, those of the last step.
  Parent parentOf(const Flat& place) const;

 private:
  /// A place and the derivatives to both parent coordinates.
  struct Image {
    Flat place{}, first{}, second{};
  };
  Image imageOf(const Parent& parent) const;
  Image cornerImageOf(const Parent& parent) const;
  /// Of the image by the corners; nothing where no place of the parent has it. `arm`: from the origin.
  std::optional<Parent> bilinearParentOf(const Flat& arm) const;

  const FaceShape& shape_;
  std::array<Flat, FaceShape::mostNodes> node_;   // their places
  Flat origin_{}, first_{}, second_{}, mixed_{};  // of the image by the corners: the last one of quadrilaterals
  double size_ = 0.0, distortion_ = 0.0;
  bool followsCorners_ = true;  // its nodes lie where the corners alone would have them
};

}  // namespace harmos::mortar
