#pragma once

#include <algorithm>
#include <cmath>

namespace harmos::laws {

/// How the traction of a cohesive zone falls once it has reached the strength.
enum class Softening {
  bilinear,    ///< linearly, to zero at a finite opening
  exponential  ///< exponentially, never quite to zero
};

/// Traction over opening of a cohesive zone that is opened for the first time, at one mix of modes.
///
/// t = K lambda up to the onset lambda_0, where t = sigma = K lambda_0; beyond, with x = (lambda - lambda_0) / tail,
///   bilinear:    t = sigma (1 - x), 0 from x = 1 on,      tail = 2 G / sigma - lambda_0
///   exponential: t = sigma exp(-x),                       tail =   G / sigma - lambda_0 / 2
/// so that the area below is G. Damage d in [0, 1] is what the secant has lost: t = (1 - d) K lambda. The steepest fall
/// is sigma / tail for both.
class SofteningCurve {
 public:
  /// K [stress/length], lambda_0 [length], G [energy/length^2], all > 0; K lambda_0^2 < 2 G.
  SofteningCurve(Softening shape, double stiffness, double onset, double energy)
      : shape_(shape), onset_(onset), strength_(stiffness * onset), energy_(energy) {
    const double bilinear = 2.0 * energy / strength_ - onset;
    tail_ = shape == Softening::bilinear ? bilinear : 0.5 * bilinear;
  }

  /// -dt/dlambda where it is largest [stress/length], > 0.
  double steepestFall() const { return strength_ / tail_; }

  /// d of an opening [length] that none before has exceeded.
  double damage(double opening) const {
    return opening > onset_ ? std::max(0.0, 1.0 - fall(opening) * onset_ / opening) : 0.0;
  }

  /// The opening [length] that has done this damage; infinite where no finite one does.
  double opening(double damage) const {
    if (shape_ == Softening::bilinear) return onset_ * (onset_ + tail_) / (onset_ + (1.0 - damage) * tail_);
    // (1 - d) lambda / lambda_0 - exp(-x) is concave and grows: Newton's iterates grow to the root.
    double x = onset_;
    for (int i = 0; i < mostIterations && damage < 1.0; ++i) {
      const double e = fall(x);
      const double step = (e - (1.0 - damage) * x / onset_) / ((1.0 - damage) / onset_ + e / tail_);
      if (!(step > roundOff * x)) return x;
      x += step;
    }
    return x;
  }

  /// Energy [energy/length^2] that the way to this opening has cost: the area between curve and secant, at most G.
  double dissipated(double opening) const {
    if (opening <= onset_) return 0.0;
    if (shape_ == Softening::bilinear) {
      return energy_ * std::min(1.0, (opening - onset_) / tail_);
    }
    const double e = fall(opening);
    return e > 0.0 ? energy_ - strength_ * e * (tail_ + 0.5 * opening) : energy_;
  }

  /// The opening [length] beyond the onset where lambda + H t = `freeOpening` meets the falling part; the only one
  /// where H is less than 1 / steepestFall(), the last one otherwise.
  double intersect(double freeOpening, double compliance) const {
    if (shape_ == Softening::bilinear) {
      const double steepness = compliance * steepestFall();
      const double opening = (freeOpening - steepness * (onset_ + tail_)) / (1.0 - steepness);
      return steepness < 1.0 && opening < onset_ + tail_ ? opening : freeOpening;
    }
    // lambda + H t is convex and not less than lambda: Newton's iterates fall from the free opening to the root.
    double x = freeOpening;
    for (int i = 0; i < mostIterations; ++i) {
      const double t = compliance * strength_ * fall(x);
      const double step = (x + t - freeOpening) / (1.0 - t / tail_);
      if (!(step > roundOff * x)) return x;
      x -= step;
    }
    return x;
  }

 private:
  static constexpr int mostIterations = 60;  // quadratic after the first few
  static constexpr double roundOff = 1e-16;

  /// t / sigma beyond the onset.
  double fall(double opening) const {
    const double x = (opening - onset_) / tail_;
    return shape_ == Softening::bilinear ? std::max(0.0, 1.0 - x) : std::exp(-x);
  }

  Softening shape_;
  double onset_, strength_, energy_;
  double tail_ = 0.0;
};

}  // namespace harmos::laws
