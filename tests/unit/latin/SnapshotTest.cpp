#include <gtest/gtest.h>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/Snapshot.hpp>

#include "Chains.hpp"

namespace harmos::latin {
namespace {

TEST(Snapshot, WeighsTheDifferencesOfLoadStepsByTheirFactors) {
  const assembly::Assembly assembly =
      twoChains(laws::makeLaw("Perfect"), laws::makeLaw("Prescribed Traction", {{"X", 1.0}}, {{"X", {1.0, 2.0}}}), 2);
  base::Timers timers;
  FixedPoint fixedPoint(assembly, {}, self(), timers);
  const std::vector<std::shared_ptr<const Response>> responses{std::make_shared<DisplacementResponse>(
      "u", std::vector<DisplacementResponse::Node>{{1, 0, 1.0}}, base::Vector3{1, 0, 0})};
  base::Matrix alpha(fixedPoint.layout().rows(), 2), image(alpha);
  const Snapshot before(fixedPoint.apply(alpha, image), responses);
  for (int row = 0; row < alpha.numRows(); ++row) alpha(row, 1) += 0.1;
  const Snapshot after(fixedPoint.apply(alpha, image), responses);
  const std::vector<double> plain = after.distance(before), first = after.distance(before, {7.0, 1.0}),
                            second = after.distance(before, {1.0, 3.0});
  ASSERT_EQ(plain.size(), 3U);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_GT(plain[i], 0.0) << i;
    EXPECT_DOUBLE_EQ(first[i], plain[i]) << i;
    EXPECT_DOUBLE_EQ(second[i], 3.0 * plain[i]) << i;
  }
}

}  // namespace
}  // namespace harmos::latin
