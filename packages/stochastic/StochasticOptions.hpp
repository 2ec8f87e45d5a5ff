#pragma once

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/stochastic/ChaosLocalStage.hpp>

namespace harmos::stochastic {

/// How a stochastic problem is solved.
struct StochasticOptions {
  Method method = Method::pseudoSpectral;  ///< of the local stage
  double accuracy = 1e-3;  ///< largest error of the mean and of the random part of every response, see ChaosSnapshot
  int maximumIterations = 1000;  ///< applications of both stages to all load steps
  int memory = 30;               ///< differences that the acceleration keeps per load step
  latin::StageOptions stages;    ///< of LATIN; displacement form only
};

}  // namespace harmos::stochastic
