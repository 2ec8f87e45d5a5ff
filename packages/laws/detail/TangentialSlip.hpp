#pragma once

#include <cmath>

#include <harmos/laws/NodeArrays.hpp>

namespace harmos::laws {

/// The part of a vector along the surface, in components along t1 and t2.
struct Tangential {
  double t1 = 0.0, t2 = 0.0;  ///< [stress] or [length]

  /// That of a vector (n, t1, t2).
  static Tangential of(const base::Vector3& v) { return {v[1], v[2]}; }
  /// Its length.
  double norm() const { return std::sqrt(t1 * t1 + t2 * t2); }
  friend Tangential operator+(const Tangential& a, const Tangential& b) { return {a.t1 + b.t1, a.t2 + b.t2}; }
  friend Tangential operator-(const Tangential& a, const Tangential& b) { return {a.t1 - b.t1, a.t2 - b.t2}; }
  friend Tangential operator*(double s, const Tangential& a) { return {s * a.t1, s * a.t2}; }
  friend double dot(const Tangential& a, const Tangential& b) { return a.t1 * b.t1 + a.t2 * b.t2; }
};

/// What a slider may carry: |t - kinematic slip| <= limit, which grows by isotropic p in a load step that slides by p.
struct SlipLimit {
  double limit = 0.0;      ///< [stress], >= 0
  double isotropic = 0.0;  ///< [stress/length], >= 0
  double kinematic = 0.0;  ///< [stress/length], >= 0
};

/// Where a spring and a slider in series meet a line.
struct SlipState {
  Tangential traction;    ///< t [stress]
  Tangential slip;        ///< of the slider at the end of the load step [length]
  double distance = 0.0;  ///< slid in the load step [length]
  bool slides = false;    ///< or is just about to
};

/// From this relative distance to the limit on, a pair counts as slipping: one that came to rest there would otherwise
/// be told apart by round-off.
constexpr double atTheLimit = 2e-6;

/// Return mapping: t = (delta - slip) / springCompliance, sliding along t - kinematic slip, implicit in the load step.
///
/// On delta = freeJump - lineCompliance t both compliances add up to C, and with xi the traction without sliding less
/// kinematic slip_old, the slider moves by (|xi| - limit) / (1/C + isotropic + kinematic) along xi. `springCompliance`
/// [length/stress] may be 0: rigid. Source: Simo, Hughes: Computational Inelasticity (1998), boxes 1.5 and 3.2.
inline SlipState slipOnLine(const LocalLine& line, double springCompliance, const Tangential& oldSlip,
                            const SlipLimit& slider) {
  const double compliance = line.compliance + springCompliance;
  SlipState state;
  state.slip = oldSlip;
  state.traction = (1.0 / compliance) * (Tangential::of(line.freeJump) - oldSlip);
  const Tangential shifted = state.traction - slider.kinematic * oldSlip;
  const double trial = shifted.norm();
  state.slides = trial >= (1.0 - atTheLimit) * slider.limit;
  // What is not a number goes on, so that it is seen.
  if (trial < slider.limit || trial == 0.0) return state;
  const double share = (1.0 - slider.limit / trial) / (1.0 + compliance * (slider.isotropic + slider.kinematic));
  const Tangential moved = (share * compliance) * shifted;
  state.distance = share * compliance * trial;
  state.slip = oldSlip + moved;
  state.traction = state.traction - share * shifted;
  return state;
}

/// What a law with one slider keeps from load step to load step: its slip, and the length of the way that it slid.
struct SlipMemory {
  static constexpr int size = 3;  ///< numbers

  /// Slip of the slider [length].
  static Tangential slip(const double* history) { return {history[0], history[1]}; }
  /// Length of its way [length].
  static double way(const double* history) { return history[2]; }
  /// Writes the end of a load step.
  static void keep(const Tangential& slip, double distance, const double* old, double* now) {
    now[0] = slip.t1;
    now[1] = slip.t2;
    now[2] = old[2] + distance;
  }
  /// (t - kinematic slip).(slip - old slip): what the slider takes out of a load step [stress length].
  static double lostWork(const PairStep& step, double kinematic = 0.0) {
    const Tangential now = slip(step.history);
    return dot(Tangential::of(step.traction) - kinematic * now, now - slip(step.oldHistory));
  }
};

}  // namespace harmos::laws
