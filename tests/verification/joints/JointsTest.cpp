#include <gtest/gtest.h>

#include <cmath>

#include "../elements/Body.hpp"

namespace harmos::verification {
namespace {

constexpr double length = 10.0, tolerance = 1e-6;

/// A bar 10 x 1 x 1 along x of modulus 1, held at x = 0, without Poisson's effect, and what is done with its end.
SceneInput bar(const std::string& element, const std::string& kind,
               const std::vector<std::pair<std::string, double>>& values, const std::vector<double>& point = {}) {
  SceneInput scene = bodyOf({element, element == "Hex8" ? "Incompatible Modes" : "Full Integration", 3}, {10, 2, 2},
                            [](const base::Vector3& x) {
                              return base::Vector3{length * x[0], x[1] - 0.5, x[2] - 0.5};
                            });
  scene.set("Materials/elastic/Poisson's Ratio=0");
  std::string law = xmlText("Type", "Remote Displacement") + xmlText("Kind", kind);
  if (!point.empty()) law += xmlNumbers("Point", point);
  for (const auto& [name, value] : values) law += xmlNumber(name, value);
  scene.add("Boundaries",
            boundary("foot", "body_xmin", "Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}) +
                xmlList("end", xmlText("Side Set", "body_xmax") + xmlList("Law", law)));
  const auto moment = [](const std::string& name, const std::string& at) {
    return xmlList(name, xmlText("Type", "Interface Moment") + xmlText("Interface", at) +
                             xmlNumbers("Centre", {length, 0.0, 0.0}) + xmlNumbers("Axis", {0.0, 0.0, 1.0}));
  };
  return scene.add("Responses", forceResponse("along", "end", {1, 0, 0}) + forceResponse("across", "end", {0, 1, 0}) +
                                    moment("couple", "end"));
}

TEST(RemoteDisplacement, PullsAndTurnsABar) {
  for (const char* kind : {"Distributing", "Rigid"}) {
    const SolvedScene run(bar("Hex8", kind, {{"X", 2e-3}, {"Rotation Z", 1e-3}}));
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    EXPECT_NEAR(run.value("along"), 2e-3 / length, tolerance * 2e-4) << kind;
    EXPECT_NEAR(run.value("couple"), 1e-3 / 12.0 / length, 1e-5 * 1e-5) << kind;
    EXPECT_NEAR(run.value("across"), 0.0, tolerance * 1e-5) << kind;
  }
}

// Tension is exact, for constant tractions are. Tractions of bending are linear but for the dual basis, which disturbs
// the stress near the end.
TEST(RemoteDisplacement, PullsAndTurnsABarByQuadraticFaces) {
  for (const char* element : {"Tet10", "Hex20", "Hex27", "Wedge15"}) {
    const SolvedScene run(bar(element, "Distributing", {{"X", 2e-3}, {"Rotation Z", 1e-3}}));
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    EXPECT_NEAR(run.value("along"), 2e-3 / length, tolerance * 2e-4) << element;
    EXPECT_NEAR(run.value("couple"), 1e-3 / 12.0 / length, 3e-3 * 1e-3 / 12.0 / length) << element;
    EXPECT_NEAR(run.value("across"), 0.0, tolerance * 1e-5) << element;
  }
}

// Beyond the end: F (L^3 / 3 + a L^2 + a^2 L) / (E I) and the shear of Timoshenko.
TEST(RemoteDisplacement, BendsFromAfar) {
  constexpr double way = 1e-3, arm = 5.0;
  const SolvedScene run(bar("Hex8", "Distributing", {{"Y", way}}, {length + arm, 0.0, 0.0}));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double compliance =
      12.0 * (std::pow(length, 3) / 3.0 + arm * length * length + arm * arm * length) + length / (0.5 * 5.0 / 6.0);
  EXPECT_NEAR(run.value("across"), way / compliance, 5e-3 * way / compliance);
  EXPECT_NEAR(run.value("couple"), arm * run.value("across"), tolerance * arm * way / compliance);
}

TEST(RemoteDisplacement, HangsOnSprings) {
  for (const char* kind : {"Distributing", "Rigid"}) {
    const SolvedScene run(
        bar("Hex8", kind, {{"X", 2e-3}, {"X Stiffness", 0.3}, {"Rotation Z", 1e-3}, {"Rotation Z Stiffness", 0.02}}));
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    EXPECT_NEAR(run.value("along"), 2e-3 / (length + 1.0 / 0.3), 1e-5 * 2e-4) << kind;
    EXPECT_NEAR(run.value("couple"), 1e-3 / (12.0 * length + 1.0 / 0.02), 1e-5 * 1e-5) << kind;
  }
}

// A face that stays rigid is moved by a force in a point as by its resultant.
TEST(RemoteDisplacement, CarriesForces) {
  for (const char* kind : {"Distributing", "Rigid"}) {
    const SolvedScene run(bar("Hex20", kind, {{"Force X", 2e-3}, {"Moment Z", 1e-4}, {"Y", 0.0}}));
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    EXPECT_NEAR(run.value("along"), 2e-3, tolerance * 2e-3) << kind;
    EXPECT_NEAR(run.value("couple"), 1e-4, tolerance * 1e-4) << kind;
    // Propped at the end: 3 M / (2 L), and a little less by the shear.
    EXPECT_NEAR(run.value("across"), -1.5 * 1e-4 / length, 2e-2 * 1.5e-5) << kind;
  }
}

TEST(RanksRemoteDisplacement, IsOneOverAllPieces) {
  for (const char* kind : {"Distributing", "Rigid"}) {
    SceneInput scene = bar("Hex8", kind, {{"X", 2e-3}, {"Y", 0.0}, {"Rotation X", 2e-3}, {"Rotation Z", 1e-3}});
    const SolvedScene whole(scene);
    scene.set("Parts/body/Pieces=5");
    const SolvedScene pieces(scene);
    ASSERT_TRUE(whole.isCertified() && pieces.isCertified()) << pieces.result.reason;
    for (const char* name : {"along", "across", "couple"}) {
      EXPECT_NEAR(pieces.value(name), whole.value(name), 1e-5 * 2e-4) << kind << name;
    }
  }
}

// The diagram of a joint with one bolt, VDI 2230: F = F_M + Q kb / (kb + kp), and Q alone once the plates have parted.
TEST(RanksFaceSpring, FollowsTheDiagramOfABolt) {
  for (const int pieces : {1, 3}) {
    SceneInput scene = SceneInput::fromFile("joints/one_bolt.xml");
    scene.set("Parts/upper/Pieces=" + std::to_string(pieces));
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    const std::vector<double> bolt = {16800.0, 18800.0, 20800.0, 25000.0};
    const std::vector<double> clamped = {16800.0, 8800.0, 800.0, 0.0};
    for (int t = 0; t < 4; ++t) {
      const auto i = static_cast<std::size_t>(t);
      EXPECT_NEAR(run.value("bolt", t), bolt[i], 1e-5 * 16800.0) << t;
      EXPECT_NEAR(run.value("clamped", t), clamped[i], 1e-5 * 16800.0) << t;
    }
    EXPECT_NEAR(run.value("opening", 3), 4000.0 / 420000.0, 1e-5 * 0.01);
  }
}

// A cantilever whose halves a joint connects: its compliance adds to that of the beam, whatever that is.
TEST(FaceSpring, AddsItsCompliance) {
  const auto tip = [](const std::vector<std::pair<std::string, double>>& stiffness) {
    SceneInput scene = SceneInput::fromFile("joints/one_bolt.xml");
    scene.remove("Interfaces/joint").remove("Responses/clamped").remove("Responses/opening");
    std::string law =
        xmlText("Type", "Face Spring") + xmlNumbers("Point", {40.0, 50.0}) + xmlNumbers("Axis", {0.0, 1.0});
    for (const auto& [name, value] : stiffness) law += xmlNumber(name, value);
    scene.set("Interfaces/bolt/Side 1=lower_ymax").set("Interfaces/bolt/Side 2=upper_ymin");
    scene.remove("Interfaces/bolt/Law").add("Interfaces/bolt", xmlList("Law", law));
    scene.remove("Boundaries/pull");
    scene.add("Boundaries", boundary("pull", "upper_ymax", "Prescribed Traction", {{"X", 1.25}}));
    scene.add("Responses", meanDisplacement("tip", "upper_ymax", {1, 0}));
    const SolvedScene run(scene);
    EXPECT_TRUE(run.isCertified()) << run.result.reason;
    return run.value("tip");
  };
  constexpr double force = 1.25 * 800.0, arm = 50.0;
  const double rigid = tip({});
  const double sheared = tip({{"Shear Stiffness", 2e5}}), bent = tip({{"Bending Stiffness", 4e8}});
  EXPECT_NEAR(sheared - rigid, force / 2e5, 1e-5 * sheared);
  EXPECT_NEAR(bent - rigid, force * arm * arm / 4e8, 1e-5 * bent);
}

}  // namespace
}  // namespace harmos::verification
