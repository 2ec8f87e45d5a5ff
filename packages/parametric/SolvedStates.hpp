#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <harmos/base/Matrix.hpp>

namespace harmos::parametric {

/// The states of configurations that are solved, with what the linear stage makes of them.
///
/// The linear stage is affine and the same for all configurations but for their loads: beta = A alpha + b. With alpha
/// and A alpha stored, the image of any combination of states is known without a solve. Both are kept in single
/// precision: they only serve starts, and every state that is delivered has passed a stage of its own. Every rank
/// stores its own rows.
class SolvedStates {
 public:
  /// What is kept of a configuration.
  struct State {
    int id;                      ///< as given to add(), as all that follows
    std::vector<double> values;  ///< of the parameters
    std::vector<float> alpha;    ///< alpha [stress], one load step after the other
    std::vector<float> linear;   ///< A alpha [stress], likewise
    std::vector<double> forces;  ///< what its indicators are measured by [force]; empty: not known
    int rows;                    ///< of one load step

    /// The rows of alpha [stress] at a load step.
    const float* alphaAt(int step) const { return alpha.data() + static_cast<std::ptrdiff_t>(rows) * step; }
    /// The same of A alpha [stress].
    const float* linearAt(int step) const { return linear.data() + static_cast<std::ptrdiff_t>(rows) * step; }
  };

  /// `largest`: states kept, > 0; one more drives out one of the two that are closest to each other.
  explicit SolvedStates(int largest) : largest_(static_cast<std::size_t>(largest)) {}

  /// Memory [byte] of a state of so many rows and load steps, in all.
  static constexpr double bytesOf(double rows, double steps) { return 2.0 * sizeof(float) * rows * steps; }

  /// Parameters are measured by the range of what they are in a study: to be called for all its configurations.
  void widen(const std::vector<double>& values);
  /// alpha and A alpha [stress], rows x load steps. `forces`: what its indicators are measured by [force], see Gauge.
  /// A state of the same id is replaced.
  void add(int id, const std::vector<double>& values, const base::Matrix& alpha, const base::Matrix& linear,
           std::vector<double> forces = {});
  /// States kept.
  int count() const { return static_cast<int>(states_.size()); }
  /// The id given to add(), of the state at a position < count(), which is not checked, here and below.
  int id(int state) const { return states_[state].state->id; }
  /// Positions of the states nearest to a configuration, the nearest first; ties in the order of adding.
  std::vector<int> nearest(const std::vector<double>& values, int count) const;
  /// Distance [-] to the nearest state in the ranges of the parameters; infinite without states.
  double distance(const std::vector<double>& values) const;
  /// alpha and A alpha [stress] of all load steps, into matrices that have their shape already.
  void copy(int state, base::Matrix& alpha, base::Matrix& linear) const;
  /// All of it; stays as it is when it is driven out.
  const std::shared_ptr<const State>& state(int position) const { return states_[position].state; }
  /// What the indicators of the state are measured by [force].
  const std::vector<double>& forces(int state) const { return states_[state].state->forces; }

 private:
  struct Kept {
    std::shared_ptr<const State> state;
    double gap = 0.0;  // squared distance to the closest of those before it, the first of them,
    int closest = -1;  // and its id; none: infinite, -1
  };

  double squaredDistance(const std::vector<double>& a, const std::vector<double>& b) const;
  void dropOne();
  void measureGap(std::size_t state);
  void erase(std::size_t state);

  std::vector<double> lower_, upper_;
  std::size_t largest_;
  std::vector<Kept> states_;
  bool areGapsKnown_ = false;  // they are measured when states have to be dropped
};

}  // namespace harmos::parametric
