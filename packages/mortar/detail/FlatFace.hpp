#pragma once

#include <cmath>
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
  Parent parentOf(const Flat& place) const {
    if (!isBilinear_) return otherParentOf(place);
    // place - origin = xi first + eta second + xi eta mixed, crossed with second + xi mixed.
    const Flat arm = {place[0] - origin_[0], place[1] - origin_[1]};
    const double linear = area_ - cross(arm, mixed_), right = cross(arm, second_);
    const double discriminant = linear * linear + 4.0 * square_ * right;
    if (!(discriminant >= 0.0)) return otherParentOf(place);
    // Of the two solutions the one that is left when the face is a parallelogram.
    const double xi = 2.0 * right / (linear + std::copysign(std::sqrt(discriminant), area_));
    const Flat along = {second_[0] + xi * mixed_[0], second_[1] + xi * mixed_[1]};
    const Flat rest = {arm[0] - xi * first_[0], arm[1] - xi * first_[1]};
    const double eta = (rest[0] * along[0] + rest[1] * along[1]) / (along[0] * along[0] + along[1] * along[1]);
    if (!std::isfinite(xi) || !std::isfinite(eta)) return otherParentOf(place);
    return {xi, eta};
  }

 private:
  /// A place and the derivatives to both parent coordinates.
  struct Image {
    Flat place{}, first{}, second{};
  };
  Image imageOf(const Parent& parent) const;
  Image cornerImageOf(const Parent& parent) const;
  /// In closed form where the face is an affine image of its parent, otherwise by Newton's method.
  Parent otherParentOf(const Flat& place) const;
  static double cross(const Flat& x, const Flat& y) { return x[0] * y[1] - x[1] * y[0]; }

  const FaceShape& shape_;
  std::array<Flat, FaceShape::mostNodes> node_;   // their places
  Flat origin_{}, first_{}, second_{}, mixed_{};  // of the image by the corners: the last one of quadrilaterals
  double size_ = 0.0, distortion_ = 0.0;
  double area_ = 0.0, square_ = 0.0;  // first x second and first x mixed
  bool followsCorners_ = true;        // its nodes lie where the corners alone would have them
  bool isBilinear_ = false;           // and these do not make a parallelogram
};

}  // namespace harmos::mortar
