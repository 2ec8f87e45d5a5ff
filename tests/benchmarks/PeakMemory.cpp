#include "PeakMemory.hpp"

#include <fstream>
#include <limits>
#include <string>

#include <malloc.h>

namespace harmos::benchmarks {
namespace {

/// A line of /proc/self/status [MB].
double status(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;) {
    double kilobytes = 0.0;
    if (word == name + ":" && file >> kilobytes) return kilobytes / 1024.0;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

PeakMemory::PeakMemory() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;  // resets VmHWM; see proc(5)
  before_ = status("VmRSS");
}

double PeakMemory::megabytes() const {
  return status("VmHWM") - before_;
}

}  // namespace harmos::benchmarks
