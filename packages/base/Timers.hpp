#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace harmos::base {

/// Wall and CPU time of a process by phase. A phase that starts inside another one stops the outer one's clock, so that
/// the phases add up to the whole. Not collective: every rank has its own. Not for use by
/// several threads.
class Timers {
 public:
  /// What a phase has taken so far, without the phases inside it.
  struct Phase {
    std::string name;          // as given to start()
    double wallSeconds = 0.0;  // of a clock that never jumps [s]
    double cpuSeconds = 0.0;   // of all threads [s]
    int starts = 0;            // how often it was started
  };

  /// Ends its phase when it goes out of scope; the last one started must end first. Keeps a reference to the timers,
  /// which must outlive it and stay where they are.
  class Running {
   public:
    /// For start(): ends the innermost phase of `timers` later, but starts none.
    explicit Running(Timers& timers) : timers_(timers) {}
    ~Running() { timers_.stop(); }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

   private:
    Timers& timers_;
  };

  /// Starts the clock of the phase of this name, a new one or one that ran before; keep what it returns as long as the
  /// phase lasts.
  [[nodiscard]] Running start(const std::string& phase);
  /// All phases in the order of their first start; of one that runs, what was before the last start or end of any.
  const std::vector<Phase>& phases() const { return phases_; }

 private:
  void stop();
  void charge();

  std::vector<Phase> phases_;
  std::vector<std::size_t> running_;  // positions in phases_, the innermost last
  double lastWall_ = 0.0, lastCpu_ = 0.0;
};

/// Largest resident memory of this process so far [byte], as Linux counts it.
std::size_t peakMemory();

}  // namespace harmos::base
