#include <gtest/gtest.h>

#include <harmos/latin/FixedPoint.hpp>

#include "Chains.hpp"

namespace harmos::latin {
namespace {

TEST(Iterate, IsValidUntilTheNext) {
  const assembly::Assembly assembly =
      twoChains(laws::makeLaw("Perfect"), laws::makeLaw("Prescribed Traction", {{"X", 1.0}}, {{"X", {1.0, 2.0}}}), 2);
  base::Timers timers;
  FixedPoint fixedPoint(assembly, {}, self(), timers);
  base::Matrix alpha(fixedPoint.layout().rows(), 2), image(alpha);
  const Iterate& first = fixedPoint.apply(alpha, image);
  EXPECT_TRUE(first.isValid());
  const Iterate& second = fixedPoint.apply(alpha, image);
  EXPECT_FALSE(first.isValid());
  EXPECT_TRUE(second.isValid());
  fixedPoint.selectAll();
  EXPECT_FALSE(second.isValid());
}

}  // namespace
}  // namespace harmos::latin
