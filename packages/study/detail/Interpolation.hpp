#pragma once

#include <string>
#include <vector>

#include <harmos/probability/PiecewiseLinear.hpp>
#include <harmos/results/StudyResults.hpp>
#include <harmos/study/Study.hpp>

namespace harmos::study {

/// The piecewise linear interpolation of a study of the type Adaptive Collocation, as far as its results go.
class Interpolation {
 public:
  Interpolation(const Study& study, const results::StudyResults& results);

  /// Germs of the configurations to solve next, in the order in which they are to be added; none when it is complete or
  /// cannot be completed.
  const std::vector<std::vector<double>>& wanted() const { return wanted_; }
  /// Nothing is missing.
  bool isComplete() const { return isComplete_; }
  /// Whether it is, and the error of mean and standard deviation, with that of the solutions, within the tolerance.
  bool isReached() const { return isReached_; }
  const probability::PiecewiseLinear& function() const { return function_; }
  /// Configurations that it goes through.
  int count() const { return count_; }
  /// How far it is, one sentence.
  const std::string& summary() const { return summary_; }

 private:
  probability::PiecewiseLinear function_;
  std::vector<std::vector<double>> wanted_;
  bool isComplete_ = false, isReached_ = false;
  int count_ = 0;
  std::string summary_;
};

}  // namespace harmos::study
