#include <gtest/gtest.h>

#include <algorithm>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

struct Cycle {
  const char* name;
  double amplitude;
  double area;  // 4 * 30 (A - .03)
};

class Jenkins : public ::testing::TestWithParam<Cycle> {};

TEST_P(Jenkins, LoopArea) {
  const Cycle& cycle = GetParam();
  SceneInput scene = SceneInput::fromFile("jenkins/jenkins.xml");
  const SolvedScene run(scene.set(assignment("Values/amplitude", cycle.amplitude)));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  // The block's own flexibility makes 1 % of 4 * 30 * .02; without sliding nothing may be lost.
  const double tolerance = std::max(0.01 * cycle.area, 1e-3);
  EXPECT_NEAR(run.value("dissipation", 40) - run.value("dissipation", 20), cycle.area, tolerance);
  // The same from outside: the force-displacement loop of the driven end.
  double loop = 0.0;
  const auto& reaction = run.values("reaction");
  for (std::size_t t = 21; t <= 40; ++t) {
    const double step = (t <= 30 ? -0.2 : 0.2) * cycle.amplitude;
    loop += 0.5 * (reaction[t] + reaction[t - 1]) * step;
  }
  // The trapezoidal rule cuts the corners of the loop: increments are a tenth of the half cycle.
  EXPECT_NEAR(loop, cycle.area, std::max(0.06 * cycle.area, 1e-3));
  // Without sliding the flexibility of bar and block shows: 1000 N/mm in series with about 3e5 N/mm.
  EXPECT_NEAR(*std::max_element(reaction.begin(), reaction.end()), 30.0, cycle.area > 0.0 ? 0.01 : 0.005 * 30.0);
}

INSTANTIATE_TEST_SUITE_P(Amplitudes, Jenkins,
                         ::testing::Values(Cycle{"Stick", 0.03, 0.0}, Cycle{"Slide", 0.05, 2.4},
                                           Cycle{"SlideFar", 0.1, 8.4}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace harmos::verification
