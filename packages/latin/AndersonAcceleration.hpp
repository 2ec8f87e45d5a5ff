#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/StateMetric.hpp>

namespace harmos::latin {

/// Anderson acceleration of the fixed point alpha = T(alpha) with coefficients of its own for every load step.
///
/// At each step t, gamma minimises |f_n - dF gamma| in the state metric, with f = T(alpha) - alpha and dF, dG the last
/// differences of f and of T(alpha); then alpha_{n+1} = T(alpha_n) - dG gamma.
/// Source: Anderson (1965), doi:10.1145/321296.321305; Walker, Ni (2011), doi:10.1137/10078356X.
class AndersonAcceleration {
 public:
  /// `memory`: differences kept, >= 1.
  AndersonAcceleration(const StateMetric& metric, int memory);

  /// Collective. Replaces `alpha` by the next iterate, given image = T(alpha).
  void advance(base::Matrix& alpha, const base::Matrix& image);
  /// Collective. Forgets all differences and starts with those that are known from elsewhere: per load step dF in the
  /// scale of the metric, and dG, one column each and at most as many as the memory. New ones replace them in their
  /// order.
  void seed(const std::vector<base::Matrix>& residuals, const std::vector<base::Matrix>& images);
  /// Forgets all differences.
  void restart();

 private:
  struct Step {
    base::Matrix residuals;  // scaled differences dF, one column each
    base::Matrix images;     // differences dG
    base::Matrix gram;       // dF^T dF
  };

  void reserve(int rows, int columns);
  void append(const base::Matrix& residual, const base::Matrix& image);

  const StateMetric& metric_;
  int memory_;
  int stored_ = 0;
  int next_ = 0;  // column to overwrite
  std::vector<Step> steps_;
  base::Matrix lastResidual_;  // scaled
  base::Matrix lastImage_;
  bool started_ = false;
};

}  // namespace harmos::latin
