#pragma once

#include <vector>

#include <harmos/base/Error.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::laws {

/// From which load step on a bolt that was tightened by force keeps what that has drawn together.
class Locking {
 public:
  /// Reads what describeLocking() declares. Throws base::Error(input) when no load step is left to tighten in.
  explicit Locking(const input::Parameters& p) {
    if (!p.has("Locked From")) return;
    // Of the time: load steps end where they should but for round-off.
    constexpr double sameTime = 1e-9;
    const double time = p.number("Locked From");
    for (const double end : p.times()) isLocked_.push_back(end > time * (1.0 + sameTime));
    if (isLocked_.empty() || !isLocked_.front()) return;
    throw base::Error(p.where("Locked From") + ": the first load step ends later, so that no load step tightens it.\n" +
                          "  Give the end of the load step that reaches the preload.",
                      base::ExitCode::input);
  }

  /// At a load step, counted from 0.
  bool isLocked(int step) const { return !isLocked_.empty() && isLocked_[static_cast<std::size_t>(step)]; }
  /// The last load step that tightened what is locked at `step`; -1: it is not locked.
  int lockedSince(int step) const {
    if (!isLocked(step)) return -1;
    while (isLocked(step)) --step;  // the first one is never locked
    return step;
  }

 private:
  std::vector<bool> isLocked_;  // per load step; empty: never
};

/// Declares the time from which a bolt is locked.
inline void describeLocking(input::ParameterSpec& p) {
  p.number("Locked From")
      .unit("time")
      .optional()
      .above(0.0)
      .doc(
          "Load steps that end after this time keep what the force has drawn together by then; absent: it is never "
          "locked.");
}

}  // namespace harmos::laws
