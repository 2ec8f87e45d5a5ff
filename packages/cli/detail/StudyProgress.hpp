#pragma once

#include <chrono>
#include <iosfwd>

#include <harmos/results/StudyResults.hpp>

namespace harmos::cli {

/// Tells a waiting user how a study goes on: configurations done, rate, time left; one line that is overwritten on a
/// terminal, else a line every ten seconds.
class StudyProgress {
 public:
  StudyProgress(std::ostream& stream, bool isTerminal);

  /// `results`: those of an earlier run, which do not count for the rate.
  void begin(const results::StudyResults& results);
  void report(const results::StudyResults& results);
  /// Clears the line on a terminal.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  std::ostream& stream_;
  bool isTerminal_;
  int before_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = Clock::now();
};

}  // namespace harmos::cli
