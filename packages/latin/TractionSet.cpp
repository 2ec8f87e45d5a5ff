#include <harmos/latin/detail/TractionSet.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace harmos::latin {

TractionSet TractionSet::point(const base::Vector3& traction) {
  return span(traction, {});
}

TractionSet TractionSet::span(const base::Vector3& traction, std::vector<base::Vector3> axes) {
  TractionSet set;
  set.base_ = traction;
  set.hull_ = std::move(axes);
  return set;
}

TractionSet TractionSet::ray(const base::Vector3& direction) {
  TractionSet set;
  set.kind_ = Kind::ray;
  set.hull_ = {(1.0 / base::norm(direction)) * direction};
  return set;
}

TractionSet TractionSet::cone(const base::Frame& frame, double friction, int dimension) {
  if (friction == 0.0) return ray(-1.0 * frame[0]);
  TractionSet set;
  set.kind_ = Kind::cone;
  set.hull_.assign(frame.begin(), frame.begin() + dimension);
  set.frame_ = frame;
  set.friction_ = friction;
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
      return std::max(0.0, base::dot(hull_[0], x)) * hull_[0];
    case Kind::cone:
      break;
  }
  base::Vector3 t = base::toFrame(frame_, x);
  if (dimension_ == 2) t[2] = 0.0;
  const double shear = base::tangentialNorm(t);
  if (shear <= -friction_ * t[0]) return base::toGlobal(frame_, t);
  // Nearest on the generator through the shear.
  const double along = (friction_ * shear - t[0]) / (1.0 + friction_ * friction_);
  if (along <= 0.0) return {};
  const double scale = friction_ * along / shear;
  return base::toGlobal(frame_, {-along, scale * t[1], scale * t[2]});
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
