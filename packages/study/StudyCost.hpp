#pragma once

#include <harmos/scene/CostEstimate.hpp>
#include <harmos/study/ChaosCost.hpp>
#include <harmos/study/Study.hpp>

namespace harmos::study {

/// What a study will take, from sizes and measured rates.
struct StudyCost {
  double solves = 0.0;   ///< configurations, or expansions with every spread of their sweeps
  double stages = 0.0;   ///< linear stages of one of them, all together over their number
  double seconds = 0.0;  ///< CPU of the whole
  /// Of solved states that the starts of others are made of, and of configurations that march beside one another,
  /// beyond what one run takes.
  double bytes = 0.0;
  int sideBySide = 1;  ///< configurations that march so in the end
};

/// The options that the configurations of a study which does not solve for expansions are solved with.
latin::LatinOptions solverOptions(const Study& study);

/// How many configurations a study may come to: those that are listed, of an adaptive design its Maximum Count.
int mostConfigurations(const Study& study);

/// `cost`: of the scene with the accuracy of the study. Of so many configurations that are like those that are listed.
/// Stages are fitted to studies of the bolted joint of 12 to 1296 configurations at 1 to 0.01 %, of which a few
/// calibrate the error estimate and the others start from neighbours; of other scenes they are a guess.
StudyCost estimateStudy(const Study& study, const scene::CostEstimate& cost, int configurations);

/// Of a study that solves for expansions.
StudyCost estimateStudy(const Study& study, const scene::CostEstimate& cost, const ChaosCost& chaos);

}  // namespace harmos::study
