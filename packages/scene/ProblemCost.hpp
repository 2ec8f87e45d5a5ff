#pragma once

#include <harmos/latin/LatinOptions.hpp>
#include <harmos/scene/CostEstimate.hpp>
#include <harmos/scene/Problem.hpp>

namespace harmos::scene {

/// How the sizes of factors are found.
enum class FactorSizes {
  fromUnknowns,  ///< from the number of unknowns of every body, which takes no time
  fromOrder      ///< from the order in which METIS would factor, in a small part of the time of factoring
};

/// Collective. `solver`: its options for direct solvers and the accuracy asked for. Sizes of factors: 25 n^(4/3)
/// entries in space and 8 n log2 n in the plane reproduce CHOLMOD with METIS on cubes of 5 000 to 100 000 unknowns
/// within 20 %; n: the unknowns of a body. What processes hold at the peak and what they take are fitted to runs on one
/// core of 2020; times base::machineSlowness() they are within a factor of 1.5 for most scenes elsewhere, too, see
/// tests/benchmarks/cost_table.py. Limits: stages are those of the class of the laws (affine or not), and scenes that
/// converge slowly take more; of very many load steps few may need iterations, which takes less memory. The result is
/// the same on every rank. Throws base::Error when METIS fails.
CostEstimate estimateCost(const Problem& problem, const latin::LatinOptions& solver, FactorSizes sizes,
                          const Teuchos::Comm<int>& comm);

/// Throws base::Error (input) with the remedy when the mesh that a generator would make is so large that a run takes
/// more than 1.5 times `freeBytes`, however its parts are solved: counted are the stiffness matrices of blocks of
/// different sizes, and what solving them iteratively takes. Nothing is made. Files of meshes are not looked at.
void demandRoomForMesh(const Scene& scene, double freeBytes);

/// Throws base::Error (input) with the remedy when a body's factor has more entries than solvers can number, or when
/// the processes take more than 1.5 times `freeBytes`: what is estimated may be so much too large.
void demandCapacity(const CostEstimate& cost, double freeBytes);

/// Collective. The same of a problem that is about to be solved with the memory that the ranks may have, and then
/// differentiated by so many parameters; the order in which METIS would factor is asked for only where the numbers of
/// unknowns do not show that there is room.
void demandCapacity(const Problem& problem, const latin::LatinOptions& solver, int derivatives,
                    const Teuchos::Comm<int>& comm);

}  // namespace harmos::scene
