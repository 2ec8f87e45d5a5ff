#include <gtest/gtest.h>

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/latin/LatinSolver.hpp>

#include "Chains.hpp"

namespace harmos::latin {
namespace {

// Every group of ranks solves a problem of its own at the same time; ranks outside take no part.
TEST(SubCommunicator, SolvesByItself) {
  const auto world = Tpetra::getDefaultComm();
  const int color = world->getRank() / 2, last = (world->getSize() - 1) / 2;
  const Teuchos::RCP<const Teuchos::Comm<int>> comm = world->split(color, world->getRank());
  const double pull = 1.0 + color;
  assembly::Assembly assembly =
      twoChains(laws::makeLaw("Perfect"), laws::makeLaw("Prescribed Traction", {{"X", pull}}));
  assembly.owner = {0, comm->getSize() - 1};
  base::Timers timers;
  LatinOptions options;
  options.accuracy = 1e-8;
  LatinSolver solver(assembly, options, comm, timers);
  solver.addResponse(std::make_shared<DisplacementResponse>("end", std::vector<DisplacementResponse::Node>{{1, 2, 1.0}},
                                                            base::Vector3{1, 0, 0}));
  const double exact = pull * (1.0 / 10.0 + 1.0 / 20.0);  // three springs of 30, two of 40
  for (int run = 0; run <= last - color; ++run) EXPECT_NEAR(solver.solve().responses[0].values[0], exact, 1e-7);
}

// What is wrong on one rank of a group ends on all of this group, and on no other.
TEST(SubCommunicator, KeepsErrorsToItself) {
  const auto world = Tpetra::getDefaultComm();
  const int color = world->getRank() / 2;
  const auto comm = world->split(color, world->getRank());
  assembly::Assembly assembly = twoChains(laws::makeLaw("Perfect"), laws::makeLaw("Prescribed Traction", {{"X", 1.0}}));
  assembly.owner = {0, comm->getSize() - 1};
  if (color == 0 && comm->getRank() == comm->getSize() - 1) assembly.bodies[1].stiffness = Teuchos::null;
  base::Timers timers;
  const auto make = [&] { LatinSolver(assembly, {}, comm, timers); };
  if (color == 0) {
    EXPECT_THROW(make(), base::Error);
  } else {
    EXPECT_NO_THROW(make());
  }
}

}  // namespace
}  // namespace harmos::latin
