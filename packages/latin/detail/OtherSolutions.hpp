#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/LatinResult.hpp>
#include <harmos/latin/Response.hpp>

namespace harmos::latin {

/// Finds solutions beside one that is known, where pressures are not determined and friction depends on them
/// (Indeterminacy::pressures).
///
/// From a state next to such a solution, with other pressures, all load steps are marched anew, each with the history
/// that the one before has left. Solutions lie side by side there, so that the march ends at one near where it began,
/// not at the one that is known. Displacement form only.
class OtherSolutions {
 public:
  /// `fixedPoint` must outlive it. `memory` of the acceleration. `accuracy` [-] of the known solution: that of others
  /// is higher. `mustStop` is asked on every rank after every iteration.
  OtherSolutions(FixedPoint& fixedPoint, int memory, double accuracy, std::function<bool()> mustStop);

  /// Collective. Looks along all ways that were found from the known solution `alpha`, and extends the ranges of the
  /// responses by what they are there; the ways are gone. `known`: the responses of that solution, and the linear
  /// stages that it took: each way may take as many, or a hundred. No iterate is valid afterwards.
  void extend(Indeterminacy& found, const base::Matrix& alpha,
              const std::vector<std::shared_ptr<const Response>>& responses, const LatinResult& known);

 private:
  /// Collective. What the responses are at the solution that is found from `start` [stress], a state of all load steps,
  /// per response and load step; nothing where none is found. No iterate is valid afterwards.
  std::optional<std::vector<std::vector<double>>> from(const base::Matrix& start,
                                                       const std::vector<std::shared_ptr<const Response>>& responses);

  FixedPoint& fixedPoint_;
  int memory_;
  double accuracy_;
  std::function<bool()> mustStop_;
  int end_ = 0;  // linear stages of the fixed point at which a march ends
};

}  // namespace harmos::latin
