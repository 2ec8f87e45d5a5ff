#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/latin/TraceLayout.hpp>

#include "Chains.hpp"

namespace harmos::latin {
namespace {

TEST(TraceLayout, HasABlockOfRowsForEverySideOwnedHere) {
  const auto comm = Tpetra::getDefaultComm();
  const auto pull = std::shared_ptr<const laws::InterfaceLaw>(laws::makeLaw("Prescribed Traction", {{"X", 1.0}}));
  assembly::Assembly assembly = twoChains(laws::makeLaw("Perfect"), pull);
  assembly.interfaces[1].area[0] = 2.5;
  const int second = comm->getSize() - 1;
  assembly.owner = {0, second};
  const assembly::SearchDirection k(assembly, 1.0, *comm);
  const EliminatedBoundaries eliminated(assembly, k, Elimination::none, {});
  const TraceLayout layout(assembly, k, eliminated, comm);
  const bool ownsLeft = comm->getRank() == 0, ownsRight = comm->getRank() == second;

  EXPECT_EQ(layout.owns(0), ownsLeft);
  EXPECT_EQ(layout.owns(1), ownsRight);
  EXPECT_EQ(layout.begin(0, 0), ownsLeft ? 0 : -1);
  EXPECT_EQ(layout.begin(0, 1), -1);  // no second side
  EXPECT_EQ(layout.begin(1, 0), ownsLeft ? 3 : -1);
  EXPECT_EQ(layout.begin(1, 1), ownsRight ? (ownsLeft ? 6 : 0) : -1);
  EXPECT_EQ(layout.begin(2, 0), -1);  // a prescribed traction carries no unknowns
  ASSERT_EQ(layout.area().size(), static_cast<std::size_t>(layout.rows()));
  ASSERT_EQ(layout.stiffness().size(), static_cast<std::size_t>(layout.rows()));
  for (const TraceLayout::Block& block : layout.blocks()) {
    EXPECT_EQ(block.begin, layout.begin(block.interface, block.side));
    for (int row = block.begin; row < block.begin + 3 * block.pairs; ++row) {
      EXPECT_EQ(layout.area()[row], block.interface == 1 ? 2.5 : 1.0);
      EXPECT_EQ(layout.stiffness()[row], k.of(block.interface)[0]);
    }
  }
  // A rank without bodies has one row of no weight.
  if (!ownsLeft && !ownsRight) {
    EXPECT_EQ(layout.rows(), 1);
    EXPECT_EQ(layout.area()[0], 0.0);
  }
}

}  // namespace
}  // namespace harmos::latin
