#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <harmos/laws/LocalLine.hpp>

namespace harmos::laws {

/// Where a graph t(delta) is at a jump, and how it goes on.
struct GraphPoint {
  base::Vector3 traction{};              ///< t [stress]
  std::array<base::Vector3, 3> slope{};  ///< rows dt_i / d(delta_j) [stress/length]
};

/// Sum of the components without their signs; not finite where v is not.
inline double sumOfSizes(const base::Vector3& v) {
  return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

/// Solution of A x = b for 3 rows by Gauss with partial pivoting; not finite where A is singular.
inline base::Vector3 solved(std::array<base::Vector3, 3> a, base::Vector3 b) {
  const bool isDiagonal =
      a[0][1] == 0.0 && a[0][2] == 0.0 && a[1][0] == 0.0 && a[1][2] == 0.0 && a[2][0] == 0.0 && a[2][1] == 0.0;
  if (isDiagonal) return {b[0] / a[0][0], b[1] / a[1][1], b[2] / a[2][2]};
  for (std::size_t k = 0; k < 2; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < 3; ++i) {
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    }
    if (pivot != k) {
      std::swap(a[k], a[pivot]);
      std::swap(b[k], b[pivot]);
    }
    const double inverse = 1.0 / a[k][k];
    for (std::size_t i = k + 1; i < 3; ++i) {
      const double factor = a[i][k] * inverse;
      if (factor == 0.0) continue;
      for (std::size_t j = k; j < 3; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  base::Vector3 x{};
  x[2] = b[2] / a[2][2];
  x[1] = (b[1] - a[1][2] * x[2]) / a[1][1];
  x[0] = (b[0] - a[0][1] * x[1] - a[0][2] * x[2]) / a[0][0];
  return x;
}

/// How tractions scatter about what is smooth in them, over a length around a jump: their sixth differences.
struct Scatter {
  /// `tractionAt` is asked at 21 places over `length` [length].
  template <class TractionAt>
  Scatter(TractionAt&& tractionAt, const base::Vector3& jump, double length) {
    constexpr std::array<double, 7> difference{1.0, -6.0, 15.0, -20.0, 15.0, -6.0, 1.0};
    constexpr double ofRandom = 30.4;  // root of the sum of their squares
    constexpr std::size_t samples = windows + difference.size() - 1;
    std::array<base::Vector3, samples> values;
    for (std::size_t i = 0; i < samples; ++i) {
      const double moved = length * (static_cast<double>(i) / samples - 0.5);
      values[i] = tractionAt(base::Vector3{jump[0] + moved, jump[1] + 0.9 * moved, jump[2] + 0.8 * moved});
      const double size = sumOfSizes(values[i]);
      largest = size <= largest ? largest : size;  // what is not a number is kept
    }
    for (std::size_t i = 0; i < windows; ++i) {
      base::Vector3 sum{};
      for (std::size_t k = 0; k < difference.size(); ++k) sum = sum + difference[k] * values[i + k];
      sizes[i] = sumOfSizes(sum) / ofRandom;
    }
    if (std::isfinite(largest)) std::sort(sizes.begin(), sizes.end());
  }

  static constexpr std::size_t windows = 15;  ///< of seven neighbouring places each
  std::array<double, windows> sizes{};        ///< ascending, of what scatters the root mean square [stress]
  double largest = 0.0;                       ///< of all tractions [stress]; not finite: one is not
};

/// Round-off of a graph near a jump, that of all components together [stress]: where terms cancel, as in 1 - exp(-x),
/// it is that of the terms. From sixth differences over lengths that are parts of `scale` [length]: those of the graph
/// itself fall with the length by a power, those of round-off do not; their median leaves out single kinks. 0: none was
/// found.
/// Source: More, Wild, Estimating computational noise, SIAM J. Sci. Comput. 33 (2011) 1292-1314.
template <class TractionAt>
double roundOffOf(const TractionAt& tractionAt, const base::Vector3& jump, double scale) {
  constexpr double longest = 1e6, shortest = 1e-6;           // parts of the scale
  constexpr double leastFall = 1.0 / 30.0, mostFall = 1e-8;  // of what is the graph's own, to a tenth of the length
  constexpr double resolved = 1e-3;                          // round-off in what varies
  double before = 0.0;
  for (double share = longest; share >= shortest; share *= 0.1) {
    const Scatter scatter(tractionAt, jump, share * scale);
    if (!std::isfinite(scatter.largest)) continue;
    const double here = scatter.sizes[Scatter::windows / 2];
    if (before > 0.0 && (here >= leastFall * before || here <= mostFall * before)) return before;
    before = here <= resolved * scatter.largest ? here : 0.0;
  }
  return before;
}

/// What a jump leaves of a line, delta + H t - delta_free, beside the largest of its terms. In squares, which take no
/// roots.
struct LineResidual {
  /// Of a graph that has the traction `t` at `jump`.
  LineResidual(const LocalLine& line, const base::Vector3& jump, const base::Vector3& t)
      : value(jump - line.jump(t)),
        square(base::dot(value, value)),
        scale(sumOfSizes(jump) + line.compliance * sumOfSizes(t) + sumOfSizes(line.freeJump)) {}

  /// No more than round-off; false where it is not finite.
  bool isRoundOff() const { return isWithin(16.0 * std::numeric_limits<double>::epsilon()); }
  /// As small as a formula whose terms cancel may leave it.
  bool isSmall() const { return isWithin(1e-12); }
  /// No more than this graph's own round-off near the jump; see roundOffOf().
  template <class TractionAt>
  bool isRoundOffOf(const TractionAt& tractionAt, const LocalLine& line, const base::Vector3& jump) const {
    const double most = 32.0 * line.compliance * roundOffOf(tractionAt, jump, scale);
    return square <= most * most;
  }

  base::Vector3 value;  // [length]
  double square;        // |value|^2 [length^2]
  double scale;         // [length]

 private:
  bool isWithin(double share) const {
    const double most = share * scale;
    return square <= most * most && square <= std::numeric_limits<double>::max();
  }
};

/// Newton's step: what to take from a jump of this residual [length].
inline base::Vector3 newtonMove(const LocalLine& line, const GraphPoint& point, const base::Vector3& residual) {
  std::array<base::Vector3, 3> rows;
  for (std::size_t r = 0; r < 3; ++r) {
    rows[r] = line.compliance * point.slope[r];
    rows[r][r] += 1.0;
  }
  return solved(rows, residual);
}

/// Newton's method with steps that are halved until the residual falls, from a jump [length]; see newtonOnLine(), whose
/// registers it is not to take.
template <class TractionAt, class PointAt>
[[gnu::noinline]] std::optional<base::Vector3> dampedNewtonOnLine(const LocalLine& line, base::Vector3 jump,
                                                                  const TractionAt& tractionAt,
                                                                  const PointAt& pointAt) {
  constexpr int iterations = 400, halvings = 60;
  constexpr int looking = 25;             // iterations, after which terms that cancel are thought of
  constexpr double leastDecrease = 1e-4;  // of the residual, in parts of a whole step
  constexpr double resolved = 1e-9;       // rest of a step that leads nowhere, in parts of the jump
  for (int i = 0; i < iterations; ++i) {
    const GraphPoint point = pointAt(jump);
    const LineResidual residual(line, jump, point.traction);
    if (residual.isRoundOff()) return point.traction;
    // The jump has all digits that the formulas leave it; those of the traction follow from the line.
    const base::Vector3 onLine = (1.0 / line.compliance) * (line.freeJump - jump);
    if (i % looking == looking - 1 && residual.isRoundOffOf(tractionAt, line, jump)) return onLine;
    const base::Vector3 move = newtonMove(line, point, residual.value);
    if (!std::isfinite(residual.square + move[0] + move[1] + move[2])) {
      if (!std::isfinite(norm(line.freeJump))) return line.freeJump;  // what is not a number is handed on
      if (i > 0 || jump == line.freeJump) return std::nullopt;
      jump = line.freeJump;
      continue;
    }
    double part = 1.0, least = residual.square;
    base::Vector3 best = jump;
    for (int h = 0;; ++h, part *= 0.5) {
      const base::Vector3 next = jump - part * move;
      const base::Vector3 traction = tractionAt(next);
      const LineResidual left(line, next, traction);
      if (left.isRoundOff()) return traction;
      // Where the whole step is too long, the residual falls on as it is halved, beyond kinks.
      const double share = 1.0 - leastDecrease * part;
      const bool isLower = left.square <= share * share * least;
      if (isLower) {
        least = left.square;
        best = next;
      }
      if (least < residual.square && (!isLower || h == 0 || h == halvings)) {
        jump = best;
        break;
      }
      if (h < halvings) continue;
      if (residual.isSmall()) return point.traction;
      if (sumOfSizes(move) <= resolved * sumOfSizes(jump)) return onLine;
      if (residual.isRoundOffOf(tractionAt, line, jump)) return onLine;
      return std::nullopt;
    }
  }
  return std::nullopt;
}

/// Traction at which a smooth graph meets a line, by Newton's method with steps that are halved until the residual
/// falls; nothing when that comes to no end.
///
/// `tractionAt(jump)` is the graph [stress], `pointAt(jump)` a GraphPoint. Where the graph is monotone the residual
/// falls along every Newton direction, and there is one point. Begins at the jump 0, or at the free jump where the
/// graph has no value or slope there. A free jump that is not finite is handed on as traction.
template <class TractionAt, class PointAt>
std::optional<base::Vector3> newtonOnLine(const LocalLine& line, const TractionAt& tractionAt, const PointAt& pointAt) {
  const GraphPoint point = pointAt({});
  const LineResidual residual(line, {}, point.traction);
  const base::Vector3 next = (-1.0) * newtonMove(line, point, residual.value);
  const base::Vector3 traction = tractionAt(next);
  const LineResidual left(line, next, traction);
  // Springs and the like are met at once.
  if (left.isRoundOff()) return traction;
  return dampedNewtonOnLine(line, left.square < residual.square ? next : base::Vector3{}, tractionAt, pointAt);
}

}  // namespace harmos::laws
