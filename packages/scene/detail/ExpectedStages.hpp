#pragma once

#include <harmos/latin/LatinOptions.hpp>
#include <harmos/scene/detail/CostScope.hpp>

namespace harmos::scene {

/// Linear stages that a run is expected to take.
struct ExpectedStages {
  static constexpr double directStages = 4.0;  ///< where nothing is left to iterate on
  static constexpr double ways = 2.0;          ///< along which other solutions are looked for

  double march = directStages, certificate = 0.0;
  double others = 0.0;      ///< that look for other solutions
  double directions = 0.0;  ///< of a derivative, at a load step
  double all() const { return march + certificate + others; }
};

/// Those of a scene that is iterated on, as scenes with such laws and joints mostly take.
ExpectedStages expectedStages(const CostScope& scope, const latin::LatinOptions& solver);

}  // namespace harmos::scene
