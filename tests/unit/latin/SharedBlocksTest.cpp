// Bodies of one rank, for some of which the others solve.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>

#include <harmos/latin/LinearStage.hpp>
#include <harmos/substructure/SolverFactory.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"
#include "Displacements.hpp"

namespace harmos::latin {
namespace {

constexpr int steps = 66;  // of two bodies more than travel together

/// Two equal slabs and, if there are others, a plate with more mirror planes and another slab. Each is moved below,
/// lies on springs elsewhere, so that its trace is too large to be kept dense, and is loaded inside.
assembly::Assembly blocks(bool withOthers = true) {
  const auto box = [](const std::string& name, double z, double width, const std::array<int, 3>& cells) {
    return mesh::Box{name, {0, 0, z}, {width, width, z + cells[2]}, cells};
  };
  std::vector<mesh::Box> all{box("skew 1", 20, 14, {14, 14, 5}), box("skew 2", 30, 14, {14, 14, 5})};
  if (withOthers) {
    all.push_back(box("even", 0, 28, {28, 28, 4}));
    all.push_back(box("other", 40, 14, {13, 14, 5}));
  }
  BoxAssembly boxes(all, steps);
  for (const std::string name : {"skew 1", "skew 2", "other"}) {
    boxes.deform(name, [](const base::Vector3& x) {
      return base::Vector3{x[0] + 0.001 * x[0] * x[0] + 0.002 * x[0] * x[1], x[1], x[2]};
    });
  }
  boxes.deform("even", [](const base::Vector3& x) { return base::Vector3{x[0], x[1], x[2] + 0.02 * x[2] * x[2]}; });
  boxes.share(0, 1);
  for (const mesh::Piece& part : boxes.parts()) {
    const std::string& name = part.name;
    for (const std::string side : {"xmin", "xmax", "ymin", "ymax", "zmax"}) {
      boxes.hold(name + " " + side, name + "_" + side,
                 laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 30.0}, {"Tangential Stiffness", 20.0}}));
    }
    boxes.hold("below " + name, name + "_zmin",
               laws::makeLaw("Prescribed Displacement", {{"X", 0.1}, {"Y", 0.0}, {"Z", -0.02}}));
  }
  unsigned seed = 100;
  for (substructure::Substructure& body : boxes.assembly().bodies) {
    body.loads.shape(3 * static_cast<int>(body.nodes.size()), steps);
    randomize(body.loads, ++seed);
  }
  return boxes.assembly();
}

struct Stage {
  Stage(assembly::Assembly given, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
        Elimination which = Elimination::none)
      : assembly(std::move(given)),
        k(assembly, 1.0, *comm),
        eliminated(assembly, k, which,
                   std::vector<ResistedMotions>(assembly.bodies.size(), {true, true, true, true, true, true})),
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

  base::Matrix displacements(int body) const {
    return displacementsOf(linear, body, assembly.bodies[body].nodes.size());
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
        std::vector<int>{size - 1, size - 1, 0, 0}, std::vector<int>{size - 1, size - 1, size - 1, 0}}) {
    assembly::Assembly assembly = blocks();
    assembly.owner = owner;
    Stage shared(std::move(assembly), comm);
    EXPECT_GT(shared.linear.prepareSingle(), 1e-8);
    if (std::count(owner.begin(), owner.end(), owner[0]) == 4) {
      // More than one of a part, so that what is even and what is odd is on different ranks.
      EXPECT_EQ(shared.linear.operators().blocksGiven() >= 4, size > 1);
    }
    for (const int columns : {1, 5, steps}) {
      alone.linear.select(allSteps(columns));
      shared.linear.select(allSteps(columns));
      for (const auto precision : {substructure::Precision::single, substructure::Precision::exact}) {
        const base::Matrix& expected = alone.solve(columns, precision);
        const base::Matrix& found = shared.solve(columns, precision);
        double distance = 0.0, norm = 0.0;
        for (const TraceLayout::Block& block : shared.layout.blocks()) {
          const int begin = alone.layout.begin(block.interface, block.side);
          for (int t = 0; t < columns; ++t) {
            for (int row = 0; row < 3 * block.pairs; ++row) {
              const double there = expected(begin + row, t);
              distance = std::max(distance, std::abs(found(block.begin + row, t) - there));
              norm = std::max(norm, std::abs(there));
            }
          }
        }
        // The same factors solve the same columns; of the largest number others go together than on one rank.
        EXPECT_LE(distance, columns < steps ? 0.0 : 1e-6 * norm);
      }
    }
  }
}

// Where loads and what is held away are parts of the trace of a body as well.
TEST(SharedBlocks, AreCloseToWhatIsExact) {
  if (substructure::availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD solves in single precision";
  for (const Elimination which : {Elimination::none, Elimination::rigid}) {
    Stage stage(blocks(), self(), which);
    const double error = stage.linear.prepareSingle();
    for (const int columns : {1, 5, steps}) {
      stage.linear.select(allSteps(columns));
      base::Matrix exact = stage.solve(columns, substructure::Precision::exact);
      base::Matrix inner = stage.displacements(3);
      base::Matrix difference = stage.solve(columns, substructure::Precision::single);
      EXPECT_GT(exact.normFrobenius(), 0.0);
      difference -= exact;
      EXPECT_GT(difference.normFrobenius(), 0.0);
      EXPECT_LT(difference.normFrobenius(), 10.0 * error * exact.normFrobenius());
      const double size = inner.normFrobenius();
      inner -= stage.displacements(3);
      EXPECT_LT(inner.normFrobenius(), 10.0 * error * size) << "what is inside follows when it is asked for";
      EXPECT_GT(inner.normFrobenius(), 0.0);
    }
  }
}

TEST(SharedBlocks, StayWhereRanksHaveEquallyMuchToSolve) {
  if (substructure::availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD solves in single precision";
  const auto comm = Tpetra::getDefaultComm();
  if (comm->getSize() != 2) GTEST_SKIP() << "for two ranks";
  assembly::Assembly assembly = blocks(false);
  assembly.owner = {0, 1};
  Stage stage(std::move(assembly), comm);
  stage.linear.prepareSingle();
  EXPECT_EQ(stage.linear.operators().blocksGiven(), 0);
}

}  // namespace
}  // namespace harmos::latin
