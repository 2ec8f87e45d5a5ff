#include <harmos/mesh/CurvedSurface.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Matrix.hpp>

namespace harmos::mesh {
namespace {

using Vectors = std::vector<base::Vector3>;

// Height of the arc of a surface over its size: below it, nodes lie in a plane, and any radius fits.
constexpr double flat = 1e-6;
// Singular values below this share of the largest do not determine anything.
constexpr double determined = 1e-10;
constexpr int mostSteps = 50;
constexpr double standstill = 1e-14;  // of a step over the size

[[noreturn]] void refuse() {
  throw base::Error("its nodes do not determine a curved surface: there are too few, or they lie in a plane.",
                    base::ExitCode::input);
}

/// The solution of a x = b in the sense of least squares; refuses what does not determine it.
std::vector<double> leastSquares(base::Matrix a, std::vector<double> b) {
  const int rows = a.numRows(), columns = a.numCols();
  if (rows < columns) refuse();
  for (int j = 0; j < columns; ++j) {
    if (!(*std::max_element(a[j], a[j] + rows) > *std::min_element(a[j], a[j] + rows)) && a(0, j) == 0.0) refuse();
  }
  std::vector<double> singular(columns), work(1);
  int rank = 0, info = 0;
  const Teuchos::LAPACK<int, double> lapack;
  lapack.GELSS(rows, columns, 1, a.values(), a.stride(), b.data(), rows, singular.data(), determined, &rank,
               work.data(), -1, nullptr, &info);
  work.resize(static_cast<std::size_t>(work[0]));
  lapack.GELSS(rows, columns, 1, a.values(), a.stride(), b.data(), rows, singular.data(), determined, &rank,
               work.data(), static_cast<int>(work.size()), nullptr, &info);
  if (info != 0 || rank < columns) refuse();
  b.resize(columns);
  return b;
}

base::Vector3 middleOf(const Vectors& places) {
  base::Vector3 sum{};
  for (const base::Vector3& x : places) sum = sum + x;
  return (1.0 / static_cast<double>(places.size())) * sum;
}

double sizeOf(const Vectors& places, const base::Vector3& middle) {
  double size = 0.0;
  for (const base::Vector3& x : places) size = std::max(size, base::distance(x, middle));
  return size;
}

/// Centre and radius in the space of some directions of length 1: |x|^2 = 2 c.x + (R^2 - |c|^2), which is linear.
struct Round {
  base::Vector3 centre;
  double radius;
};

Round round(const Vectors& places, const Vectors& directions) {
  if (places.empty()) refuse();
  const base::Vector3 middle = middleOf(places);
  const double size = sizeOf(places, middle);
  if (!(size > 0.0)) refuse();
  const int rows = static_cast<int>(places.size()), count = static_cast<int>(directions.size());
  base::Matrix a(rows, count + 1);
  std::vector<double> b(places.size());
  for (int i = 0; i < rows; ++i) {
    for (int d = 0; d < count; ++d) {
      const double x = base::dot(places[i] - middle, directions[d]) / size;
      a(i, d) = x;
      b[i] += x * x;
    }
    a(i, count) = 1.0;
  }
  const std::vector<double> x = leastSquares(a, std::move(b));
  base::Vector3 centre = middle;
  double square = x[count];
  for (int d = 0; d < count; ++d) {
    centre = centre + (0.5 * size * x[d]) * directions[d];
    square += 0.25 * x[d] * x[d];
  }
  if (!(square > 0.0) || std::sqrt(square) > 1.0 / flat) refuse();
  return {centre, size * std::sqrt(square)};
}

/// Two directions across an axis.
Vectors across(const base::Vector3& axis) {
  std::size_t least = 0;
  for (std::size_t c = 1; c < 3; ++c) {
    if (std::abs(axis[c]) < std::abs(axis[least])) least = c;
  }
  base::Vector3 other{};
  other[least] = 1.0;
  base::Vector3 first = base::cross(axis, other);
  first = (1.0 / base::norm(first)) * first;
  return {first, base::cross(axis, first)};
}

/// Of those that have a direction.
Vectors unitVectors(const Vectors& vectors) {
  Vectors result;
  for (const base::Vector3& v : vectors) {
    if (base::norm(v) > 0.0) result.push_back((1.0 / base::norm(v)) * v);
  }
  return result;
}

/// The direction that is most nearly normal to all of these.
base::Vector3 normalTo(const Vectors& normals) {
  base::Matrix sums(3, 3);
  for (const base::Vector3& n : normals) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) sums(i, j) += n[i] * n[j];
    }
  }
  std::array<double, 3> values{};
  std::array<double, 16> work{};
  int info = 0;
  const Teuchos::LAPACK<int, double> lapack;
  lapack.SYEV('V', 'U', 3, sums.values(), sums.stride(), values.data(), work.data(), static_cast<int>(work.size()),
              &info);
  if (info != 0) refuse();
  return {sums(0, 0), sums(1, 0), sums(2, 0)};
}

}  // namespace

