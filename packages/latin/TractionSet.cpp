#include <harmos/latin/detail/TractionSet.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace harmos::latin {
namespace {

// Share of a traction along or across the normal that is none.
constexpr double noFriction = 1e-6;

}  // namespace

TractionSet TractionSet::point(const base::Vector3& traction) {
  return span(traction, {});
}

TractionSet TractionSet::span(const base::Vector3& traction, std::vector<base::Vector3> axes) {
  TractionSet set;
  set.base_ = traction;
  set.hull_ = std::move(axes);
  return set;
}

TractionSet TractionSet::ray(const base::Vector3& direction, const base::Vector3& begin) {
  TractionSet set;
  set.kind_ = Kind::ray;
  set.base_ = begin;
  set.hull_ = {(1.0 / base::norm(direction)) * direction};
  return set;
}

TractionSet TractionSet::cone(const base::Frame& frame, double friction, int dimension, double cohesion) {
  if (friction == 0.0 && cohesion == 0.0) return ray(-1.0 * frame[0]);
  TractionSet set;
  set.kind_ = Kind::cone;
  set.hull_.assign(frame.begin(), frame.begin() + dimension);
  set.frame_ = frame;
  set.friction_ = friction;
  set.cohesion_ = cohesion;
  set.dimension_ = dimension;
  return set;
}

base::Vector3 TractionSet::nearest(const base::Vector3& x) const {
  switch (kind_) {
    case Kind::span: {
      base::Vector3 result = base_;
      for (const base::Vector3& axis : hull_) result = result + base::dot(axis, x - base_) * axis;
      return result;
    }
    case Kind::ray:
      return base_ + std::max(0.0, base::dot(hull_[0], x - base_)) * hull_[0];
    case Kind::cone:
      break;
  }
  base::Vector3 t = base::toFrame(frame_, x);
  if (dimension_ == 2) t[2] = 0.0;
  const double shear = base::tangentialNorm(t);
  if (t[0] <= 0.0 && shear <= cohesion_ - friction_ * t[0]) return base::toGlobal(frame_, t);
  // Nearest on the generator through the shear.
  const double along = std::max(0.0, (friction_ * (shear - cohesion_) - t[0]) / (1.0 + friction_ * friction_));
  const double most = cohesion_ + friction_ * along;
  const double scale = shear > most ? most / shear : 1.0;
  return base::toGlobal(frame_, {-along, scale * t[1], scale * t[2]});
}

bool TractionSet::hasFriction(const base::Vector3& n) const {
  if (kind_ == Kind::cone) return friction_ > 0.0;
  return hull_.size() == 1 && std::abs(base::dot(hull_[0], n)) > noFriction &&
         base::norm(base::cross(hull_[0], n)) > noFriction;
}

std::vector<base::Vector3> TractionSet::cohesions() const {
  std::vector<base::Vector3> result;
  if (kind_ != Kind::cone || cohesion_ == 0.0) return result;
  const double side = dimension_ == 2 ? cohesion_ : std::sqrt(0.5) * cohesion_;
  for (int i = 1; i < dimension_; ++i) result.push_back(side * frame_[static_cast<std::size_t>(i)]);
  return result;
}

std::vector<base::Vector3> TractionSet::generators(const base::Vector3& traction, int count) const {
  if (kind_ == Kind::ray) return hull_;
  base::Vector3 first = base::toFrame(frame_, traction);
  if (dimension_ == 2 || base::tangentialNorm(first) == 0.0) first = {0.0, 1.0, 0.0};
  const double start = std::atan2(first[2], first[1]), pi = std::acos(-1.0);
  if (dimension_ == 2) count = 2;
  std::vector<base::Vector3> result;
  const double length = std::sqrt(1.0 + friction_ * friction_);
  for (int i = 0; i < count; ++i) {
    const double angle = start + 2.0 * pi * i / count;
    const base::Vector3 t{-1.0, friction_ * std::cos(angle), dimension_ == 2 ? 0.0 : friction_ * std::sin(angle)};
    result.push_back((1.0 / length) * base::toGlobal(frame_, t));
  }
  return result;
}

}  // namespace harmos::latin
