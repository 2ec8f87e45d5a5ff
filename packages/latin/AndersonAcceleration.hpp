#pragma once

#include <limits>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/StateMetric.hpp>

namespace harmos::latin {

/// Anderson acceleration of the fixed point alpha = T(alpha) with coefficients of its own for every load step.
///
/// At each step t, gamma minimises |f_n - dF gamma| in the state metric, with f = T(alpha) - alpha and dF, dG the last
/// differences of f and of T(alpha); then alpha_{n+1} = T(alpha_n) - dG gamma.
/// Source: Anderson (1965), doi:10.1145/321296.321305; Walker, Ni (2011), doi:10.1137/10078356X.
///
/// Two guards, because the laws have kinks and T brings no point closer together than it must:
///  - Where the residual grows by more than half, the iterate is given up for the mean of the last good one and its
///    image, which no kink can throw far, and the differences are forgotten.
///    Source: Zhang, O'Donoghue, Boyd (2020), doi:10.1137/18M1232772.
///  - Where the residual is constant and no combination of differences reduces it, or only one that leads more than 20
///    times as far as the residual, a body flies or slides freely under a constant force: alpha_{n+1} = T(alpha_n) + (s
///    - 1) f_n with a stretch s that doubles until something is met.
/// The differences of an affine T do not mislead: then the first guard is left out, and the second one believes every
/// combination that reduces the residual, however far it leads.
class AndersonAcceleration {
 public:
  /// Numbers that a difference takes, over those of a state of one load step.
  static constexpr int statesPerDifference = 2;

  /// `memory`: differences kept, >= 1. `isAffine`: T is, in all that it is used for. `metric` must outlive it.
  AndersonAcceleration(const StateMetric& metric, int memory, bool isAffine = false);

  /// Collective. Replaces `alpha` by the next iterate, given image = T(alpha); both [stress], rows of the metric x load
  /// steps.
  void advance(base::Matrix& alpha, const base::Matrix& image);
  /// Collective. Forgets all differences and starts with those that are known from elsewhere: per load step dF in the
  /// scale of the metric, and dG, one column each and at most as many as the memory. New ones replace them in their
  /// order.
  void seed(const std::vector<base::Matrix>& residuals, const std::vector<base::Matrix>& images);
  /// Forgets all differences.
  void restart();
  /// Keeps them, but draws none between the last iterate and the next: T has changed a little.
  void resume();
  /// As resume(), and lets go of the last iterates, which take four states of every load step.
  void pause();

 private:
  struct Step {
    base::Matrix residuals;  // scaled differences dF, one column each
    base::Matrix images;     // differences dG
    base::Matrix gram;       // dF^T dF
    double accepted = -1.0;  // residual norm of the last good iterate; negative: there is none
    double stretch = 1.0;    // of the last move
    double predicted = std::numeric_limits<double>::infinity();  // squared residual that the last move should lead to
    bool isGivenUp = false;                                      // the present iterate was
    std::vector<double> goodAlpha;                               // the last good iterate
    std::vector<double> goodImage;                               // and its image
  };
  /// Squared norms at one load step.
  struct Sizes {
    double residual;
    double change;  // of the residual since the last iterate
    double image;
  };

  void begin(int columns);
  /// Makes room for so many differences of a step: few load steps need all that the memory allows.
  void reserve(Step& step, int rows, int count) const;
  void scaleResidual(const base::Matrix& alpha, const base::Matrix& image);
  std::vector<Sizes> measure(const base::Matrix& image) const;
  static void forget(Step& step);
  void append(const base::Matrix& image);
  void judge(const base::Matrix& alpha, const base::Matrix& image, const std::vector<Sizes>& sizes);
  /// Writes dG gamma, returns |f - dF gamma|^2.
  double extrapolate(const Step& step, const Sizes& size, const double* products, double* extrapolation) const;
  void move(Step& step, bool isDrifting, const double* image, const double* extrapolation, double* alpha) const;

  const StateMetric& metric_;
  int memory_;
  bool isAffine_;
  int stored_ = 0;
  int next_ = 0;  // column to overwrite
  std::vector<Step> steps_;
  base::Matrix residual_;  // scaled
  base::Matrix lastResidual_;
  bool started_ = false;
};

}  // namespace harmos::latin