CurvedSurface CurvedSurface::circle(const std::vector<base::Vector3>& places) {
  const Round fit = round(places, {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}});
  CurvedSurface surface;
  surface.centre_ = fit.centre;
  surface.axis_ = {0.0, 0.0, 1.0};
  surface.radius_ = fit.radius;
  return surface;
}

CurvedSurface CurvedSurface::sphere(const std::vector<base::Vector3>& places) {
  const Round fit = round(places, {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}});
  CurvedSurface surface;
  surface.centre_ = fit.centre;
  surface.radius_ = fit.radius;
  return surface;
}

CurvedSurface CurvedSurface::cylinder(const std::vector<base::Vector3>& places,
                                      const std::vector<base::Vector3>& normals) {
  CurvedSurface surface;
  surface.axis_ = normalTo(unitVectors(normals));
  // Gauss-Newton on the distances; normals of facets are nearly right to begin with.
  for (int step = 0; step < mostSteps; ++step) {
    const Vectors e = across(surface.axis_);
    const Round fit = round(places, e);
    surface.centre_ = fit.centre;
    surface.radius_ = fit.radius;
    const double size = sizeOf(places, surface.centre_);
    base::Matrix a(static_cast<int>(places.size()), 5);
    std::vector<double> b(places.size());
    for (int i = 0; i < a.numRows(); ++i) {
      const base::Vector3 arm = surface.arm(places[i]);
      const double length = base::norm(arm), along = base::dot(places[i] - surface.centre_, surface.axis_);
      if (!(length > 0.0)) refuse();
      for (int d = 0; d < 2; ++d) {
        a(i, d) = base::dot(arm, e[d]) / length;
        a(i, 2 + d) = a(i, d) * along / size;
      }
      a(i, 4) = 1.0;
      b[i] = (length - surface.radius_) / size;
    }
    const std::vector<double> x = leastSquares(a, std::move(b));
    base::Vector3 axis = surface.axis_ + x[2] * e[0] + x[3] * e[1];
    surface.axis_ = (1.0 / base::norm(axis)) * axis;
    if (std::abs(x[2]) + std::abs(x[3]) < standstill) break;
  }
  const Round fit = round(places, across(surface.axis_));
  surface.centre_ = fit.centre;
  surface.radius_ = fit.radius;
  return surface;
}

CurvedSurface CurvedSurface::cone(const std::vector<base::Vector3>& places, const std::vector<base::Vector3>& normals) {
  // Normals of one angle to the axis end in a plane across it.
  Vectors differences = unitVectors(normals);
  if (differences.empty()) refuse();
  const base::Vector3 mean = middleOf(differences);
  for (base::Vector3& n : differences) n = n - mean;
  CurvedSurface surface;
  surface.axis_ = normalTo(differences);
  surface.centre_ = round(places, across(surface.axis_)).centre;
  const double size = sizeOf(places, surface.centre_);
  // Gauss-Newton on radius less R + slope z, from a circle.
  const int rows = static_cast<int>(places.size());
  for (int step = 0; step < mostSteps; ++step) {
    const Vectors e = across(surface.axis_);
    base::Matrix a(rows, 6);
    std::vector<double> b(places.size());
    for (int i = 0; i < rows; ++i) {
      const base::Vector3 arm = surface.arm(places[i]);
      const double length = base::norm(arm), along = base::dot(places[i] - surface.centre_, surface.axis_);
      if (!(length > 0.0)) refuse();
      for (int d = 0; d < 2; ++d) {
        const double share = base::dot(arm, e[d]) / length;
        a(i, d) = share;
        a(i, 2 + d) = share * (along + surface.slope_ * length) / size;
      }
      a(i, 4) = 1.0;
      a(i, 5) = along / size;
      b[i] = (length - surface.radius_ - surface.slope_ * along) / size;
    }
    const std::vector<double> x = leastSquares(a, std::move(b));
    surface.centre_ = surface.centre_ + (size * x[0]) * e[0] + (size * x[1]) * e[1];
    surface.radius_ += size * x[4];
    surface.slope_ += x[5];
    const base::Vector3 axis = surface.axis_ + x[2] * e[0] + x[3] * e[1];
    surface.axis_ = (1.0 / base::norm(axis)) * axis;
    double moved = 0.0;
    for (const double change : x) moved += std::abs(change);
    if (moved < standstill) break;
  }
  if (!(surface.radius_ > 0.0)) refuse();
  return surface;
}

base::Vector3 CurvedSurface::arm(const base::Vector3& place) const {
  const base::Vector3 from = place - centre_;
  return from - base::dot(from, axis_) * axis_;
}

base::Vector3 CurvedSurface::nearest(const base::Vector3& place) const {
  const base::Vector3 from = arm(place);
  const double length = base::norm(from), radius = radius_ + slope_ * base::dot(place - centre_, axis_);
  return length > 0.0 ? place + (radius / length - 1.0) * from : place;
}

}  // namespace harmos::mesh
