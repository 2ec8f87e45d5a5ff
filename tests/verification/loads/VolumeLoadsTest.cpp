#include <gtest/gtest.h>

#include <cmath>

#include "../elements/Body.hpp"

namespace harmos::verification {
namespace {

// Ten times the accuracy that the scene asks for.
constexpr double tolerance = 1e-6;
constexpr double rho = 2.0, length = 4.0, side = 0.5;

base::Vector3 asBar(const base::Vector3& x) {
  return {length * x[0], side * x[1], side * x[2]};
}

/// A bar along x without Poisson's effect, held at x = 0.
SceneInput bar(const std::string& element = "Hex8") {
  SceneInput scene = bodyOf({element, "Full Integration", 3}, {4, 1, 1}, asBar);
  scene.set("Materials/elastic/Poisson's Ratio=0").add("Materials/elastic", xmlNumber("Density", rho));
  scene.add("Boundaries",
            boundary("foot", "body_xmin", "Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}));
  for (const auto& [name, direction] :
       std::vector<std::pair<std::string, std::vector<double>>>{{"x", {1, 0, 0}}, {"y", {0, 1, 0}}, {"z", {0, 0, 1}}}) {
    scene.add("Responses", forceResponse("reaction " + name, "foot", direction) +
                               meanDisplacement("end " + name, "body_xmax", direction));
  }
  return scene;
}

double modulus(const SceneInput& scene) {
  return scene.scene().input.lists("Materials")[0].number("Young's Modulus");
}

std::string load(const std::string& type, const std::string& entries) {
  return xmlList("load", xmlText("Type", type) + entries);
}

TEST(VolumeLoads, BarsHangInTheirWeight) {
  for (const char* element : {"Hex8", "Hex20", "Tet10", "Wedge6"}) {
    SceneInput scene = bar(element);
    scene.add("Loads", load("Gravity", xmlNumber("X", 9.0)));
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    const double weight = rho * 9.0 * length * side * side, end = rho * 9.0 * length * length / (2.0 * modulus(scene));
    EXPECT_NEAR(run.value("reaction x"), -weight, tolerance * weight) << element;
    EXPECT_NEAR(run.value("end x"), end, (element[0] == 'W' ? 1e-2 : tolerance) * end) << element;
  }
}

TEST(VolumeLoads, AcceleratedSupportsPullTheOtherWay) {
  SceneInput scene = bar();
  scene.remove("Steps/load")
      .add("Steps",
           xmlList("shake", xmlNumber("Duration", 1.0) + "<Parameter name=\"Increments\" type=\"int\" value=\"2\"/>"));
  scene.add("Histories", xmlList("wave", xmlText("Type", "Table") + xmlNumbers("Times", {0.0, 0.5, 1.0}) +
                                             xmlNumbers("Values", {0.0, 1.0, -0.5})));
  scene.add("Loads", load("Acceleration", xmlNumber("X", 9.0) + xmlText("X History", "wave")));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double weight = rho * 9.0 * length * side * side;
  const int last = run.steps() - 1;
  EXPECT_NEAR(run.value("reaction x", last - 1), weight, tolerance * weight);
  EXPECT_NEAR(run.value("reaction x", last), -0.5 * weight, tolerance * weight);
}

TEST(VolumeLoads, TurningBarsStretch) {
  constexpr double omega = 3.0, rate = 5.0;
  SceneInput scene = bar("Hex20");
  const double y = 0.5 * side;
  scene.add("Loads", load("Rotation", xmlNumber("Angular Velocity", omega) + xmlNumber("Angular Acceleration", rate) +
                                          xmlNumbers("Point", {0.0, y, y}) + xmlNumbers("Axis", {0.0, 0.0, 2.0})));
  scene.add("Responses", xmlList("moment", xmlText("Type", "Interface Moment") + xmlText("Interface", "foot") +
                                               xmlNumbers("Centre", {0.0, y, y}) + xmlNumbers("Axis", {0, 0, 1})));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double mass = rho * length * side * side;
  const double pull = mass * omega * omega * 0.5 * length, push = mass * rate * 0.5 * length;
  // Of a bar whose cross-section does not deform: omega^2 rho L^3 / (3 E).
  const double end = rho * omega * omega * std::pow(length, 3) / (3.0 * modulus(scene));
  EXPECT_NEAR(run.value("reaction x"), -pull, tolerance * pull);
  EXPECT_NEAR(run.value("end x"), end, 1e-3 * end);
  // The force against the growing speed acts along -y, and about the axis by rho e int r^2 dV.
  EXPECT_NEAR(run.value("reaction y"), push, tolerance * push);
  EXPECT_NEAR(run.value("moment"), mass * rate * (length * length / 3.0 + side * side / 12.0),
              tolerance * mass * rate * 16.0);
}

// A thin disc with a hole, free at both edges: sigma_r and sigma_theta of plane stress.
TEST(VolumeLoads, TurningDiscsGrow) {
  constexpr double inner = 1.0, outer = 3.0, omega = 2.0, nu = 0.3;
  SceneInput scene = bodyOf({"Quad8", "Full Integration", 2}, {8, 1}, [](const base::Vector3& x) {
    return base::Vector3{inner + (outer - inner) * x[0], 1e-2 * x[1], 0.0};
  });
  scene.add("Model", xmlText("Kinematics", "Axisymmetric")).set(assignment("Materials/elastic/Poisson's Ratio", nu));
  scene.add("Materials/elastic", xmlNumber("Density", rho));
  scene.add("Boundaries", boundary("bottom", "body_ymin", "Symmetry"));
  scene.add("Loads", load("Rotation", xmlNumber("Angular Velocity", omega)));
  scene.add("Responses",
            meanDisplacement("inside", "body_xmin", {1, 0}) + meanDisplacement("outside", "body_xmax", {1, 0}));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double e = modulus(scene), a2 = inner * inner, b2 = outer * outer, c = rho * omega * omega / 8.0;
  const auto u = [&](double r) {
    const double sum = (3.0 + nu) * (a2 + b2), r2 = r * r;
    const double radial = c * (sum - (3.0 + nu) * (a2 * b2 / r2 + r2));
    const double hoop = c * (sum + (3.0 + nu) * a2 * b2 / r2 - (1.0 + 3.0 * nu) * r2);
    return r * (hoop - nu * radial) / e;
  };
  EXPECT_NEAR(run.value("inside"), u(inner), 1e-4 * u(inner));
  EXPECT_NEAR(run.value("outside"), u(outer), 1e-4 * u(outer));
}

// The same on every number of ranks, of a part in pieces.
TEST(RanksVolumeLoads, WeightOfPieces) {
  SceneInput scene = bar();
  scene.set("Parts/body/Pieces=3");
  scene.add("Loads", load("Gravity", xmlNumber("X", 9.0)));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double end = rho * 9.0 * length * length / (2.0 * modulus(scene));
  EXPECT_NEAR(run.value("end x"), end, tolerance * end);
}

}  // namespace
}  // namespace harmos::verification
