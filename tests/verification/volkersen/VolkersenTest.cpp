#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

/// Shear in the glue at a place along the joint.
double shearAt(const SolvedScene& run, double x) {
  const auto pairs = run.pairs("glue");
  const auto nearest = std::min_element(pairs.begin(), pairs.end(), [&](const PairValue& a, const PairValue& b) {
    return std::abs(a.position[0] - x) < std::abs(b.position[0] - x);
  });
  return std::hypot(nearest->traction[1], nearest->traction[2]);
}

TEST(Volkersen, ShearOfTheGlue) {
  const SolvedScene run(SceneInput::fromFile("volkersen/volkersen.xml"));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_NEAR(run.value("force"), 100.0, 1e-4);
  // Volkersen: tau = F w cosh(w x) / (2 sinh(w l / 2)), w^2 = 2 k_t / (E t); his adherends do not shear, hence 4 %.
  const double w = std::sqrt(2.0 * 574.7126436781609 / (7e4 * 2.0));
  const double ends = 50.0 * w / std::tanh(25.0 * w), middle = 50.0 * w / std::sinh(25.0 * w);
  EXPECT_NEAR(ends, 4.6292, 1e-4);
  EXPECT_NEAR(shearAt(run, 0.0), ends, 0.04 * ends);
  EXPECT_NEAR(shearAt(run, 50.0), ends, 0.04 * ends);
  EXPECT_NEAR(shearAt(run, 25.0), middle, 0.04 * middle);
  // Finite elements in the plane; 1 % for another mesh.
  EXPECT_NEAR(shearAt(run, 0.0), 4.574, 0.01 * 4.574);
  EXPECT_NEAR(shearAt(run, 25.0), 0.966, 0.01 * 0.966);
  EXPECT_NEAR(shearAt(run, 50.0), 4.466, 0.01 * 4.466);
}

}  // namespace
}  // namespace harmos::verification
