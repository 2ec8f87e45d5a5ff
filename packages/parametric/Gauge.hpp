#pragma once

#include <memory>
#include <vector>

#include <harmos/latin/FixedPoint.hpp>
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
  /// What the response indicator was last measured by [force].
  double force() const { return force_; }
  /// Collective. Largest resultant [force] of f^ - f on a body at one load step, one column each: `alpha`, its image
  /// `beta` under the linear stage, of which f = (alpha + beta) / 2, and `hattedTraction` f^, all [stress].
  double imbalance(const base::Matrix& alpha, const base::Matrix& beta, const base::Matrix& hattedTraction) const;

 private:
  const latin::FixedPoint& fixedPoint_;
  const std::vector<std::shared_ptr<const latin::Response>>& responses_;
  double force_ = 0.0;
};

}  // namespace harmos::parametric
