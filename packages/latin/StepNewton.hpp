#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/TangentSpace.hpp>

namespace harmos::latin {

class SoftMotions;

/// Semi-smooth Newton method for R(alpha) = T(alpha) - alpha = 0 at one load step, in a space of directions whose
/// images are kept.
///
/// The image y of a direction v under the linear stage depends on no state, no load step and no status, so that
/// whatever the laws do, least squares of R - (I - J) V c need local stages only; a new direction is solved where they
/// leave too much of R. Two things are done beyond Newton's method, both from I - T being monotone, or nearly so with
/// friction:
///  * what no direction reduces, l = R - (I - J) V c, is a motion that nothing resists: it is followed, twice as far
///    each time, until something answers;
///  * where R grows and points back along the way d, the step ends where R.d = 0.
/// Where laws soften, I - T is not monotone: instead of both a step is halved until |R| falls, see StepLength.
/// Displacement form, with the local stage PointwiseLocalStage. Norms are those of StateMetric.
/// Source of the method: Alart, Curnier (1991), doi:10.1016/0045-7825(91)90022-X; of the recycling: Parks et al.
/// (2006), doi:10.1137/040607277.
class StepNewton {
 public:
  /// What has become of a load step.
  struct Result {
    bool isReached = false;              ///< |R| <= target
    double residual = 0.0;               ///< |R| at the end [force length, square root]
    double smallestSingularValue = 1.0;  ///< of I - J in the space
    /// Of settle(): alpha, one column, at which the joint still goes on at one rate after the longest steps.
    std::optional<base::Matrix> slide;
  };

  /// How far a step goes where laws soften.
  enum class StepLength {
    damped,  ///< halved until |R| falls: stays near the state that it begins with
    whole  ///< wherever it leads: over kinks at which |R| grows in every direction, such as a pair that opens while it
           ///< fails in shear, between whose two tangents damped steps go to and fro
  };

  /// Directions that are kept, at most. Where laws soften, what is slow at one state is not what is slow at the next,
  /// and whatever is forgotten must be solved again: there up to four times as many, where they need little memory.
  static constexpr int maximumDirections = 200;

  /// Collective. `fixedPoint` must outlive it. Directions are forgotten when its search direction has got another
  /// scale, and where a full space does not help.
  explicit StepNewton(FixedPoint& fixedPoint);
  ~StepNewton();
  StepNewton(const StepNewton&) = delete;
  StepNewton& operator=(const StepNewton&) = delete;

  /// Whether there are any directions.
  bool isUsed() const { return tangent_ && scale_ == fixedPoint_.searchDirectionScale() && space().size() > 0; }

  /// Collective, one load step selected. Moves `state`, one column, whose beta [stress] of the linear stage is given,
  /// until |R| <= target; leaves it as it was where that cannot be reached, or is no longer wanted: `mustStop`, may be
  /// empty, is asked on every rank. No iterate is valid afterwards. Throws base::Error as LocalStage::solve().
  Result solve(base::Matrix& state, const base::Matrix& beta, double target, const std::function<bool()>& mustStop);

  /// Collective, one load step selected. The same with other loads: `offset` [stress], one column, is what they add to
  /// beta of every state. `beta`, in and out, is without it. Takes no more than `steps` steps, and of damped ones few
  /// without progress; begins with no directions where the space is full.
  Result solveWith(const base::Matrix& offset, base::Matrix& state, base::Matrix& beta, double target, int steps,
                   StepLength length, const std::function<bool()>& mustStop);

  /// Collective, right after solve() has brought `state` to `target`. Where laws soften, and loads follow no path:
  /// moves it along motions of the parts that are too soft for its residual to show them, FaintMotions, as far as that
  /// asks for, unless it grows above what is near enough. One column of a linear stage for each of which the image is
  /// not known. False, and nothing is moved, where only round-off asks for so much.
  bool settleSoftMotions(base::Matrix& state, double target);

  /// Collective, one load step selected. Goes the way d alpha/d tau = R(alpha) until |R| <= target, from a state and
  /// its beta: from where no solution is near to one that the joint comes to rest at, a stable one of the iteration
  /// alpha <- T(alpha). Each step solves (1 / tau + I - J) d = R, and is taken where the implicit Euler method for it,
  /// R(alpha + d) = d / tau, holds to half of |R|; tau is then doubled at least, otherwise a quarter. Where no law
  /// softens, it gives up soon, or where the joint slides without end, see Result::slide. `state` is as it was where
  /// that leads nowhere. Source: pseudo-transient continuation, Kelley, Keyes (1998), doi:10.1137/S0036142996304796.
  Result settle(base::Matrix& state, const base::Matrix& beta, double target, const std::function<bool()>& mustStop);

 private:
  /// When an attempt gives up.
  struct Effort {
    int steps;     ///< at most
    int patience;  ///< steps in which the best residual must have fallen
  };

  const CorrectionSpace& space() const { return tangent_->space(); }
  /// Newton's method in the space as it is, from a state and its beta, which is without offset_.
  Result attempt(base::Matrix& state, const base::Matrix& beta, double target, const Effort& effort, StepLength length,
                 const std::function<bool()>& mustStop);
  /// Shapes the fields and begins at a state.
  void begin(const base::Matrix& state, const base::Matrix& beta);
  /// Residuals of the present alpha below this one are near enough.
  double enough(double target) const;
  /// Begins with an empty space.
  void forget();
  /// The image y of a direction v under the linear stage, solved here.
  std::vector<double> imageOf(const double* v);
  /// R of the present alpha, into residual_; returns |R|.
  double evaluate();
  /// c of the least squares of R, with new directions until no more than `enough` of it is left.
  CorrectionSpace::LeastSquares leastSquares(double enough);
  /// Adds a direction, solved here; false when v holds nothing new, or the space is full.
  bool extend(std::vector<double> v);
  /// alpha and beta from `from`, by a length along c.
  void moveFrom(const std::vector<double>& c, double length);
  /// Newton's step, or where R points back from its end, as much of it as R does not. Returns |R|.
  double step(const std::vector<double>& c, double size);
  /// All of Newton's step. Returns |R|.
  double wholeStep(const std::vector<double>& c);
  /// As much of Newton's step as lets |R| fall, or fall most. Returns |R|.
  double dampedStep(const std::vector<double>& c, double size);
  /// Follows what is left of R after this step, until something answers. Returns |R|; none where nothing has answered
  /// before it would be lost in round-off.
  std::optional<double> follow(std::vector<double> c);

  FixedPoint& fixedPoint_;
  bool isDamped_;  // laws soften
  int most_ = maximumDirections;
  InterfaceLines lines_;
  std::optional<TangentSpace> tangent_;
  std::unique_ptr<SoftMotions> softMotions_;
  double scale_ = 0.0;               // of the search direction of tangent_
  base::Matrix start_, startImage_;  // alpha and beta that images are differences from
  std::vector<double> offset_;       // what loads add to beta; empty: nothing
  base::Matrix shifted_;             // beta with it
  base::Matrix alpha_, beta_, traction_, residual_;
  base::Matrix fromAlpha_, fromBeta_;  // where the present step begins
};

}  // namespace harmos::latin
