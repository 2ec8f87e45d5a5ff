#pragma once

namespace harmos::latin {

/// What an observer is told after every iteration over all load steps, or after every load step of a march.
struct IterationReport {
  int iteration = 0;       ///< applications of T outside of the error estimate so far, in linear stages
  int linearStages = 0;    ///< all of them so far
  double indicator = 0.0;  ///< |s - s^| / |s|
  double change = 0.0;  ///< largest relative change of the promised quantities over the last iterations; 0: not known
  int loadStep = -1;    ///< of a march; -1: all
};

}  // namespace harmos::latin
