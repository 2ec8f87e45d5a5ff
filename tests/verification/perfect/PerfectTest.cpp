#include <gtest/gtest.h>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

// Both runs are accurate to 1e-6 in the area-weighted mean over interfaces; single nodes may be somewhat worse.
constexpr double tolerance = 1e-5;

SceneInput beam(const std::string& element, int pieces) {
  SceneInput scene = SceneInput::fromFile("perfect/beam.xml");
  return scene.set("Mesh/Boxes/beam/Element=" + element).set("Parts/beam/Pieces=" + std::to_string(pieces));
}

const SolvedScene& uncut(const std::string& element) {
  static std::map<std::string, SolvedScene> runs;
  return runs.try_emplace(element, beam(element, 1)).first->second;
}

class CutBeam : public ::testing::TestWithParam<std::pair<const char*, int>> {};

TEST_P(CutBeam, EqualsTheUncutBeam) {
  const auto [element, pieces] = GetParam();
  const SolvedScene& whole = uncut(element);
  ASSERT_TRUE(whole.isCertified()) << whole.result.reason;
  EXPECT_NEAR(whole.value("wall_z"), 5.0 * 400.0 + 0.01 * 32000.0, 1e-3);
  const SolvedScene run(beam(element, pieces));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_LE(displacementDifference(run, whole), tolerance);
  for (const char* name : {"end_y", "end_z", "wall_z"}) {
    EXPECT_NEAR(run.value(name), whole.value(name), 2e-6 * std::abs(whole.value(name))) << name;
  }
  // Forces inside the beam measure nothing, so that the cuts leave the accuracy of the others as it was.
  const std::size_t wallX = 2;
  ASSERT_TRUE(whole.result.responses[wallX].isSmall);
  EXPECT_NEAR(run.result.responses[wallX].size, whole.result.responses[wallX].size,
              1e-4 * whole.result.responses[wallX].size);
}

INSTANTIATE_TEST_SUITE_P(Pieces, CutBeam,
                         ::testing::Values(std::pair("Hex8", 2), std::pair("Hex8", 3), std::pair("Hex8", 8),
                                           std::pair("Hex8", 27), std::pair("Hex8", 64), std::pair("Tet4", 16),
                                           std::pair("Wedge6", 16), std::pair("Pyramid5", 16)),
                         [](const auto& test) {
                           return test.param.first + std::string("Pieces") + std::to_string(test.param.second);
                         });

}  // namespace
}  // namespace harmos::verification
