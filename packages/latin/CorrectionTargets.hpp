#pragma once

#include <limits>
#include <vector>

namespace harmos::latin {

/// What every load step of a CausalCorrection goes for, and how far it has come. Not collective; residuals R = T(alpha)
/// - alpha and ways are lengths in the metric of states, the same on every rank.
class CorrectionTargets {
 public:
  /// Where a correction ends.
  struct Goal {
    double reduction = 1.0;  ///< largest |R_t| over that before
    /// Of the fields of the result, relative [-]: where the way of a load step tells a larger one, each goes as far as
    /// its own way asks for, in later corrections, too.
    double error = std::numeric_limits<double>::infinity();
    /// Whether every load step must go some way: later corrections tell errors by ways, and what is wrong with one
    /// would go unseen beside larger residuals of others.
    bool isLater = false;
  };

  /// How far one load step has come.
  struct LoadStep {
    double residual = 0.0;  ///< |R|
    double before = 0.0;    ///< |R| at the start
    double moved = 0.0;     ///< |alpha - start|
    int directions = 0;     ///< new ones since the start
    double weight = 1.0;    ///< of the target: its share of this load step, small where small residuals mean long ways
  };

  /// Of an assembly with so many load steps.
  explicit CorrectionTargets(int steps) : steps_(static_cast<std::size_t>(steps)) {}

  /// A load step, from 0.
  LoadStep& operator[](int step) { return steps_[step]; }
  /// The same.
  const LoadStep& operator[](int step) const { return steps_[step]; }

  /// A load step is about to be corrected that has this |R|.
  void start(int step, double residual);
  /// What all load steps, which have been started, go for now.
  void aimAt(const Goal& goal);
  /// Goal::isLater.
  bool isLater() const { return isLater_; }

  /// |R| that a load step is brought to.
  double of(int step) const;
  /// The least |R|, over that at the start, that any load step is brought to whatever its own was.
  double leastShare() const;
  /// Largest |R| at the start, over the weights.
  double before() const { return before_; }
  /// Largest |R| of the load steps from `begin` on and before `end`, over the weights.
  double largestResidual(int begin, int end) const;
  /// That of all load steps.
  double largestResidual() const { return largestResidual(0, static_cast<int>(steps_.size())); }
  /// The longest way of the load steps before `end`; later ones go at least half of their residual.
  double longestWay(int end) const;
  /// What a correction by images has promised: the largest |R|, or what was asked for if that is more.
  double promisedResidual() const;

  /// Less weight for load steps that would leave more than goal.error: `ways`, how far the fields of each have moved,
  /// relative to the largest [-]. Whether there are any.
  bool sharpen(const std::vector<double>& ways, const Goal& goal);

  /// Of each load step what is left of its own |R|, or of the largest, if that is more; residuals up to `noise` are
  /// none, and of those that no load step is brought below no more than was asked for.
  std::vector<double> sharesLeft(double noise) const;
  /// Largest |R| over that at the start, both as weighed then; residuals up to `noise` are none.
  double reduction(double noise) const;

 private:
  double leftOfLargest(std::size_t step, double noise) const;

  std::vector<LoadStep> steps_;
  std::vector<double> weights_;  // at the start
  double before_ = 0.0;
  double reduction_ = 1.0;  // that is asked for
  bool isLater_ = false;
};

}  // namespace harmos::latin
