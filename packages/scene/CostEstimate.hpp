#pragma once

#include <cstdint>

#include <harmos/scene/Problem.hpp>

namespace harmos::scene {

/// What solving a problem will roughly take, on all ranks together; orders of magnitude, from sizes alone.
struct CostEstimate {
  std::int64_t unknowns = 0;           // displacements of all bodies
  std::int64_t interfaceUnknowns = 0;  // components of all interface sides
  double matrixBytes = 0.0;            // stiffness matrices, exact
  double factorBytes = 0.0;            // their Cholesky factors
  double fieldBytes = 0.0;             // of the iteration, with its stored vectors
  double factorSeconds = 0.0;          // CPU
  double stageSeconds = 0.0;           // CPU of one linear stage
};

/// Collective. Factors are estimated as 25 n^(4/3) entries in space and 8 n log2 n in the plane, which reproduces
/// CHOLMOD with METIS on cubes of 5 000 to 100 000 unknowns within 20 %; times are of one core of 2020. n: the unknowns
/// of a body. The result is the same on every rank.
CostEstimate estimateCost(const Problem& problem, const Teuchos::Comm<int>& comm);

}  // namespace harmos::scene
