#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/TraceLayout.hpp>

namespace harmos::latin {

/// The unknown of a PathControl and the equation for it: how much of the loads the linear stage needs for the jump that
/// is asked for.
///
/// The linear stage is affine in the load factor, w = w_0 + lambda w_1, so that lambda = (c - G w_0) / (G w_1), with G
/// w the sum of h weight.(w2 - w1) and c its value at the load step. It holds exactly in every linear stage.
class LoadFactor {
 public:
  /// Not collective. `assembly`, which has a path, and `layout` must outlive it.
  LoadFactor(const assembly::Assembly& assembly, const TraceLayout& layout);

  /// Collective. The response to a load factor of 1 and nothing else: alpha [stress] with the correction of the macro
  /// problem, and w_1 [length], one column each. Throws base::Error (input) when what is controlled does not feel it.
  void setUnit(const base::Matrix& alpha, const base::Matrix& trace);
  /// Collective. Finds lambda of every column, whose load steps are given, from what was found without it [stress],
  /// [length]; adds its response to both.
  void add(const std::vector<int>& steps, base::Matrix& alpha, base::Matrix& trace);
  /// lambda [-] of every column of the last add().
  const std::vector<double>& factors() const { return factors_; }

 private:
  /// Collective. G w of every column.
  std::vector<double> controlled(const base::Matrix& trace) const;

  const assembly::Assembly& assembly_;
  const TraceLayout& layout_;
  std::vector<double> functional_;  // G, per row of the layout
  base::Matrix unitAlpha_, unitTrace_;
  double unitControlled_ = 0.0;
  std::vector<double> factors_;
};

}  // namespace harmos::latin
