#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

// Ten times the accuracy that the scenes ask for.
constexpr double tolerance = 1e-6;

class BarsInSeries : public ::testing::TestWithParam<int> {};

TEST_P(BarsInSeries, AreExact) {
  const int bars = GetParam();
  constexpr double length = 1000.0, area = 100.0, force = 5000.0, soft = 7e4, stiff = 2.1e5;
  SceneInput scene = SceneInput::fromFile("bars/series.xml");
  for (int i = 1; i <= bars; ++i) {
    const std::string name = "bar_" + std::to_string(i);
    scene.add("Mesh/Boxes", xmlList(name, xmlNumbers("Lower Corner", {(i - 1) * length / bars, 0.0, 0.0}) +
                                              xmlNumbers("Upper Corner", {i * length / bars, 10.0, 10.0}) +
                                              xmlNumbers("Cells", {2.0, 1.0, 1.0})));
    scene.add("Parts", xmlList(name, xmlText("Material", i % 2 == 1 ? "soft" : "stiff")));
    if (i == 1) continue;
    const std::string joint = "joint_" + std::to_string(i - 1);
    scene.add("Interfaces", xmlList(joint, xmlText("Part 1", "bar_" + std::to_string(i - 1)) + xmlText("Part 2", name) +
                                               xmlList("Law", xmlText("Type", "Perfect"))));
    scene.add("Responses", forceResponse(joint + "_force", joint, {1.0, 0.0, 0.0}));
  }
  const std::string end = "bar_" + std::to_string(bars) + "_xmax";
  scene.add("Boundaries",
            xmlList("end", xmlText("Side Set", end) +
                               xmlList("Law", xmlText("Type", "Prescribed Traction") + xmlNumber("X", force / area))));
  scene.add("Responses", xmlList("end", xmlText("Type", "Mean Displacement") + xmlText("Side Set", end) +
                                            xmlNumbers("Direction", {1.0, 0.0, 0.0})));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double expected = force * 0.5 * length / area * (1.0 / soft + 1.0 / stiff);
  EXPECT_NEAR(expected, 0.4761904762, 1e-10);
  EXPECT_NEAR(run.value("end"), expected, tolerance * expected);
  for (int i = 1; i < bars; ++i) {
    EXPECT_NEAR(run.value("joint_" + std::to_string(i) + "_force"), force, tolerance * force);
  }
}

INSTANTIATE_TEST_SUITE_P(Number, BarsInSeries, ::testing::Values(4, 16, 64), ::testing::PrintToStringParamName());

struct GapCase {
  const char* name;
  double push, gap;
};

class TwoBarsAndAGap : public ::testing::TestWithParam<GapCase> {};

/// N = 75000 max(0, U - g), with the springs 210000 and 116666.67 N/mm of the two bars.
void expectForceOfGap(const SolvedScene& run, double push, double gap) {
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double force = 75000.0 * std::max(0.0, push - gap);
  EXPECT_NEAR(run.value("N"), force, tolerance * std::max(force, 1.0));
  const double u1 = push - force / 210000.0, u2 = force * 60.0 / 7e6;
  EXPECT_NEAR(run.value("u1"), u1, tolerance * std::max(std::abs(u1), 0.01));
  EXPECT_NEAR(run.value("u2"), u2, tolerance * 0.01);
}

TEST_P(TwoBarsAndAGap, ObeysTheLawsGap) {
  const GapCase& data = GetParam();
  SceneInput scene = SceneInput::fromFile("../../xml/gap.xml");
  scene.set(assignment("Values/push", data.push)).set(assignment("Values/gap", data.gap));
  expectForceOfGap(SolvedScene(scene), data.push, data.gap);
}

TEST_P(TwoBarsAndAGap, ObeysTheGapOfTheGeometry) {
  const GapCase& data = GetParam();
  SceneInput scene = SceneInput::fromFile("../../xml/gap.xml");
  scene.set(assignment("Values/push", data.push)).set("Values/gap=0");
  scene.add("Interfaces/gap", xmlNumbers("Projection Direction", {1.0, 0.0, 0.0}));
  scene.changeMesh([&](mesh::Mesh& mesh) {
    for (const int node : mesh.blocks[1].connectivity) {
      double& x = mesh.nodes[node][0];
      if (x < 160.0) x = 100.0 + data.gap + (160.0 - 100.0 - data.gap) * std::round((x - 100.0) / 20.0) / 3.0;
    }
  });
  // The second bar is shorter by the gap.
  const double gap = data.gap;
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double spring2 = 7e6 / (60.0 - gap);
  const double force = std::max(0.0, data.push - gap) / (1.0 / 210000.0 + 1.0 / spring2);
  EXPECT_NEAR(run.value("N"), force, tolerance * std::max(force, 1.0));
}

TEST_P(TwoBarsAndAGap, PushesAgainstARigidWall) {
  const GapCase& data = GetParam();
  SceneInput scene = SceneInput::fromFile("../../xml/gap.xml");
  scene.set(assignment("Values/push", data.push));
  for (const char* list : {"Mesh/Boxes/second", "Parts/second", "Interfaces/gap", "Boundaries/fixed", "Responses/u2"}) {
    scene.remove(list);
  }
  scene.add("Boundaries",
            xmlList("gap", xmlText("Side Set", "first_xmax") +
                               xmlList("Law", xmlText("Type", "Unilateral Contact") + xmlNumber("Gap", data.gap))));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double force = 210000.0 * std::max(0.0, data.push - data.gap);
  EXPECT_NEAR(run.value("N"), force, tolerance * std::max(force, 1.0));
}

INSTANTIATE_TEST_SUITE_P(Cases, TwoBarsAndAGap,
                         ::testing::Values(GapCase{"Closes", 0.15, 0.05}, GapCase{"Touches", 0.05, 0.05},
                                           GapCase{"Interferes", 0.0, -0.02}, GapCase{"StaysOpen", 0.02, 0.05},
                                           GapCase{"IsPulled", -0.1, 0.0}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace harmos::verification
