#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

TEST(BoltDiagram, FollowsTheSprings) {
  const SolvedScene run(SceneInput::fromFile("bolt_diagram/bolt.xml"));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  // F0 = g kb kp / (kb + kp); the external force Q adds Q kb / (kb + kp) to the bolt until the columns open at 21000.
  const std::vector<double> bolt = {16800.0, 18800.0, 20800.0, 25000.0};
  const std::vector<double> parts = {16800.0, 8800.0, 800.0, 0.0};
  // The head is 1e6 times stiffer than the columns: its bending adds about 1e-6. (Stiffer still, and round-off does.)
  constexpr double tolerance = 1e-5;
  for (int t = 0; t < 4; ++t) {
    const auto i = static_cast<std::size_t>(t);
    EXPECT_NEAR(run.value("bolt", t), bolt[i], tolerance * bolt[i]);
    EXPECT_NEAR(run.value("left_force", t) + run.value("right_force", t), parts[i], tolerance * 16800.0);
  }
  EXPECT_NEAR(run.value("opening", 3), 4000.0 / 420000.0, tolerance * 4000.0 / 420000.0);
  EXPECT_NEAR(run.value("opening", 2), 0.0, 1e-7);
}

// The cuts through the head are as stiff as it is: what they move as a whole outweighed all forces, and the march did
// not end within four hundred linear stages.
TEST(BoltDiagram, FollowsTheSpringsWhateverItsPartsAreCutInto) {
  for (const int pieces : {3, 4, 8}) {
    SceneInput scene = SceneInput::fromFile("bolt_diagram/bolt.xml");
    for (const char* part : {"bolt", "left", "right", "head"})
      scene.set("Parts/" + std::string(part) + "/Pieces=" + std::to_string(pieces));
    scene.set("Solver/Accuracy=1e-4").set("Solver/Maximum Iterations=150");
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << pieces << " pieces: " << run.result.reason;
    const std::vector<double> bolt = {16800.0, 18800.0, 20800.0, 25000.0};
    for (int t = 0; t < 4; ++t) {
      const auto i = static_cast<std::size_t>(t);
      EXPECT_NEAR(run.value("bolt", t), bolt[i], 1.1e-4 * 25000.0) << pieces << " pieces";
    }
    EXPECT_NEAR(run.value("opening", 3), 4000.0 / 420000.0, 1.1e-4 * 4000.0 / 420000.0) << pieces << " pieces";
  }
}

}  // namespace
}  // namespace harmos::verification
