#pragma once

#include <chrono>
#include <iosfwd>

#include <harmos/latin/LatinSolver.hpp>

namespace harmos::cli {

/// Tells a waiting user how a solution goes on: one line per iteration, or one that is overwritten on a terminal, or a
/// line every few seconds.
class Progress {
 public:
  enum class Detail { none, sparse, everyIteration };
  Progress(std::ostream& stream, Detail detail, bool isTerminal);

  void report(const latin::IterationReport& report);
  /// Clears the line on a terminal.
  void finish();

 private:
  std::ostream& stream_;
  Detail detail_;
  bool isTerminal_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace harmos::cli
