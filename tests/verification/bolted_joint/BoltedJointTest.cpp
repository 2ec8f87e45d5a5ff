#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

const std::array<const char*, 6> contacts = {"plates_bottom", "plates_top",   "head_1_cover",
                                             "nut_1_cover",   "head_2_cover", "nut_2_cover"};

/// The solution of the monolithic discrete problem by a semi-smooth Newton method, residual below 1e-11.
struct Row {
  double displacement, bolt1, bolt2;
  std::array<int, 3> counts;  // open, stick, slip
};
const std::array<Row, 11> table = {{{0.0014053503, 1681.012, 839.950, {102, 382, 654}},
                                    {0.0031900251, 1678.258, 836.346, {102, 674, 362}},
                                    {0.0050354855, 1675.414, 832.772, {108, 622, 408}},
                                    {0.0069351402, 1672.447, 829.297, {112, 570, 456}},
                                    {0.0088916091, 1669.374, 825.891, {120, 484, 534}},
                                    {0.0110493934, 1666.039, 822.933, {126, 408, 604}},
                                    {0.0134164707, 1662.403, 820.450, {126, 448, 564}},
                                    {0.0158684533, 1658.583, 818.173, {130, 422, 586}},
                                    {0.0184031784, 1654.564, 816.013, {134, 392, 612}},
                                    {0.0210972001, 1649.773, 813.911, {146, 336, 656}},
                                    {0.0241412940, 1643.893, 811.796, {150, 298, 690}}}};

SceneInput boltedJoint(const std::string& accuracy) {
  SceneInput scene = SceneInput::fromFile("../../xml/bolted_joint.xml");
  return scene.set("Solver/Accuracy=" + accuracy);
}

std::array<int, 3> countsOf(const SolvedScene& run, int step) {
  std::array<int, 3> counts{};
  for (const char* contact : contacts) {
    for (const PairValue& pair : run.pairs(contact, step)) ++counts.at(static_cast<std::size_t>(pair.status));
  }
  return counts;
}

/// Relative to the largest value of the table's column, as accuracy is meant; `digits`: half of the table's last digit.
void expectTable(const SolvedScene& run, double tolerance) {
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  for (int t = 0; t < 11; ++t) {
    const Row& row = table.at(static_cast<std::size_t>(t));
    EXPECT_NEAR(run.value("u_load", t), row.displacement, tolerance * row.displacement) << "step " << t + 1;
    EXPECT_NEAR(run.value("bolt_force_1", t), row.bolt1, tolerance * row.bolt1) << "step " << t + 1;
    EXPECT_NEAR(run.value("bolt_force_2", t), row.bolt2, tolerance * row.bolt2) << "step " << t + 1;
    EXPECT_NEAR(run.value("reaction", t), 140.0 * t, 1400.0 * tolerance) << "step " << t + 1;
  }
}

TEST(BoltedJoint, ReferenceTableAtThousandth) {
  expectTable(SolvedScene(boltedJoint("1e-3")), 1e-3);
}

TEST(BoltedJoint, ReferenceTableAtHundredThousandth) {
  SceneInput scene = boltedJoint("1e-5");
  const SolvedScene run(scene.add("Responses", forceResponse("bottom", "plates_bottom", {0.0, 0.0, -1.0}) +
                                                   forceResponse("top", "plates_top", {0.0, 0.0, -1.0})));
  expectTable(run, 1e-5);
  for (const char* plates : {"bottom", "top"}) {
    EXPECT_NEAR(run.value(plates, 0), 2530.045, 1e-5 * 2530.045) << plates;
    EXPECT_NEAR(run.value(plates, 10), 2462.081, 1e-5 * 2462.081) << plates;
  }
}

TEST(BoltedJoint, ContactStatus) {
  const SolvedScene run(boltedJoint("1e-6"));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  for (int t = 0; t < 11; ++t) EXPECT_EQ(countsOf(run, t), table.at(static_cast<std::size_t>(t)).counts) << t + 1;
}

TEST(BoltedJoint, ConsistentInterfaceMass) {
  SceneInput scene = boltedJoint("1e-5");
  const SolvedScene run(scene.set("Solver/Interface Mass=Consistent"));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_LE(run.result.linearStages, 80);  // 60; 104 with the search direction of a lumped mass
  // The accuracy, or half of the last digit that is known.
  EXPECT_NEAR(run.value("u_load", 0), 0.00140508, 1e-5 * 0.00140508);
  EXPECT_NEAR(run.value("u_load", 10), 0.02418607, 1e-5 * 0.02418607);
  EXPECT_NEAR(run.value("bolt_force_1", 0), 1680.125, 1e-5 * 1680.125);
  EXPECT_NEAR(run.value("bolt_force_2", 0), 839.400, 1e-5 * 839.4);
}

