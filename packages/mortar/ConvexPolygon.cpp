#include <harmos/mortar/detail/ConvexPolygon.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::mortar {
namespace {

/// Twice the area of a triangle, positive if it is counter-clockwise.
double turn(const Flat& a, const Flat& b, const Flat& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace

double ConvexPolygon::signedArea() const {
  if (isSegment()) return corner_[1][0] - corner_[0][0];
  double sum = 0.0;
  for (int i = 2; i < count_; ++i) sum += turn(corner_[0], corner_[i - 1], corner_[i]);
  return 0.5 * sum;
}

double ConvexPolygon::area() const {
  return std::abs(signedArea());
}

void ConvexPolygon::orient() {
  if (signedArea() < 0.0) std::reverse(corner_.begin(), corner_.begin() + count_);
}

Flat ConvexPolygon::middle() const {
  Flat sum{};
  for (int i = 0; i < count_; ++i) {
    for (int d = 0; d < 2; ++d) sum[d] += corner_[i][d] / count_;
  }
  return sum;
}

double ConvexPolygon::diameter() const {
  const Flat centre = middle();
  double radius = 0.0;
  for (int i = 0; i < count_; ++i) {
    radius = std::max(radius, std::hypot(corner_[i][0] - centre[0], corner_[i][1] - centre[1]));
  }
  return 2.0 * radius;
}

ConvexPolygon intersection(const ConvexPolygon& a, const ConvexPolygon& b) {
  if (a.isSegment()) {
    const double from = std::max(a[0][0], b[0][0]), to = std::min(a[1][0], b[1][0]);
    return from < to ? ConvexPolygon(std::array<Flat, 2>{{{from, 0.0}, {to, 0.0}}}) : ConvexPolygon();
  }
  ConvexPolygon rest = a;
  for (int edge = 0; edge < b.count_ && rest.count_ > 2; ++edge) {
    const Flat& from = b[edge];
    const Flat& to = b[(edge + 1) % b.count_];
    ConvexPolygon next;
    for (int i = 0; i < rest.count_; ++i) {
      const Flat& here = rest[i];
      const Flat& there = rest[(i + 1) % rest.count_];
      const double side = turn(from, to, here), sideThere = turn(from, to, there);
      if (side >= 0.0) next.add(here);
      if ((side > 0.0 && sideThere < 0.0) || (side < 0.0 && sideThere > 0.0)) {
        const double share = side / (side - sideThere);
        next.add({here[0] + share * (there[0] - here[0]), here[1] + share * (there[1] - here[1])});
      }
    }
    rest = next;
  }
  return rest.count_ > 2 ? rest : ConvexPolygon();
}

}  // namespace harmos::mortar
