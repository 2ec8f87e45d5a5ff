#include <gtest/gtest.h>

#include <harmos/base/BlasKernels.hpp>

namespace harmos::base {
namespace {

TEST(BlasKernels, AreReplacedOnlyWhereOpenBlasDoesNotKnowTheProcessor) {
  EXPECT_EQ(fittingBlasKernels("Prescott", true, true), "SKYLAKEX");
  EXPECT_EQ(fittingBlasKernels("Prescott", true, false), "HASWELL");
  EXPECT_EQ(fittingBlasKernels("Prescott", false, false), "");
  EXPECT_EQ(fittingBlasKernels("Zen", true, true), "");
  EXPECT_EQ(fittingBlasKernels("Haswell", true, true), "");
}

}  // namespace
}  // namespace harmos::base
