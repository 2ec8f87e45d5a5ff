#pragma once

#include <functional>
#include <string>
#include <vector>

#include <harmos/design/Axis.hpp>
#include <harmos/design/Surrogate.hpp>

namespace harmos::design {

/// Chooses points until the surface of one response is known to a tolerance over the whole box.
///
/// Begins with the corners of the box and a Sobol' sequence. Then it adds, batch by batch, the points where the surface
/// is least certain, until two things hold: 1.96 deviations are below the tolerance at many points all over the box,
/// and the points of the last batch, which were the least certain ones, had been predicted to within the tolerance
/// before they were solved. The same results give the same points.
class Refinement {
 public:
  /// How fine the surface shall be, and at what expense.
  struct Options {
    double tolerance = 1e-2;  // relative to the largest magnitude of the response
    int initialCount = 0;     // with the corners; 0: twice as many as a quadratic polynomial has terms
    int maximumCount = 200;   // of all points; the corners are taken in any case
    int seed = 0;             // of the Sobol' sequence, see SobolDesign
  };
  /// [point][axis], in the units of the parameters.
  using Points = std::vector<std::vector<double>>;

  /// `isAllowed` of a point: whether the conditions of the study admit it; empty: every point is.
  Refinement(std::vector<Axis> axes, const Options& options,
             std::function<bool(const std::vector<double>&)> isAllowed = {});

  /// The points to begin with: the corners for up to 5 axes, then a Sobol' sequence.
  Points begin() const;
  /// The next points; none when the tolerance is reached, no more may be chosen or the solutions are too few for a
  /// surface. `values` of the `points` so far, not a number where there is no solution; `accuracy` of the values,
  /// relative to the largest.
  Points next(const Points& points, const std::vector<double>& values, double accuracy);
  /// Whether the last call of next() found the tolerance reached, or no point left to choose from.
  bool isReached() const { return isReached_; }
  /// What it found, one sentence.
  const std::string& summary() const { return summary_; }

 private:
  Points candidates() const;
  void removeForbidden(Points& points) const;

  std::vector<Axis> axes_;
  Options options_;
  std::function<bool(const std::vector<double>&)> isAllowed_;
  bool isReached_ = false;
  std::string summary_;
};

}  // namespace harmos::design
