#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/laws/LocalLine.hpp>

namespace harmos::latin {

/// Local stage: from beta = f - k w of the linear stage to tractions f^ that obey the laws of the interfaces.
///
/// The new state is alpha = f^ + k w^ = 2 f^ - beta.
class LocalStage {
 public:
  LocalStage() = default;
  virtual ~LocalStage() = default;
  LocalStage(const LocalStage&) = delete;
  LocalStage& operator=(const LocalStage&) = delete;

  /// Sets which load step each column of a field is, in ascending order; to be called before the first solve().
  virtual void select(const std::vector<int>& steps) = 0;
  /// From now on the first column follows on the last one that was solved.
  virtual void startFromHere() = 0;
  /// From now on the first column follows on the unloaded state again, as after construction.
  virtual void startUnloaded() = 0;

  /// Collective. Overwrites `traction` with f^ [stress] of every row, given `beta` [stress].
  /// Throws base::Error naming interface and step when a law returns a value that is not finite. What a law throws
  /// on some ranks ends this on all, see base::onEachRank().
  virtual void solve(const base::Matrix& beta, base::Matrix& traction) = 0;

  /// Traction and status of the pairs of one interface, columns x pairs, as last solved on this rank; empty if no side
  /// is owned here, or where the stage does not meet laws pair by pair.
  virtual const std::vector<laws::LocalState>& states(int interfaceIndex) const = 0;
};

}  // namespace harmos::latin
