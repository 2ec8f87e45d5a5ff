#pragma once

#include <optional>
#include <vector>

#include <harmos/results/Indicators.hpp>

namespace harmos::results {

/// The smallest ratios of indicators to errors that were seen, at most 1; see parametric::Calibration.
struct Ratios {
  double force = 1.0;                  ///< kf [-], of the force indicator to the error of the field of interface forces
  std::vector<double> responses = {};  ///< kc [-], for each response, of its indicator to its error; empty: none seen
};

/// What a result rests on whose error estimate is a calibrated one, and what a result has taught about such estimates:
/// all that a study needs to go on from results where another run of it has ended.
struct Evidence {
  std::optional<Indicators> indicators;  ///< which it was accepted with; none: not accepted by indicators
  std::optional<Ratios> ratios;          ///< on its way, which was certified far more accurately; none: it was not
  std::optional<double> audit;           ///< error [-] found after it was accepted, over the accuracy; none: no audit
};

}  // namespace harmos::results
