#include <gtest/gtest.h>

#include <cmath>

#include <harmos/base/Error.hpp>

#include "../elements/Body.hpp"

namespace harmos::verification {
namespace {

constexpr double young = 1.0, poisson = 0.3;                 // of elements/body.xml
const double effective = young / (1.0 - poisson * poisson);  // E* beside a rigid body

std::string tool(const std::string& name, const std::string& sideSet, const std::string& law,
                 const std::string& entries) {
  return xmlList(name, xmlText("Side Set", sideSet) + xmlList("Law", xmlText("Type", law) + entries));
}

double largest(const std::vector<PairValue>& pairs) {
  double pressure = 0.0;
  for (const PairValue& pair : pairs) pressure = std::max(pressure, -pair.traction[0]);
  return pressure;
}

/// A square whose upper left corner lies in the origin, with cells of a hundredth of its size there.
base::Vector3 fineAtTheOrigin(const base::Vector3& x) {
  const auto graded = [](double s) { return s * (0.12 + 0.88 * s * s * s); };
  return {graded(x[0]), -graded(1.0 - x[1]), 0.0};
}

/// Pressed into the upper side: half of a rigid cylinder in plane strain, or a rigid sphere in axisymmetry.
SceneInput indented(const std::string& law, const std::string& entries, double depth) {
  SceneInput scene = bodyOf({"Quad4", "Full Integration", 2}, {32, 32}, fineAtTheOrigin);
  scene.add("Boundaries", boundary("foot", "body_ymin", "Prescribed Displacement", {{"Y", 0.0}}) +
                              boundary("middle", "body_xmin", "Prescribed Displacement", {{"X", 0.0}}) +
                              tool("tool", "body_ymax", law, entries + xmlNumber("Y", -depth)));
  scene.add("Responses", forceResponse("force", "tool", {0.0, -1.0}));
  return scene;
}

// Hertz: p0 = sqrt(P E* / (pi R)), P on both halves.
TEST(RigidCylinder, PressesAsHertzSays) {
  constexpr double radius = 1.0;
  const SceneInput scene =
      indented("Rigid Cylinder", xmlNumbers("Point", {0.0, radius}) + xmlNumber("Radius", radius), 4e-3);
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double expected = std::sqrt(2.0 * run.value("force") * effective / (M_PI * radius));
  EXPECT_NEAR(largest(run.pairs("tool")), expected, 0.03 * expected);
}

// Hertz: p0^3 = 6 P E*^2 / (pi^3 R^2).
TEST(RigidSphere, PressesAsHertzSays) {
  constexpr double radius = 1.0;
  SceneInput scene = indented("Rigid Sphere", xmlNumbers("Centre", {0.0, radius}) + xmlNumber("Radius", radius), 4e-3);
  scene.add("Model", xmlText("Kinematics", "Axisymmetric"));
  scene.remove("Boundaries/middle");
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double expected =
      std::cbrt(6.0 * run.value("force") * effective * effective / (std::pow(M_PI, 3) * radius * radius));
  EXPECT_NEAR(largest(run.pairs("tool")), expected, 0.04 * expected);
}

// A ring shrunk into a bush, Lame: u = A r + B / r, no stress at the bore, u = -i at the rim.
TEST(RigidCylinder, HoldsARingInside) {
  constexpr double inner = 1.0, outer = 2.0, interference = 1e-3;
  SceneInput scene = bodyOf({"Quad4", "Full Integration", 2}, {24, 36}, [](const base::Vector3& x) {
    const double radius = inner + (outer - inner) * x[0], angle = 0.5 * M_PI * x[1];
    return radius * base::Vector3{std::cos(angle), std::sin(angle), 0.0};
  });
  const std::string bush = xmlNumbers("Point", {0.0, 0.0}) + xmlNumber("Radius", outer - interference) +
                           xmlNumber("Interference", 1.01 * interference) +
                           R"(<Parameter name="Part Inside" type="bool" value="true"/>)";
  scene.add("Boundaries", boundary("ends", "body_ymin", "Symmetry") + boundary("other", "body_ymax", "Symmetry") +
                              tool("bush", "body_xmax", "Rigid Cylinder", bush));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double ratio = inner * inner / (1.0 - 2.0 * poisson);  // B / A
  const double a = -interference / (outer + ratio / outer);
  const double pressure = -young / (1.0 + poisson) * (a / (1.0 - 2.0 * poisson) - ratio * a / (outer * outer));
  double area = 0.0, force = 0.0;
  for (const PairValue& pair : run.pairs("bush")) {
    area += pair.area;
    force -= pair.area * pair.traction[0];
    EXPECT_EQ(pair.status, laws::Status::slip);
  }
  EXPECT_NEAR(force / area, pressure, 3e-3 * pressure);
}

// The same, of quadratic elements whose nodes lie on the circles: what fits the tool touches it everywhere.
TEST(RigidCylinder, FitsCurvedFaces) {
  constexpr double inner = 1.0, outer = 2.0, interference = 1e-3;
  for (const std::string element : {"Quad8", "Quad9", "Tri6"}) {
    SceneInput scene = bodyOf({element, "Full Integration", 2}, {4, 6}, [](const base::Vector3& x) {
      const double radius = inner + (outer - inner) * x[0], angle = 0.5 * M_PI * x[1];
      return radius * base::Vector3{std::cos(angle), std::sin(angle), 0.0};
    });
    const std::string bush = xmlNumbers("Point", {0.0, 0.0}) + xmlNumber("Radius", outer - interference) +
                             xmlNumber("Interference", 1.01 * interference) +
                             R"(<Parameter name="Part Inside" type="bool" value="true"/>)";
    scene.add("Boundaries", boundary("ends", "body_ymin", "Symmetry") + boundary("other", "body_ymax", "Symmetry") +
                                tool("bush", "body_xmax", "Rigid Cylinder", bush));
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << element << ": " << run.result.reason;
    const double ratio = inner * inner / (1.0 - 2.0 * poisson);  // B / A
    const double a = -interference / (outer + ratio / outer);
    const double pressure = -young / (1.0 + poisson) * (a / (1.0 - 2.0 * poisson) - ratio * a / (outer * outer));
    double least = 1e300, most = 0.0;
    for (const PairValue& pair : run.pairs("bush")) {
      least = std::min(least, -pair.traction[0]);
      most = std::max(most, -pair.traction[0]);
    }
    EXPECT_NEAR(least, pressure, 0.02 * pressure) << element;
    EXPECT_NEAR(most, pressure, 0.02 * pressure) << element;
  }
}

// On quadratic faces, a quarter of the cells in each direction.
TEST(RigidTools, PressQuadraticFacesAsHertzSays) {
  constexpr double radius = 1.0;
  const std::string round = xmlNumber("Radius", radius);
  for (const bool isSphere : {false, true}) {
    SceneInput scene = indented(isSphere ? "Rigid Sphere" : "Rigid Cylinder",
                                xmlNumbers(isSphere ? "Centre" : "Point", {0.0, radius}) + round, 4e-3);
    scene.set("Mesh/Order=2");
    if (isSphere) {
      scene.add("Model", xmlText("Kinematics", "Axisymmetric"));
      scene.remove("Boundaries/middle");
    }
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    const double force = run.value("force");
    const double expected = isSphere
                                ? std::cbrt(6.0 * force * effective * effective / (std::pow(M_PI, 3) * radius * radius))
                                : std::sqrt(2.0 * force * effective / (M_PI * radius));
    EXPECT_NEAR(largest(run.pairs("tool")), expected, 0.03 * expected) << isSphere;
  }
}

// A ball on a block in space: P = 4/3 E* R^(1/2) d^(3/2) for all kinds of quadratic faces, and the sum is what holds
// it.
TEST(RigidSphere, PressesAllQuadraticFacesAlike) {
  constexpr double radius = 4.0, depth = 0.02;
  std::vector<double> forces;
  for (const std::string element : {"Hex8", "Hex20", "Hex27", "Tet10", "Wedge15"}) {
    const int cells = element == "Hex8" ? 16 : 8;
    SceneInput scene = bodyOf({element}, {cells, cells, 4}, [](const base::Vector3& x) {
      return base::Vector3{2.0 * x[0] * (0.4 + 0.6 * x[0]), 2.0 * x[1] * (0.4 + 0.6 * x[1]),
                           1.0 - (1.0 - x[2]) * (0.4 + 0.6 * (1.0 - x[2]))};
    });
    scene.set("Solver/Accuracy=1e-4");
    scene.add("Boundaries",
              boundary("foot", "body_zmin", "Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}) +
                  boundary("west", "body_xmin", "Symmetry") + boundary("south", "body_ymin", "Symmetry") +
                  tool("tool", "body_zmax", "Rigid Sphere",
                       xmlNumbers("Centre", {0.0, 0.0, 1.0 + radius}) + xmlNumber("Radius", radius) +
                           xmlNumber("Z", -depth)));
    scene.add("Responses",
              forceResponse("down", "tool", {0.0, 0.0, -1.0}) + forceResponse("foot", "foot", {0.0, 0.0, 1.0}));
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << element << ": " << run.result.reason;
    EXPECT_NEAR(run.value("down"), run.value("foot"), 1e-3 * run.value("down")) << element;
    forces.push_back(run.value("down"));
  }
  for (const double force : forces) EXPECT_NEAR(force, forces[2], 0.03 * forces[2]);
}

/// A block on the ground under a rigid plane, which comes down by 0.02 from 0.01 above it, and then slides.
SceneInput pressedBlock(const std::string& plane) {
  SceneInput scene = bodyOf({"Hex8"}, {3, 2, 2}, [](const base::Vector3& x) { return x; });
  scene.set("Materials/elastic/Poisson's Ratio=0");
  scene.add("Boundaries",
            boundary("foot", "body_zmin", "Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}) +
                tool("tool", "body_zmax", "Rigid Plane", plane));
  scene.add("Responses", forceResponse("down", "tool", {0.0, 0.0, -1.0}) +
                             forceResponse("along", "tool", {1.0, 0.0, 0.0}) +
                             xmlList("lost", xmlText("Type", "Dissipation")));
  return scene;
}

const std::string plane = xmlNumbers("Point", {5.0, 0.0, 1.01}) + xmlNumbers("Normal", {0.0, 0.0, -2.0}) +
                          xmlNumber("Friction Coefficient", 0.3) + xmlNumber("Z", -0.02);

TEST(RigidPlane, PressesAndDrags) {
  SceneInput scene =
      pressedBlock(plane + xmlNumber("X", 2.0) + xmlText("X History", "late") + xmlText("Z History", "early"));
  const auto table = [](const std::string& name, const std::vector<double>& values) {
    return xmlList(name,
                   xmlText("Type", "Table") + xmlNumbers("Times", {0.0, 1.0, 3.0}) + xmlNumbers("Values", values));
  };
  scene.add("Histories", table("early", {0.0, 1.0, 1.0}) + table("late", {0.0, 0.0, 1.0}));
  const std::string increments = R"(<Parameter name="Increments" type="int" value="4"/>)";
  scene.remove("Steps/load");
  scene.add("Steps", xmlList("down", "") + xmlList("along", xmlNumber("Duration", 2.0) + increments));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double force = young * 0.01;
  EXPECT_NEAR(run.value("down", 0), force, 1e-3 * force);
  EXPECT_NEAR(run.value("along", 0), 0.0, 1e-3 * force);
  EXPECT_NEAR(run.value("along"), 0.3 * force, 1e-3 * force);
  // The block follows by its shear and bending, less than its own length; what the plane slides beyond is lost.
  EXPECT_NEAR(run.value("lost", 4) - run.value("lost", 3), 0.3 * force * 0.5, 1e-3 * force);
}

TEST(RanksRigidPlane, IsWhereHistoriesPutIt) {
  const SolvedScene run(pressedBlock(plane));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_NEAR(run.value("down"), young * 0.01, 1e-5);
}

void expectRefused(const SceneInput& scene, const std::string& text) {
  try {
    const SolvedScene run(scene);
    ADD_FAILURE() << "accepted: " << text;
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(RigidTools, AreRefusedWhereTheyCannotAct) {
  const auto block = [](double height, const std::vector<double>& normal) {
    return pressedBlock(xmlNumbers("Point", {0.0, 0.0, height}) + xmlNumbers("Normal", normal));
  };
  expectRefused(block(0.9, {0.0, 0.0, -1.0}), "lies 0.1 deep in the tool at the start");
  expectRefused(block(1.01, {0.0, 0.0, 1.0}), "whose faces look away from it");
  expectRefused(block(9.0, {0.0, 0.0, -1.0}), "comes no nearer to the nodes than 8");
  expectRefused(block(-0.5, {0.0, 0.0, 1.0}), "whose faces look away from it");
  const std::string centre = xmlNumbers("Centre", {0.0, 1.0}) + xmlNumber("Radius", 1.0);
  expectRefused(indented("Rigid Sphere", centre, 1e-3), "a sphere is none in the plane");
  const std::string axis = xmlNumbers("Point", {0.0, 1.0}) + xmlNumber("Radius", 1.0) + xmlNumbers("Axis", {0.0, 1.0});
  expectRefused(indented("Rigid Cylinder", axis, 1e-3), "in the plane the axis is z");
  const std::string tilted = xmlNumbers("Point", {0.0, 0.0}) + xmlNumbers("Normal", {1.0, 1.0});
  SceneInput revolved = indented("Rigid Plane", tilted, 1e-3);
  revolved.add("Model", xmlText("Kinematics", "Axisymmetric"));
  expectRefused(revolved, "is none of revolution");
}

}  // namespace
}  // namespace harmos::verification
