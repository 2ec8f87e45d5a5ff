#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/TraceLayout.hpp>

namespace harmos::latin {

/// Inner product of states per load step: (a, b)_t = sum of (area/k) a b [force length], an energy, so that units and k
/// drop out.
class StateMetric {
 public:
  /// `copies`: of the rows of the layout that stand below each other in a column, for states that are made of several
  /// fields. `layout` must outlive it.
  explicit StateMetric(const TraceLayout& layout, int copies = 1);
  /// sqrt(area/k) of every row.
  const std::vector<double>& scale() const { return scale_; }
  /// Squared norm of every column. Collective.
  std::vector<double> squaredNorms(const base::Matrix& a) const;
  /// Sum over rows and columns of (area/k) a b. Collective.
  double dot(const base::Matrix& a, const base::Matrix& b) const;
  /// Square root of dot(a, a): over all columns. Collective.
  double norm(const base::Matrix& a) const;
  /// |a - b|. Collective.
  double distance(const base::Matrix& a, const base::Matrix& b) const;
  /// Replaces values, one list of equal length on every rank, by their sums over the ranks. Collective.
  void sum(std::vector<double>& values) const;

 private:
  const TraceLayout* layout_;
  std::vector<double> scale_;
};

}  // namespace harmos::latin
