#include <cmath>

#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/latin/PointwiseLocalStage.hpp>

#include "Chains.hpp"

namespace harmos::latin {
namespace {

// The side owned by another rank is fetched from it: every rank finds what one rank finds.
TEST(LocalStage, FindsTheSameOnSeveralRanks) {
  const auto comm = Tpetra::getDefaultComm();
  assembly::Assembly alone =
      twoChains(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}), laws::makeLaw("Symmetry"), 2);
  alone.owner = {comm->getRank(), comm->getRank()};
  assembly::Assembly shared = alone;
  shared.owner = {0, comm->getSize() - 1};
  std::vector<base::Matrix> results;
  for (const assembly::Assembly* assembly : {&alone, &shared}) {
    // All stiffnesses are known everywhere here, so that the search direction needs no communication.
    assembly::Assembly onOne = *assembly;
    onOne.owner.clear();
    const assembly::SearchDirection k(onOne, 1.0, *comm);
    const EliminatedBoundaries eliminated(*assembly, k, Elimination::none, {});
    const TraceLayout layout(*assembly, k, eliminated, comm);
    PointwiseLocalStage local(*assembly, k, layout, Formulation::displacement);
    local.select(allSteps(2));
    base::Matrix beta(layout.rows(), 2), traction(layout.rows(), 2);
    for (const TraceLayout::Block& block : layout.blocks()) {
      for (int t = 0; t < 2; ++t) {
        for (int c = 0; c < 3; ++c)
          beta[t][block.begin + c] = std::sin(1.0 + 7 * block.interface + 3 * block.side + c + t);
      }
    }
    local.solve(beta, traction);
    base::Matrix joint(6, 2);
    for (int side = 0; side < 2; ++side) {
      if (layout.begin(1, side) < 0) continue;
      for (int t = 0; t < 2; ++t) std::copy_n(traction[t] + layout.begin(1, side), 3, joint[t] + 3 * side);
    }
    results.push_back(joint);
  }
  for (int side = 0; side < 2; ++side) {
    if (shared.owner[side] != comm->getRank()) continue;
    for (int t = 0; t < 2; ++t) {
      for (int c = 0; c < 3; ++c) EXPECT_EQ(results[0](3 * side + c, t), results[1](3 * side + c, t));
    }
  }
}

}  // namespace
}  // namespace harmos::latin
