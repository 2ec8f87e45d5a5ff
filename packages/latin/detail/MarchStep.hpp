#pragma once

#include <limits>
#include <optional>
#include <utility>

#include <harmos/latin/EquilibriumWatch.hpp>
#include <harmos/latin/detail/Stagnation.hpp>

namespace harmos::latin {

/// How far a March has come at one load step, and what watches over it.
struct MarchStep {
  explicit MarchStep(EquilibriumWatch unused) : unusedWatch(std::move(unused)), watch(unusedWatch) {}

  /// The state has been moved to where an equilibrium is to be looked for anew.
  void lookAgain() {
    watch = unusedWatch;
    land();
  }
  /// The state has been moved, and its watch knows that.
  void land() {
    stagnation = Stagnation();
    sinceLanding = 0;
    isListening = false;
  }

  const EquilibriumWatch unusedWatch;
  EquilibriumWatch watch;
  Stagnation stagnation;
  int iterations = 0, sinceLanding = 0, landings = 0;
  double residual = 0.0, force = 0.0, whole = 0.0;  // of the last iteration; norms of T(alpha) - alpha, f^ and T(alpha)
  double floor = 0.0;                               // of residuals, where it was asked for
  double halved = std::numeric_limits<double>::infinity();
  int sinceHalved = 0;
  int newtonTries = 0;
  int softeningTries = 0;  // left
  bool wasTried = false;   // Newton's method, since laws soften
  bool isListening = false;
  bool isReached = false;
  std::optional<base::Matrix> slid;  // where Newton's method has led with this search direction
};

}  // namespace harmos::latin
