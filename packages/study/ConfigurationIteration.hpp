#pragma once

#include <memory>
#include <vector>

#include <harmos/base/Timers.hpp>
#include <harmos/latin/AndersonAcceleration.hpp>
#include <harmos/study/Indicators.hpp>
#include <harmos/study/ReducedBasisStart.hpp>

namespace harmos::study {

/// The iteration of one configuration after another on the same operators: a start from solved states, then linear
/// stages with Anderson acceleration that already knows how the residual changes along these states.
class ConfigurationIteration {
 public:
  /// `memory`: differences that the acceleration keeps beyond those of the start. The phases "start", "indicators" and
  /// "acceleration" are charged to `timers`.
  ConfigurationIteration(latin::FixedPoint& fixedPoint,
                         const std::vector<std::shared_ptr<const latin::Response>>& responses, int neighbours,
                         int memory, base::Timers& timers);

  /// Collective. Begins the configuration whose laws are in the assembly, from alpha = 0 when there are only few
  /// `states`.
  void begin(const SolvedStates& states, const std::vector<double>& values);
  /// Collective. Goes on from a state found elsewhere.
  void beginAt(const base::Matrix& alpha);
  /// Collective. One linear and one local stage; the fields are those of fixedPoint.
  Indicators iterate();

  /// Linear stages since begin(), that for the loads included.
  int stages() const { return stages_; }
  /// ids of the configurations that the start came from.
  const std::vector<int>& starts() const { return starts_; }
  /// alpha [stress] of the last iterate(), and its image under the linear part of the linear stage.
  const base::Matrix& alpha() const { return alpha_; }
  base::Matrix linear() const;

 private:
  void prepare();
  Indicators measure();
  void updateOffset();

  latin::FixedPoint& fixedPoint_;
  const std::vector<std::shared_ptr<const latin::Response>>& responses_;
  int neighbours_;
  base::Timers& timers_;
  ReducedBasisStart start_;
  latin::AndersonAcceleration acceleration_;
  base::Matrix alpha_, next_, image_;
  base::Matrix offset_;              // image of alpha = 0
  std::vector<base::Matrix> loads_;  // of the bodies, for which the offset was computed
  std::vector<double> residuals_;    // of every iterate() since the last restart of the acceleration
  bool hasRestarted_ = false;
  std::vector<int> starts_;
  int stages_ = 0;
};

}  // namespace harmos::study
