#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <harmos/base/Timers.hpp>
#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/IterationReport.hpp>
#include <harmos/latin/LatinOptions.hpp>
#include <harmos/latin/LatinResult.hpp>
#include <harmos/latin/LoadBalance.hpp>
#include <harmos/latin/Response.hpp>

namespace harmos::latin {

/// The iteration of the literature: alpha <- T(alpha) over all load steps at once, plain, relaxed or accelerated, until
/// the promised quantities have settled and the certificate claims, or a body moves on for ever. Collective.
class SimultaneousIteration {
 public:
  /// Asked or told on every rank.
  struct Callbacks {
    std::function<bool()> mustStop;
    /// Whether the run ends with this iterate of alpha, which may be corrected.
    std::function<bool(const Iterate&)> certify;
    std::function<void(const Iterate&, const IterationReport&)> observe;  ///< empty: nobody is told
  };

  /// All must outlive it.
  SimultaneousIteration(FixedPoint& fixedPoint, LoadBalance& balance,
                        const std::vector<std::shared_ptr<const Response>>& responses, const LatinOptions& options,
                        base::Timers& timers)
      : fixedPoint_(fixedPoint), balance_(balance), responses_(responses), options_(options), timers_(timers) {}

  /// Goes on from alpha [stress]; `image`: room of its shape. The run has begun after `stagesBefore` linear stages of
  /// the fixed point. Sets outcome and reason where it ends otherwise than by the certificate, and counts iterations.
  void run(base::Matrix& alpha, base::Matrix& image, int stagesBefore, const Callbacks& callbacks, LatinResult& result);

 private:
  FixedPoint& fixedPoint_;
  LoadBalance& balance_;
  const std::vector<std::shared_ptr<const Response>>& responses_;
  const LatinOptions& options_;
  base::Timers& timers_;
};

}  // namespace harmos::latin
