#pragma once

#include <memory>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/FixedPoint.hpp>

namespace harmos::parametric {

/// The linear stage beta = A alpha + b as configurations share it: A x for columns x, and b, which stays as long as
/// loads do.
class StepSolver {
 public:
  /// A column x to be solved for, and where A x goes; both [stress], rows of the layout.
  struct Request {
    const double* x;  ///< what alpha changes by
    double* image;    ///< A x
  };

  /// `precision`: of A x, and exact where it turns out to be too rough. `fixedPoint` must outlive it.
  StepSolver(latin::FixedPoint& fixedPoint, substructure::Precision precision)
      : fixedPoint_(fixedPoint), precision_(precision) {}

  /// Collective. Finds b of the loads that are on the operators now, with a stage of all load steps where they are
  /// others than before and not all zero. Ends the validity of all iterates.
  void updateLoads();
  /// b [stress] of the last updateLoads(), rows of the layout x load steps; what was handed out before stays as it is.
  const std::shared_ptr<const base::Matrix>& offset() const { return offset_; }

  /// Collective. Solves all requests as one block: a single column is bound by the memory of the
  /// dense traces, which a block reads once for all of its columns. Ends the validity of all iterates; select() or
  /// selectAll() of the FixedPoint must follow.
  void solve(const std::vector<Request>& requests);

 private:
  latin::FixedPoint& fixedPoint_;
  substructure::Precision precision_;
  std::shared_ptr<const base::Matrix> offset_;
  long changes_ = 0;  // of the loads when it was found
  base::Matrix x_, images_;
};

}  // namespace harmos::parametric
