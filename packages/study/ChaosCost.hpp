#pragma once

#include <string>

#include <harmos/scene/CostEstimate.hpp>
#include <harmos/scene/Problem.hpp>
#include <harmos/study/Study.hpp>

namespace harmos::study {

/// What the expansions of a study will take with one local stage, from sizes alone.
struct ChaosCost {
  bool isGalerkin = false;    ///< the local stage; else the pseudo-spectral one
  double iterations = 0.0;    // of a solve
  double terms = 0.0;         // polynomials of the highest order that may be solved
  double points = 0.0;        // of the tensor grid, at which laws are realised
  double replicated = 0.0;    // bytes that every rank has: the program, and laws and polynomials at the points
  double distributed = 0.0;   // bytes of all ranks together: bodies, and fields of all polynomials
  double seconds = 0.0;       // CPU of all ranks together, of one solve
  double solveSeconds = 0.0;  // the same without factors

  /// Peak of the resident memory [byte] of one of so many ranks.
  double bytesOf(int ranks) const { return replicated + distributed / ranks; }
};

/// `cost`: of the problem without random parameters. Memory within a factor of two of what Linux counts, see
/// `ChaosCost.*` among the tests; times are orders of magnitude, of one core of 2020. The study is one of expansions.
ChaosCost estimateChaos(const Study& study, const scene::Problem& problem, const scene::CostEstimate& cost,
                        bool isGalerkin);

/// How laws meet the expansions of a study.
struct ChaosChoice {
  ChaosCost cost;   // of what is taken
  std::string why;  // in words, with the figures of what is not taken
};

/// As the study asks; where it leaves the choice and all laws are affine, Galerkin unless it is dearer: above twice the
/// time of the pseudo-spectral stage and above a second, more memory than there is, or more points than are allowed.
/// Collective over the communicator of the problem and the same on all ranks.
ChaosChoice chooseLocalStage(const Study& study, const scene::Problem& problem, const Teuchos::Comm<int>& comm);

/// Throws base::Error (input) with place and repair when it is more than the machine of any rank has free. Collective.
void demandMemory(const Study& study, const ChaosChoice& choice, const Teuchos::Comm<int>& comm);

}  // namespace harmos::study
