// Bodies of one rank, for some of which the others solve.
#include <algorithm>

#include <gtest/gtest.h>

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>

#include <harmos/latin/LinearStage.hpp>
#include <harmos/substructure/SolverFactory.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

constexpr int steps = 5;

/// A block with two mirror planes and three slabs with none, two of them equal; each is held on all sides but one,
/// which is loaded.
assembly::Assembly blocks() {
  const auto box = [](const std::string& name, double z, int across, int cells) {
    return mesh::Box{name, {0, 0, z}, {14, 14, z + cells}, {across, 14, cells}};
  };
  BoxAssembly boxes(
      {box("even", 0, 14, 10), box("skew 1", 20, 14, 5), box("skew 2", 30, 14, 5), box("other", 40, 13, 5)}, steps);
  for (const std::string name : {"skew 1", "skew 2", "other"}) {
    boxes.deform(name, [](const base::Vector3& x) {
      return base::Vector3{x[0] + 0.001 * x[0] * x[0] + 0.002 * x[0] * x[1], x[1], x[2]};
    });
  }
  boxes.share(1, 2);
  for (const std::string name : {"even", "skew 1", "skew 2", "other"}) {
    // So many sides that the trace is not solved by itself.
    for (const std::string side : {"xmin", "xmax", "ymin", "ymax", "zmin"})
      boxes.hold(name + " " + side, name + "_" + side, clamp());
    boxes.hold("above " + name, name + "_zmax",
               laws::makeLaw("Pressure", {{"Pressure", 2.0}}, {{"Pressure", {1, 2, 3, 4, 5}}}));
  }
  return boxes.assembly();
}

struct Stage {
  Stage(assembly::Assembly given, const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
      : assembly(std::move(given)),
        k(assembly, 1.0, *comm),
        eliminated(assembly, k, Elimination::none, {}),
        layout(assembly, k, eliminated, comm),
        linear(assembly, k, layout, eliminated, Formulation::displacement, false, {}, timers) {
    linear.select(allSteps(steps));
  }

  /// The trace for tractions that are numbers of their own for each side, and columns from the first on.
  const base::Matrix& solve(int columns, substructure::Precision precision) {
    base::Matrix alpha(layout.rows(), columns), beta(layout.rows(), columns);
    for (const TraceLayout::Block& block : layout.blocks()) {
      base::Matrix own(layout.dimension() * block.pairs, steps);
      randomize(own, static_cast<unsigned>(1 + block.interface));
      for (int t = 0; t < columns; ++t) std::copy_n(own[t], own.numRows(), alpha[t] + block.begin);
    }
    linear.solve(alpha, beta, precision);
    return linear.trace();
  }

  assembly::Assembly assembly;
  base::Timers timers;
  assembly::SearchDirection k;
  EliminatedBoundaries eliminated;
  TraceLayout layout;
  LinearStage linear;
};

TEST(SharedBlocks, AreSolvedAsByTheirOwners) {
  if (substructure::availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD solves in single precision";
  const auto comm = Tpetra::getDefaultComm();
  const int size = comm->getSize();
  Stage alone(blocks(), self());
  alone.linear.prepareSingle();
  EXPECT_EQ(alone.linear.operators().blocksGiven(), 0);
  for (const std::vector<int>& owner :
       {std::vector<int>{0, 0, 0, 0}, std::vector<int>{size - 1, size - 1, size - 1, size - 1},
        std::vector<int>{size - 1, 0, 0, size - 1}}) {
    assembly::Assembly assembly = blocks();
    assembly.owner = owner;
    Stage shared(std::move(assembly), comm);
    const double error = shared.linear.prepareSingle();
    EXPECT_GT(error, 1e-8);
    if (owner[0] == owner[1]) {
      EXPECT_EQ(shared.linear.operators().blocksGiven() > 0, size > 1);
    }
    for (const int columns : {1, steps}) {
      alone.linear.select(allSteps(columns));
      shared.linear.select(allSteps(columns));
      for (const auto precision : {substructure::Precision::single, substructure::Precision::exact}) {
        const base::Matrix& expected = alone.solve(columns, precision);
        const base::Matrix& found = shared.solve(columns, precision);
        for (const TraceLayout::Block& block : shared.layout.blocks()) {
          const int begin = alone.layout.begin(block.interface, block.side);
          for (int t = 0; t < columns; ++t) {
            for (int row = 0; row < 3 * block.pairs; ++row) {
              EXPECT_EQ(found(block.begin + row, t), expected(begin + row, t)) << "the same factors solve it";
            }
          }
        }
      }
    }
  }
}

TEST(SharedBlocks, StayWhereRanksHaveEquallyMuchToSolve) {
  if (substructure::availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD solves in single precision";
  const auto comm = Tpetra::getDefaultComm();
  if (comm->getSize() != 2) GTEST_SKIP() << "for two ranks";
  assembly::Assembly assembly = blocks();
  assembly.owner = {0, 1, 1, 0};
  Stage stage(std::move(assembly), comm);
  stage.linear.prepareSingle();
  EXPECT_EQ(stage.linear.operators().blocksGiven(), 0);
}

}  // namespace
}  // namespace harmos::latin
