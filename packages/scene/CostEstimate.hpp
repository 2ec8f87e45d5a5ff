#pragma once

#include <cstdint>

#include <harmos/latin/LatinOptions.hpp>
#include <harmos/scene/Problem.hpp>

namespace harmos::scene {

/// What solving a problem will roughly take, on all ranks together; orders of magnitude, from sizes alone.
struct CostEstimate {
  std::int64_t unknowns = 0;           // displacements of all bodies
  std::int64_t interfaceUnknowns = 0;  // components of all interface sides
  double matrixBytes = 0.0;            // stiffness matrices, exact
  double factorBytes = 0.0;            // their Cholesky factors
  double singleBytes = 0.0;            // the same in single precision, at most: dense traces have none
  double fieldBytes = 0.0;             // of the iteration, with its stored vectors
  double processBytes = 0.0;           // resident at the peak, of all processes together; see estimateCost()
  double factorSeconds = 0.0;          // CPU
  double stageSeconds = 0.0;           // CPU of one linear stage
};

/// Collective. `solver`: its options for direct solvers. Factors are estimated as 25 n^(4/3) entries in space and 8 n
/// log2 n in the plane, which reproduces CHOLMOD with METIS on cubes of 5 000 to 100 000 unknowns within 20 %; times
/// are of one core of 2020. n: the unknowns of a body. What processes hold at the peak is fitted to runs, see
/// tests/benchmarks/memory_table.py: within a factor of 1.5, but too little with the quadratic elements of bulky parts
/// and with consistent mass in space (up to 1.6), and too much where few of very many load steps need iterations (up to
/// 3). The result is the same on every rank.
CostEstimate estimateCost(const Problem& problem, const latin::LatinOptions& solver, const Teuchos::Comm<int>& comm);

}  // namespace harmos::scene
