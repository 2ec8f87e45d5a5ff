#pragma once

#include <functional>
#include <vector>

#include <harmos/latin/PairTangents.hpp>
#include <harmos/latin/StateMetric.hpp>
#include <harmos/latin/detail/SoftMotions.hpp>

namespace harmos::latin {

/// Motions of the parts whose images are known and that hardly anything resists, along which a state of one load step
/// is moved as far as its residual R = T(alpha) - alpha asks for: with y the image of v under the linear stage and u
/// what I - J makes of v, alpha += a v and beta += a y with a = u.R / |u|^2.
class FaintMotions {
 public:
  /// Of the state: only round-off asks for a way that is farther.
  static constexpr double farthest = 100.0;

  /// `metric` must outlive it.
  explicit FaintMotions(const StateMetric& metric) : metric_(&metric) {}

  bool isEmpty() const { return motions_.empty(); }
  void clear() { motions_.clear(); }
  /// Collective. v, of norm 1 and orthogonal to those that are there, y and u [stress], rows of the layout.
  void add(std::vector<double> v, std::vector<double> y, std::vector<double> u);
  /// Collective. Returns how far that is in the metric [force length, square root].
  double move(const double* residual, double* alpha, double* beta) const;

 private:
  struct Motion {
    std::vector<double> state, image, change;  // v, y and u / |u|^2
  };
  const StateMetric* metric_;
  std::vector<Motion> motions_;
};

/// Collective. Motions of the parts at a load step with these tangents that an exact space of directions may lack: all
/// that nothing but laws resists, and of those that springs of boundaries resist the softer ones, with what `imageOf`,
/// called on every rank, says of their v [stress], rows of the layout, unless they are so soft that bodies count as
/// rigid.
FaintMotions motionsBesideSpace(const SoftMotions& softMotions, const PairTangents& tangents, const StateMetric& metric,
                                const std::function<std::vector<double>(const double* v)>& imageOf);

}  // namespace harmos::latin
