#include <harmos/scene/detail/Span.hpp>

namespace harmos::scene {
namespace {

// What is left of a unit vector beside directions that it follows from, which is round-off.
constexpr double roundOff = 1e-6;

}  // namespace

void Span::add(const base::Vector3& v) {
  if (isSpace() || contains(v)) return;
  // Once more, since the first time leaves round-off that is large beside a short rest.
  const base::Vector3 rest = without(without(v));
  axes_.push_back((1.0 / norm(rest)) * rest);
}

base::Vector3 Span::without(const base::Vector3& v) const {
  base::Vector3 rest = v;
  for (const base::Vector3& axis : axes_) rest = rest - dot(rest, axis) * axis;
  return rest;
}

bool Span::contains(const base::Vector3& v) const {
  return norm(without(v)) <= roundOff * norm(v);
}

bool Span::excludes(const base::Vector3& v) const {
  return norm(v - without(v)) <= roundOff * norm(v);
}

std::vector<base::Vector3> Span::complement(const base::Frame& rows) const {
  std::vector<base::Vector3> basis;
  Span all = *this;
  for (const base::Vector3& row : rows) {
    if (excludes(row)) basis.push_back(row);
  }
  for (const base::Vector3& v : basis) all.add(v);
  for (const base::Vector3& row : rows) {
    if (all.contains(row)) continue;
    all.add(row);
    basis.push_back(all.axes_.back());
  }
  return basis;
}

}  // namespace harmos::scene
