// The search direction is a means: what is certified does not depend on it, also where bodies do not feel how joints
// share what they transmit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "Honest.hpp"

namespace harmos::verification {
namespace {

// Of the sum of two estimates: the effectivity of one is 0.64 to 2 on the random campaign.
constexpr double effectivity = 2.0;
constexpr double roundOff = 1e-7;  // of the size of a response
constexpr double scales[] = {0.1, 1.0, 10.0};

std::vector<std::unique_ptr<SolvedRun>> runsOf(const SceneInput& scene) {
  std::vector<std::unique_ptr<SolvedRun>> runs;
  for (const double scale : scales) {
    SceneInput scaled = scene;
    auto run = std::make_unique<SolvedRun>(scaled.set(assignment("Solver/Search Direction/Scale", scale)));
    EXPECT_TRUE(run->isCertified()) << "scale " << scale << ": " << run->result().reason;
    if (run->isCertified()) runs.push_back(std::move(run));
  }
  return runs;
}

/// Every pair of certified runs agrees to what their estimates say.
void expectOneAnswer(const std::vector<std::unique_ptr<SolvedRun>>& runs) {
  for (std::size_t a = 0; a < runs.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const auto &first = runs[a]->result().responses, &second = runs[b]->result().responses;
      for (std::size_t i = 0; i < first.size(); ++i) {
        const double allowed =
            effectivity * (first[i].errorEstimate * first[i].size + second[i].errorEstimate * second[i].size) +
            roundOff * first[i].size;
        for (std::size_t t = 0; t < first[i].values.size(); ++t) {
          EXPECT_NEAR(first[i].values[t], second[i].values[t], allowed)
              << first[i].name << ", load step " << t + 1 << ", runs " << b << " and " << a;
        }
      }
    }
  }
}

SceneInput sceneAt(const std::string& name) {
  return SceneInput::fromFile("../verification/" + name + ".xml");
}

class AnyScale : public testing::TestWithParam<const char*> {};

TEST_P(AnyScale, GivesOneAnswer) {
  expectOneAnswer(runsOf(sceneAt(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Scenes, AnyScale,
                         testing::Values("contact_patch/plane", "jenkins/jenkins", "perfect/beam", "wedge/wedge",
                                         "volkersen/volkersen", "joint_laws/block", "joints/one_bolt", "cohesive/snap",
                                         "../extremes/held_friction", "../extremes/pressed_blocks",
                                         "../extremes/loose_blocks", "../extremes/dragged_block",
                                         "../extremes/driven_block", "../extremes/block_on_springs"),
                         [](const auto& test) { return "Number" + std::to_string(test.index); });

class AnyScaleLong : public testing::TestWithParam<const char*> {};

TEST_P(AnyScaleLong, GivesOneAnswer) {
  expectOneAnswer(runsOf(sceneAt(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, AnyScaleLong,
    testing::Values("contact_patch/space", "bolt_diagram/bolt", "cylinders/hertz", "cylinders/cattaneo_mindlin",
                    "sliding_block/sliding_block", "../../xml/bolted_joint", "../../xml/glued_assembly",
                    "../../xml/gap", "../extremes/thin_plates", "../extremes/plates_in_contact",
                    "../extremes/lifted_block", "results/two_blocks", "periodic/laminate", "pretension/clamped_plates",
                    "elements/pressed_ring", "nonmatching/partial_cover", "nonmatching/press_fit",
                    "nonmatching/lap_joint", "../../xml/rigid_roller", "../../xml/bimetal_strip",
                    "../../xml/glue_by_formula", "../../xml/rough_glue", "../regression/sliding_blocks/sliding_blocks"),
    [](const auto& test) { return "Number" + std::to_string(test.index); });

const latin::ResponseResult& responseOf(const SolvedRun& run, const std::string& name) {
  const auto& all = run.result().responses;
  return *std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
}

// The floor's pressure and the wall's friction act on one node along one line: resultants differed by 20 %.
TEST(AnyScale, SharesTheForceInACornerInOneWay) {
  const auto runs = runsOf(SceneInput::fromFile("block_in_corner.xml"));
  ASSERT_EQ(runs.size(), 3U);
  expectOneAnswer(runs);
  for (const auto& run : runs) {
    EXPECT_FALSE(run->result().isUnique());
    EXPECT_LT(responseOf(*run, "u").range.widest(), 0);
    for (const char* name : {"N of floor", "N of wall", "T of floor"}) {
      const auto& response = responseOf(*run, name);
      const int step = response.range.widest();
      ASSERT_GE(step, 0) << name;
      // Without the sharing, the three scales gave values 0.2 apart.
      EXPECT_GT(response.range.width(), 0.2) << name;
      EXPECT_LE(response.range.lower[step], response.values[step] + roundOff) << name;
      EXPECT_GE(response.range.upper[step], response.values[step] - roundOff) << name;
      EXPECT_NE(std::count_if(run->result().remarks.begin(), run->result().remarks.end(),
                              [&](const std::string& text) { return text.find(name) != std::string::npos; }),
                0);
    }
  }
}

TEST(AnyScale, SharesTheForceAtACrossingOfJointsInOneWay) {
  const auto runs = runsOf(SceneInput::fromFile("glued_cross.xml"));
  ASSERT_EQ(runs.size(), 3U);
  expectOneAnswer(runs);
  for (const auto& run : runs) {
    const auto& range = responseOf(*run, "X of ab").range;
    ASSERT_EQ(range.widest(), 0);
    EXPECT_EQ(range.upper[0], std::numeric_limits<double>::infinity());
    EXPECT_EQ(range.lower[0], -std::numeric_limits<double>::infinity());
    EXPECT_LT(responseOf(*run, "u").range.widest(), 0);
  }
}

// The face that is held takes the shear at the edge; friction there could take up to mu p h of it.
TEST(AnyScale, NamesFrictionAtAHeldEdge) {
  SceneInput scene = SceneInput::fromFile("held_friction.xml");
  const SolvedRun run(scene);
  ASSERT_TRUE(run.isCertified());
  EXPECT_FALSE(run.result().isUnique());
  const auto &shear = responseOf(run, "T").range, &reaction = responseOf(run, "X of left").range;
  ASSERT_GE(shear.widest(), 0);
  ASSERT_GE(reaction.widest(), 0);
  EXPECT_NEAR(shear.width(), reaction.width(), 1e-9);
  EXPECT_LT(responseOf(run, "N").range.widest(), 0);
}

// The ground and the face beside it hold the corner alike.
TEST(AnyScale, NamesReactionsThatTwoBoundariesShare) {
  const SolvedRun run(SceneInput::fromFile("held_friction.xml"));
  ASSERT_TRUE(run.isCertified());
  const auto& range = responseOf(run, "X of ground").range;
  ASSERT_EQ(range.widest(), 0);
  EXPECT_EQ(range.width(), std::numeric_limits<double>::infinity());
  EXPECT_LT(responseOf(run, "Y of ground").range.widest(), 0);
}

// Two blocks that touch on the ground beside each other: at the node on the edge, which is held on both sides, they may
// press on each other as they like, though they do not need to.
TEST(AnyScale, NamesPressureBetweenHeldNodesThatCarryNothing) {
  SceneInput scene = SceneInput::fromFile("glued_cross.xml");
  scene.add("Interfaces", xmlList("ab", xmlText("Part 1", "a") + xmlText("Part 2", "b") +
                                            xmlList("Law", xmlText("Type", "Unilateral Contact"))));
  scene.set("Boundaries/top/Law/X=0");
  const SolvedRun run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result().reason;
  const auto& range = responseOf(run, "X of ab").range;
  ASSERT_GE(range.widest(), 0);
  EXPECT_TRUE(std::isinf(range.width()));
}

}  // namespace
}  // namespace harmos::verification
