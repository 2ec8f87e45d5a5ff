#include <harmos/base/Timers.hpp>

#include <sys/resource.h>
#include <time.h>

#include <algorithm>

namespace harmos::base {

namespace {

double seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

/// Adds the time since the last start or stop to the innermost running phase.
void Timers::charge() {
  const double wall = seconds(CLOCK_MONOTONIC);
  const double cpu = seconds(CLOCK_PROCESS_CPUTIME_ID);
  if (!running_.empty()) {
    phases_[running_.back()].wallSeconds += wall - lastWall_;
    phases_[running_.back()].cpuSeconds += cpu - lastCpu_;
  }
  lastWall_ = wall;
  lastCpu_ = cpu;
}

Timers::Running Timers::start(const std::string& phase) {
  charge();
  const auto found =
      std::find_if(phases_.begin(), phases_.end(), [&phase](const Phase& other) { return other.name == phase; });
  running_.push_back(static_cast<std::size_t>(found - phases_.begin()));
  if (found == phases_.end()) phases_.push_back({phase});
  ++phases_[running_.back()].starts;
  return Running(*this);
}

void Timers::stop() {
  charge();
  running_.pop_back();
}

std::size_t peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace harmos::base
