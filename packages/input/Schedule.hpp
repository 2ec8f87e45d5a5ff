#pragma once

#include <utility>
#include <vector>

namespace harmos::input {

/// A parameter's value at every load step: either one constant or one value per step.
///
/// Steps are counted from 0 (the first loaded step; the unloaded start has no entry). The unit is the parameter's.
class Schedule {
 public:
  /// The same value at every load step.
  Schedule(double constant = 0.0) : values_{constant} {}
  /// One value per load step. A single one counts for all of them.
  explicit Schedule(std::vector<double> perStep) : values_(std::move(perStep)) {}
  /// Value at a load step. The step is not checked: there must be a value for it.
  double operator[](int step) const { return values_.size() == 1 ? values_[0] : values_[step]; }

 private:
  std::vector<double> values_;
};

}  // namespace harmos::input
