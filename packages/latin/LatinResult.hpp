#pragma once

#include <string>
#include <vector>

#include <harmos/latin/ResponseRange.hpp>

namespace harmos::latin {

/// How a run ended.
enum class Outcome {
  certified,       ///< the error estimate is below the accuracy asked for
  iterationLimit,  ///< it is not, after the largest number of iterations; or a law has no graph, see checkLaws()
  roundOff,        ///< it cannot be: double precision has not the digits
  noEquilibrium,   ///< the interface laws cannot carry the loads
  interrupted      ///< the caller asked to stop
};

/// One response at every load step, with the estimate of its relative error.
struct ResponseResult {
  std::string name;            ///< of the response
  std::vector<double> values;  ///< per load step, in the unit of its Quantity
  double errorEstimate = 0.0;  ///< relative to `size`; not a number without a certificate or an attempt at one
  double size = 0.0;           ///< its largest value over the load steps, or its floor, in its unit
  bool isSmall = false;        ///< all values are below the floor, see NaturalSizes: it counts as zero
  ResponseRange range;         ///< what it may be, where the problem does not determine it to the accuracy asked for
};

/// What a run achieved. The fields are read from LatinSolver::state().
struct LatinResult {
  Outcome outcome = Outcome::iterationLimit;  ///< how it ended
  std::string reason;                         ///< one sentence for the user
  std::vector<std::string> remarks;           ///< sentences on what the solution does not determine; of a certified one
  std::vector<std::string> freePressures;     ///< of interfaces whose pressures, and friction, have other solutions
  std::vector<ResponseResult> responses;      ///< in the order of LatinSolver::addResponse()
  double forceErrorEstimate = 0.0;            ///< relative, field of interface forces
  double displacementErrorEstimate = 0.0;     ///< relative, field of interface displacements
  double errorEstimate = 0.0;                 ///< largest of all estimates, which round-off is a part of
  double roundOffEstimate = 0.0;              ///< largest share of round-off in them; 0: far below the accuracy
  double indicator = 0.0;                     ///< the customary |s - s^| / |s|: not an error, for comparison only
  std::vector<int> parts;                     ///< in which each load step was solved, where laws soften; 1: as a whole
  std::vector<bool> snaps;                    ///< of each load step, whether a joint that softens has snapped in it
  int solvedSteps = 0;                        ///< load steps that were solved; later values and fields mean nothing
  int iterations = 0;                         ///< applications of T outside the error estimate, in linear stages
  int linearStages = 0;                       ///< all applications of T, those of the error estimate included

  /// Whether the problem determines all responses and pressures; known of what is certified only.
  bool isUnique() const;
};

}  // namespace harmos::latin
