#pragma once

#include <memory>
#include <vector>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/NaturalSizes.hpp>
#include <harmos/latin/Response.hpp>
#include <harmos/results/Indicators.hpp>

namespace harmos::parametric {

/// Measures the indicators of states and of single load steps.
class Gauge {
 public:
  /// All arguments must outlive it.
  Gauge(const latin::FixedPoint& fixedPoint, const std::vector<std::shared_ptr<const latin::Response>>& responses)
      : fixedPoint_(fixedPoint), responses_(responses) {}

  /// Collective. `state`: that of alpha, of all load steps; `image` = T(alpha) [stress], rows of the layout x load
  /// steps.
  results::Indicators measure(const latin::Iterate& state, const base::Matrix& alpha, const base::Matrix& image);
  /// What was measured last is measured by [force]: the largest resultant R of an interface, then F_r for each response
  /// r, whose indicator is then
  ///   I_r = B / F_r where it is a force,  I_r = max(B, force indicator R / 3) / F_r elsewhere,
  /// with B the largest resultant that is out of balance. With s the largest value of the response over the load steps,
  /// or its floor, and S its natural size (latin::NaturalSizes): F_r = s of a force, at most R, and R s / S of others,
  /// since what is small beside its kind is to be that much more accurate, at most a thousand times; infinite where the
  /// response is zero, 0 where it is not finite or R is 0.
  const std::vector<double>& forces() const { return forces_; }
  /// The largest force indicator with which no indicator is above `target` where forces() are `forces`.
  double allowedForce(const results::Indicators& target, const std::vector<double>& forces) const;
  /// The same of B [force]; infinite where `forces` is empty, that is not known.
  double allowedImbalance(const results::Indicators& target, const std::vector<double>& forces) const;
  /// Collective. Largest resultant [force] of f^ - f on a body at one load step, one column each: `alpha`, its image
  /// `beta` under the linear stage, of which f = (alpha + beta) / 2, and `hattedTraction` f^, all [stress].
  double imbalance(const base::Matrix& alpha, const base::Matrix& beta, const base::Matrix& hattedTraction) const;

 private:
  /// F_r of a response.
  static double forceOf(const latin::Response& response, const latin::Iterate& state, const latin::NaturalSizes& sizes,
                        double resultant);

  const latin::FixedPoint& fixedPoint_;
  const std::vector<std::shared_ptr<const latin::Response>>& responses_;
  std::vector<double> forces_;
};

}  // namespace harmos::parametric
