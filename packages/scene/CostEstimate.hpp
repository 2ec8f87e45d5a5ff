#pragma once

#include <cstdint>
#include <string>

#include <harmos/scene/SolveSeconds.hpp>

namespace harmos::scene {

/// Entries and memory that are estimated are right within this factor.
inline constexpr double uncertaintyOfCost = 1.5;
/// Direct solvers number the entries of a factor by 32-bit integers.
inline constexpr double mostEntriesOfFactor = 2147483647.0;

/// What solving a problem will take, on all ranks together, from its sizes and measured rates; seconds are of CPU.
struct CostEstimate {
  std::int64_t unknowns = 0;           // displacements of all bodies
  std::int64_t interfaceUnknowns = 0;  // components of all interface sides
  int steps = 0;                       // load steps
  bool isAffine = false;               // all laws are
  double largestFactor = 0.0;          // entries of that of one body
  std::string largestBody;             // whose it is
  double matrixBytes = 0.0;            // stiffness matrices, exact
  double factorBytes = 0.0;            // their Cholesky factors
  double singleBytes = 0.0;            // the same in single precision, at most: dense traces have none
  double iteratedBytes = 0.0;          // of operators that are solved iteratively, with their preconditioners
  double inverseBytes = 0.0;           // of dense traces, in both precisions, where options ask for them
  double fieldBytes = 0.0;             // of the iteration, with its stored vectors
  double processBytes = 0.0;           // resident at the peak, of all processes together; see estimateCost()
  double startSeconds = 0.0;           // the program's start, reading, stiffness matrices
  double factorSeconds = 0.0;          // all factors
  double staticsSeconds = 0.0;         // whether loads can be balanced, and what is held
  double cuttingSeconds = 0.0;         // the order of large parts, by which they are cut or left as they are
  double stageSeconds = 0.0;           // one linear stage of a march with what belongs to it: all load steps
  double readSeconds = 0.0;            // of that, reading factors, in single precision wherever that is allowed
  double columnSeconds = 0.0;          // what goes with that and is no solve, of one load step
  SolveSeconds exactSolves;            // of a linear stage in double precision
  SolveSeconds wholeSolves;            // of whole parts
  double stages = 0.0;                 // linear stages of a run, as scenes with such laws and joints mostly take
  double otherStages = 0.0;            // of these, those that look for other solutions
  double certificateStages = 0.0;      // of these, those of a certificate
  double togetherSeconds = 0.0;        // one of these, for all load steps at once
  double correctionSeconds = 0.0;      // least squares over differences of the march and directions of the certificate
  double wholeSeconds = 0.0;           // the displacements of whole parts at all load steps, once
  double lookSeconds = 0.0;            // the same of loaded and held parts, where stages solve for dense traces only
  double stencilBytes = 0.0;           // of what reactions are taken from instead
  double boundarySeconds = 0.0;        // fields of boundaries at all load steps, once
  double responseSeconds = 0.0;        // values of all responses at all load steps, once
  double loadSeconds = 0.0;            // what other loads of all load steps take before anything is solved
  double responses = 0.0;              // how many there are
  int factored = 0;                    // operators
  int dense = 0;                       // of these with a dense trace
  int inverted = 0;                    // and with its inverse
  double meshErrorSeconds = 0.0;       // its estimate
  double meshErrorBytes = 0.0;         // fields of the responses for it, beyond processBytes
  double fileSeconds = 0.0;            // fields of parts and interfaces
  double fileBytes = 0.0;              // the same, beyond processBytes
  double directionsOfStep = 0.0;       // that a derivative of a load step is sought in
  double derivativeBytes = 0.0;        // see addDerivatives()
  double derivativeSeconds = 0.0;      // the same

  /// How often a run asks for all responses: of the states that its certificate compares, and of its solution.
  static constexpr double evaluations = 5.0;

  /// A whole run [s].
  double seconds() const {
    return startSeconds + cuttingSeconds + factorSeconds + solveSeconds() + wholeSeconds + askingSeconds() +
           resultSeconds() + derivativeSeconds;
  }
  /// What all numbers that a state is judged by take, once [s].
  double evaluationSeconds() const { return boundarySeconds + responseSeconds; }
  /// All times that a run asks for them [s], with the displacements that they need of whole parts.
  double askingSeconds() const { return evaluations * (evaluationSeconds() + lookSeconds); }
  /// What follows the solution [s], but derivatives.
  double resultSeconds() const { return meshErrorSeconds + fileSeconds; }
  /// Counts derivatives of the responses by so many parameters, once.
  void addDerivatives(int parameters);
  /// Least squares [s] of so many iterations over the differences of the last ones, at most `memory`.
  double accelerationSeconds(double iterations, double memory) const;
  /// The solution alone [s], once all is factored.
  double solveSeconds() const { return staticsSeconds + stagesSeconds() + correctionSeconds; }
  /// All linear stages of a run [s].
  double stagesSeconds() const {
    return (stages - certificateStages) * stageSeconds + certificateStages * togetherSeconds;
  }
};

}  // namespace harmos::scene
