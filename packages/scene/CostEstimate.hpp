#pragma once

#include <cstdint>
#include <string>

#include <harmos/latin/LatinOptions.hpp>
#include <harmos/scene/Problem.hpp>

namespace harmos::scene {

/// How the sizes of factors are found.
enum class FactorSizes {
  fromUnknowns,  ///< from the number of unknowns of every body, which takes no time
  fromOrder      ///< from the order in which METIS would factor, in a small part of the time of factoring
};

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
  double inverseBytes = 0.0;           // of dense traces, in both precisions, where options ask for them
  double fieldBytes = 0.0;             // of the iteration, with its stored vectors
  double processBytes = 0.0;           // resident at the peak, of all processes together; see estimateCost()
  double startSeconds = 0.0;           // the program's start, reading, stiffness matrices
  double factorSeconds = 0.0;          // all factors
  double stageSeconds = 0.0;           // one linear stage with what belongs to it: all load steps
  double stages = 0.0;                 // linear stages to a certificate, as scenes with such laws mostly take
  double resultSeconds = 0.0;          // error of the mesh, files

  /// A whole run [s].
  double seconds() const { return startSeconds + factorSeconds + stages * stageSeconds + resultSeconds; }
};

/// Collective. `solver`: its options for direct solvers and the accuracy asked for. Sizes of factors: 25 n^(4/3)
/// entries in space and 8 n log2 n in the plane reproduce CHOLMOD with METIS on cubes of 5 000 to 100 000 unknowns
/// within 20 %; n: the unknowns of a body. What processes hold at the peak and what they take are fitted to runs on one
/// core of 2020, see tests/benchmarks/cost_table.py: within a factor of 1.5 for most scenes. Limits: stages are those
/// of the class of the laws (affine or not), and scenes that converge slowly take more; of very many load steps few may
/// need iterations, which takes less memory. The result is the same on every rank. Throws base::Error when METIS fails.
CostEstimate estimateCost(const Problem& problem, const latin::LatinOptions& solver, FactorSizes sizes,
                          const Teuchos::Comm<int>& comm);

/// Throws base::Error (input) with the remedy when a body's factor has more entries than solvers can number, or when
/// the processes take more than 1.5 times `freeBytes`: what is estimated may be so much too large.
void demandCapacity(const CostEstimate& cost, double freeBytes);

}  // namespace harmos::scene