/// Displacement-driven, same method.
struct Driven {
  const char* name;
  double mu, preload1, preload2;
  std::array<double, 7> reaction;
  double lastReaction, largestReaction, tableDigit;
  std::array<double, 2> bolt1, bolt2;  // first and last step
  std::array<int, 3> counts;
};

class DrivenBoltedJoint : public ::testing::TestWithParam<Driven> {};
class LongDrivenBoltedJoint : public ::testing::TestWithParam<Driven> {};

SceneInput driven(const Driven& data, const std::string& accuracy) {
  SceneInput scene = boltedJoint(accuracy);
  scene.set("Boundaries/loaded/Law/Type=Prescribed Displacement").set("Boundaries/loaded/Law/X=0.5");
  scene.set(assignment("Values/mu", data.mu)).set(assignment("Values/preload_1", data.preload1));
  return scene.set(assignment("Values/preload_2", data.preload2));
}

void expectDriven(const SolvedScene& run, const Driven& data, double tolerance) {
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const auto& reaction = run.values("reaction");
  const double size = tolerance * data.largestReaction;
  for (std::size_t t = 0; t < 7; ++t) EXPECT_NEAR(reaction[t], data.reaction[t], size + data.tableDigit) << t + 1;
  EXPECT_NEAR(reaction[10], data.lastReaction, size);
  EXPECT_NEAR(*std::max_element(reaction.begin(), reaction.end()), data.largestReaction, size);
  EXPECT_NEAR(run.value("bolt_force_1", 0), data.bolt1[0], tolerance * data.bolt1[0] + 5e-4);
  EXPECT_NEAR(run.value("bolt_force_1", 10), data.bolt1[1], tolerance * data.bolt1[0] + 5e-4);
  EXPECT_NEAR(run.value("bolt_force_2", 0), data.bolt2[0], tolerance * data.bolt2[0] + 5e-4);
  EXPECT_NEAR(run.value("bolt_force_2", 10), data.bolt2[1], tolerance * data.bolt2[0] + 5e-4);
}

TEST_P(DrivenBoltedJoint, ReferenceAtThousandth) {
  expectDriven(SolvedScene(driven(GetParam(), "1e-3")), GetParam(), 1e-3);
}

TEST_P(LongDrivenBoltedJoint, ReferenceAtMillionth) {
  expectDriven(SolvedScene(driven(GetParam(), "1e-6")), GetParam(), 1e-6);
}

// On the plateau nodes come to rest on the cone; at 1e-6 of the largest tractions those of light pressure are not there
// yet.
TEST_P(LongDrivenBoltedJoint, ContactStatus) {
  const SolvedScene run(driven(GetParam(), "1e-8"));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_EQ(countsOf(run, 10), GetParam().counts);
}

const std::array<Driven, 3> drivenCases = {{{"First",
                                             0.25,
                                             0.1,
                                             0.1,
                                             {-280.240, 3047.42, 3259.04, 3259.21, 3259.18, 3259.18, 3259.18},
                                             3259.180351,
                                             3259.2102,
                                             5e-3,
                                             {3344.777, 3245.097},
                                             {3343.149, 3256.508},
                                             {172, 356, 610}},
                                            {"Second",
                                             0.25,
                                             0.125,
                                             0.1,
                                             {-310.274, 3080.98, 3667.83, 3668.95, 3668.89, 3668.89, 3668.89},
                                             3668.888903,
                                             3668.9484,
                                             5e-3,
                                             {4180.549, 4066.301},
                                             {3343.615, 3251.026},
                                             {176, 356, 606}},
                                            {"Third",
                                             0.30,
                                             0.15,
                                             0.125,
                                             {-408.072, 3284.10, 5359.07, 5388.74, 5388.60, 5388.54, 5388.54},
                                             5388.537798,
                                             5388.7439,
                                             5e-3,
                                             {5047.627, 4887.258},
                                             {4206.832, 4074.142},
                                             {154, 356, 628}}}};

INSTANTIATE_TEST_SUITE_P(Sets, DrivenBoltedJoint, ::testing::ValuesIn(drivenCases),
                         [](const auto& test) { return test.param.name; });
INSTANTIATE_TEST_SUITE_P(Sets, LongDrivenBoltedJoint, ::testing::ValuesIn(drivenCases),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace harmos::verification
