#include <harmos/mortar/detail/FlatFace.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::mortar {
namespace {

constexpr double roundOff = 1e-12;  // of the size of the face
constexpr double converged = 1e-8;  // change of parent coordinates, after which the next one would be round-off
constexpr int mostSteps = 30;

Flat combine(double a, const Flat& x, double b, const Flat& y) {
  return {a * x[0] + b * y[0], a * x[1] + b * y[1]};
}

/// Solves first a + second b = right; in one dimension first a = right.
Parent solve(const Flat& first, const Flat& second, const Flat& right, int dimension) {
  if (dimension == 1) return {right[0] / first[0], 0.0};
  const double scale = 1.0 / (first[0] * second[1] - second[0] * first[1]);
  return {scale * (second[1] * right[0] - second[0] * right[1]), scale * (first[0] * right[1] - first[1] * right[0])};
}

double length(const Flat& x) {
  return std::sqrt(x[0] * x[0] + x[1] * x[1]);
}

}  // namespace

FlatFace::FlatFace(const FaceShape& shape, const std::vector<base::Vector3>& points, const std::vector<int>& nodes,
                   const Plane& plane)
    : shape_(shape) {
  for (int j = 0; j < shape.nodes(); ++j) node_[j] = plane.project(points[nodes[j]]);
  const auto& x = node_;
  if (shape.corners() == 3) {
    origin_ = x[0];
    first_ = combine(1.0, x[1], -1.0, x[0]);
    second_ = combine(1.0, x[2], -1.0, x[0]);
  } else if (shape.corners() == 2) {
    origin_ = combine(0.5, x[0], 0.5, x[1]);
    first_ = combine(0.5, x[1], -0.5, x[0]);
  } else {
    const Flat diagonal1 = combine(0.25, x[2], -0.25, x[0]), diagonal2 = combine(0.25, x[3], -0.25, x[1]);
    const Flat middle1 = combine(0.25, x[0], 0.25, x[2]), middle2 = combine(0.25, x[1], 0.25, x[3]);
    origin_ = combine(1.0, middle1, 1.0, middle2);
    first_ = combine(1.0, diagonal1, -1.0, diagonal2);
    second_ = combine(1.0, diagonal1, 1.0, diagonal2);
    mixed_ = combine(1.0, middle1, -1.0, middle2);
  }
  size_ = length(first_) + length(second_);
  if (length(mixed_) <= roundOff * size_) mixed_ = {};
  distortion_ = length(mixed_) / size_;
  for (int j = shape.corners(); j < shape.nodes(); ++j) {
    const double away = length(combine(1.0, x[j], -1.0, cornerImageOf(shape.places()[j]).place)) / size_;
    if (away <= roundOff) continue;
    followsCorners_ = false;
    distortion_ = std::max(distortion_, away);
  }
  isBilinear_ = distortion_ > 0.0 && followsCorners_;
  area_ = cross(first_, second_);
  square_ = cross(first_, mixed_);
}

FlatFace::Image FlatFace::cornerImageOf(const Parent& parent) const {
  Image image{origin_, combine(1.0, first_, parent[1], mixed_), combine(1.0, second_, parent[0], mixed_)};
  image.place = combine(1.0, origin_, 1.0, combine(parent[0], image.first, parent[1], second_));
  return image;
}

FlatFace::Image FlatFace::imageOf(const Parent& parent) const {
  if (followsCorners_) return cornerImageOf(parent);
  FaceShape::Values values;
  FaceShape::Gradients gradients;
  shape_.evaluate(parent, values, gradients);
  Image image;
  for (int j = 0; j < shape_.nodes(); ++j) {
    image.place = combine(1.0, image.place, values[j], node_[j]);
    image.first = combine(1.0, image.first, gradients[j][0], node_[j]);
    image.second = combine(1.0, image.second, gradients[j][1], node_[j]);
  }
  return image;
}

Parent FlatFace::otherParentOf(const Flat& place) const {
  const Flat arm = combine(1.0, place, -1.0, origin_);
  Parent parent = solve(first_, second_, arm, shape_.parentDimension());
  if (distortion_ == 0.0) return parent;
  for (int step = 0; step < mostSteps; ++step) {
    const Image image = imageOf(parent);
    const Parent change =
        solve(image.first, image.second, combine(1.0, place, -1.0, image.place), shape_.parentDimension());
    parent = combine(1.0, parent, 1.0, change);
    if (std::abs(change[0]) + std::abs(change[1]) < converged) break;
  }
  return parent;
}

}  // namespace harmos::mortar
