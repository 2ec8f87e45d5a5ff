#pragma once

#include <utility>
#include <vector>

namespace harmos::input {

/// A parameter's value at every load step: either one constant or one value per step.
///
/// Steps are counted from 0 (the first loaded step; the unloaded start has no entry).
class Schedule {
 public:
  Schedule(double constant = 0.0) : values_{constant} {}
  explicit Schedule(std::vector<double> perStep) : values_(std::move(perStep)) {}
  double operator[](int step) const { return values_.size() == 1 ? values_[0] : values_[step]; }

 private:
  std::vector<double> values_;
};

}  // namespace harmos::input
