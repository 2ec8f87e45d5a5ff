#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace harmos::base {

/// Wall and CPU time of a process by phase. A phase that starts inside another one stops the outer one's clock, so that
/// the phases add up to the whole. Not for use by several threads.
class Timers {
 public:
  struct Phase {
    std::string name;
    double wallSeconds = 0.0;
    double cpuSeconds = 0.0;  // of all threads
    int starts = 0;
  };

  /// Ends its phase when it goes out of scope; the last one started must end first.
  class Running {
   public:
    explicit Running(Timers& timers) : timers_(timers) {}
    ~Running() { timers_.stop(); }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

   private:
    Timers& timers_;
  };

  [[nodiscard]] Running start(const std::string& phase);
  /// In the order of their first start.
  const std::vector<Phase>& phases() const { return phases_; }

 private:
  void stop();
  void charge();

  std::vector<Phase> phases_;
  std::vector<std::size_t> running_;  // positions in phases_, the innermost last
  double lastWall_ = 0.0, lastCpu_ = 0.0;
};

/// Largest resident memory of this process so far [byte].
std::size_t peakMemory();

}  // namespace harmos::base
