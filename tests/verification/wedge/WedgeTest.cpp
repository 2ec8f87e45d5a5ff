#include <gtest/gtest.h>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

class Wedge : public ::testing::TestWithParam<double> {};

TEST_P(Wedge, DrivingForce) {
  const double mu = GetParam();
  constexpr double slope = 0.1, length = 40.0, load = 10.0 * length;
  SceneInput scene = SceneInput::fromFile("wedge/wedge.xml");
  scene.set(assignment("Values/mu", mu));
  // The wedge rises towards its thick, driven end; floor and loaded face stay level.
  scene.changeMesh([&](mesh::Mesh& mesh) {
    for (base::Vector3& x : mesh.nodes) {
      const bool inBlock = x[1] > 10.0;
      x[1] += slope * x[0] * (inBlock ? (30.0 - x[1]) / 20.0 : x[1] / 10.0);
    }
  });
  scene.set("Values/drive=-0.1");
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  // Equilibrium of block and wedge with sliding at every node; linear kinematics, so no more than the accuracy of 1e-6
  // and sliding that is not yet complete at single nodes.
  const double expected = load * (slope + mu) / (1.0 - mu * slope);
  EXPECT_NEAR(-run.value("F"), expected, 1e-4 * expected);
}

INSTANTIATE_TEST_SUITE_P(Friction, Wedge, ::testing::Values(0.0, 0.1, 0.2, 0.3),
                         [](const auto& test) { return "Mu" + std::to_string(int(10 * test.param + 0.5)); });

}  // namespace
}  // namespace harmos::verification
