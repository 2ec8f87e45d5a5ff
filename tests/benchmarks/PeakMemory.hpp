#pragma once

namespace harmos::benchmarks {

/// Largest resident memory of this process since construction, above what it was then. Linux only.
class PeakMemory {
 public:
  /// Gives free memory back to the system and starts anew.
  PeakMemory();
  /// [MB]; not a number where the system does not tell.
  double megabytes() const;

 private:
  double before_;
};

}  // namespace harmos::benchmarks
