#pragma once

#include <memory>
#include <string>

#include "Study.hpp"

namespace harmos::benchmarks {

/// A solver with the state that it has delivered.
class Solution {
 public:
  /// Solves `study`, which must outlive it. Throws base::Error as latin::LatinSolver.
  Solution(const Study& study, const latin::LatinOptions& options);
  Solution(const Solution&) = delete;
  Solution& operator=(const Solution&) = delete;

  const latin::LatinResult& result() const { return result_; }
  bool isCertified() const { return result_.outcome == latin::Outcome::certified; }
  /// CPU time of the iterations [s], without that of the factors.
  double cpuSeconds() const { return cpuSeconds_; }

  /// The largest error of some quantities, and whose it is.
  struct Error {
    double relative;
    std::string quantity;
  };
  /// Largest error of a response of `run` relative to the response's own largest value, however small that is.
  Error ownErrorOf(const Solution& run) const;
  /// Largest true error of a response or field of `run` when this is the truth.
  Error errorOf(const Solution& run) const;

 private:
  const Study& study_;
  base::Timers timers_;
  latin::LatinSolver solver_;
  latin::LatinResult result_;
  double cpuSeconds_ = 0.0;
};

/// The truth: the default algorithm, certified to a millionth of the accuracy, or where that cannot be had to a
/// thousandth; null if neither can.
std::unique_ptr<Solution> truthOf(const Study& study, double accuracy);

}  // namespace harmos::benchmarks
