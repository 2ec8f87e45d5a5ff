#include <gtest/gtest.h>

#include <cmath>

#include <harmos/base/Error.hpp>

#include "Body.hpp"

namespace harmos::verification {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double inner = 1.0, outer = 2.0, pressure = 0.01, nu = 0.3;

const std::vector<Elements> planeElements = {{"Quad4", "Full Integration", 2},
                                             {"Quad8", "Full Integration", 2},
                                             {"Quad9", "Full Integration", 2},
                                             {"Tri6", "Full Integration", 2},
                                             {"Quad4", "B-Bar", 2}};

SceneInput revolved(const Elements& elements, const std::vector<int>& cells,
                    const std::function<base::Vector3(const base::Vector3&)>& place) {
  SceneInput scene = bodyOf(elements, cells, place);
  return scene.add("Model", xmlText("Kinematics", "Axisymmetric"))
      .set(assignment("Materials/elastic/Poisson's Ratio", nu));
}

// Lame: a tube between two frictionless plates. All forces are those of the whole circle.
TEST(Axisymmetry, TubeUnderPressureIsInClosedForm) {
  for (const Elements& elements : planeElements) {
    SceneInput scene = revolved(elements, {8, 2}, [](const base::Vector3& x) {
      return base::Vector3{inner + (outer - inner) * x[0], x[1], 0.0};
    });
    scene.add("Boundaries", boundary("inside", "body_xmin", "Pressure", {{"Pressure", pressure}}) +
                                boundary("top", "body_ymax", "Symmetry") + boundary("bottom", "body_ymin", "Symmetry"));
    scene.add("Responses", meanDisplacement("u", "body_xmin", {1.0, 0.0}) +
                               forceResponse("top force", "top", {0.0, 1.0}) +
                               forceResponse("push", "inside", {1.0, 0.0}));
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    // The hoops hold what the plates do not: both are boundaries without unknowns.
    EXPECT_LE(run.result.iterations, 3) << elements.name();
    const double u = (1.0 + nu) * pressure * inner / (outer * outer - inner * inner) *
                     ((1.0 - 2.0 * nu) * inner * inner + outer * outer);
    const bool isQuadratic = elements.element != "Quad4";
    EXPECT_NEAR(run.value("u"), u, (isQuadratic ? 1e-5 : 5e-3) * u) << elements.name();
    // The axial stress is 2 nu p a^2 / (b^2 - a^2) everywhere, in tension.
    EXPECT_NEAR(run.value("top force"), 2.0 * nu * pressure * inner * inner * pi, 1e-3 * 0.02) << elements.name();
    EXPECT_NEAR(run.value("push"), 2.0 * pi * inner * 1.0 * pressure, 1e-12) << elements.name();
  }
}

// Held at one node only, against moving along the axis: the hoops resist what moves or turns a plane body as rigid.
TEST(Axisymmetry, TubeStandsOnOneNode) {
  SceneInput scene = revolved({"Quad8", "Full Integration", 2}, {8, 2}, [](const base::Vector3& x) {
    return base::Vector3{inner + (outer - inner) * x[0], x[1], 0.0};
  });
  scene.changeMesh([](mesh::Mesh& mesh) {
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      const bool isCorner = base::distance(mesh.nodes[n], {inner, 1.0, 0.0}) < 1e-9;
      if (isCorner) mesh.nodeSets.push_back({"corner", 1, {static_cast<int>(n)}});
    }
  });
  scene.add("Boundaries",
            boundary("inside", "body_xmin", "Pressure", {{"Pressure", pressure}}) +
                xmlList("pin", xmlText("Node Set", "corner") +
                                   xmlList("Law", xmlText("Type", "Prescribed Displacement") + xmlNumber("Y", 0.0))));
  scene.add("Responses", meanDisplacement("u", "body_xmin", {1.0, 0.0}));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double u =
      pressure * inner / (outer * outer - inner * inner) * ((1.0 - nu) * inner * inner + (1.0 + nu) * outer * outer);
  EXPECT_NEAR(run.value("u"), u, 1e-5 * u);
}

// A hemisphere with nodes on the axis.
TEST(Axisymmetry, SphereUnderPressureIsInClosedForm) {
  for (const Elements& elements : planeElements) {
    SceneInput scene = revolved(elements, {8, 12}, [](const base::Vector3& x) {
      const double r = inner + (outer - inner) * x[0], angle = 0.5 * pi * x[1];
      return base::Vector3{x[1] == 1.0 ? 0.0 : r * std::cos(angle), r * std::sin(angle), 0.0};
    });
    scene.add("Boundaries", boundary("inside", "body_xmin", "Pressure", {{"Pressure", pressure}}) +
                                boundary("equator", "body_ymin", "Symmetry"));
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    const double a = inner * inner * inner, b = outer * outer * outer;
    const double exact = pressure * inner / (b - a) * ((1.0 - 2.0 * nu) * a + 0.5 * (1.0 + nu) * b);
    const mesh::Mesh mesh = scene.mesh();
    double largest = 0.0;
    for (const NodeValue& node : run.displacements()) {
      const base::Vector3& x = mesh.nodes[node.meshNode];
      if (x[0] == 0.0) {
        EXPECT_EQ(node.displacement[0], 0.0);
      }
      if (std::abs(base::norm(x) - inner) > 1e-9) continue;
      largest = std::max(largest, std::abs(dot(node.displacement, x) / inner / exact - 1.0));
    }
    EXPECT_LT(largest, elements.element == "Quad4" ? 0.02 : 1e-3) << elements.name();
  }
}

/// A shaft of radius 1 and length 2 that is pulled by `pressure` along the axis, its foot on a frictionless plate.
SceneInput pulledShaft(const Elements& elements) {
  SceneInput scene = revolved(elements, {3, 4}, [](const base::Vector3& x) {
    return base::Vector3{x[0], 2.0 * x[1], 0.0};
  });
  return scene.add("Boundaries", boundary("end", "body_ymax", "Pressure", {{"Pressure", -pressure}}));
}

void expectPulled(SceneInput scene, const std::string& what) {
  scene.add("Responses",
            meanDisplacement("u", "body_ymax", {0.0, 1.0}) + meanDisplacement("r", "body_xmax", {1.0, 0.0}));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << what << ": " << run.result.reason;
  EXPECT_NEAR(run.value("u"), 2.0 * pressure, 1e-9 * pressure) << what;
  EXPECT_NEAR(run.value("r"), -nu * pressure, 1e-9 * pressure) << what;
}

/// Adds the node set "axis" of the nodes with x = 0 and y <= `up`.
void nameNodesOnAxis(SceneInput& scene, double up) {
  scene.changeMesh([up](mesh::Mesh& mesh) {
    mesh.nodeSets.push_back({"axis", 1, {}});
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      if (mesh.nodes[n][0] == 0.0 && mesh.nodes[n][1] <= up) mesh.nodeSets.back().node.push_back(static_cast<int>(n));
    }
  });
}

// Faces on the axis have no area: what says there what is so anyway is left out.
TEST(Axisymmetry, BoundaryOnTheAxisChangesNothing) {
  const std::string foot = boundary("foot", "body_ymin", "Symmetry");
  for (const Elements& elements : planeElements) {
    for (const std::string& axis :
         {boundary("axis", "body_xmin", "Symmetry"),
          boundary("axis", "body_xmin", "Prescribed Displacement", {{"X", 0.0}}),
          boundary("axis", "body_xmin", "Pressure", {{"Pressure", 3.0}}),
          xmlList("axis", xmlText("Node Set", "axis") +
                              xmlList("Law", xmlText("Type", "Prescribed Displacement") + xmlNumber("X", 0.0)))}) {
      SceneInput scene = pulledShaft(elements);
      nameNodesOnAxis(scene, 2.0);
      scene.add("Boundaries", foot + axis);
      scene.add("Responses", forceResponse("force", "axis", {1.0, 0.0}) + forceResponse("along", "axis", {0.0, 1.0}));
      expectPulled(scene, elements.name() + axis);
    }
  }
}

TEST(Axisymmetry, BoundaryOnTheAxisMayTwist) {
  SceneInput scene = pulledShaft(planeElements[1]);
  scene.set("Model/Kinematics=Axisymmetric With Torsion");
  scene.add("Boundaries", boundary("foot", "body_ymin", "Prescribed Displacement", {{"Y", 0.0}, {"Z", 0.0}}) +
                              boundary("axis", "body_xmin", "Prescribed Displacement", {{"X", 0.0}, {"Z", 0.0}}));
  expectPulled(scene, "with torsion");
}

// Its corner has an area, though a small one.
TEST(Axisymmetry, ShaftStandsOnOneNodeOfTheAxis) {
  for (const Elements& elements : planeElements) {
    SceneInput scene = pulledShaft(elements);
    nameNodesOnAxis(scene, 0.0);
    scene.add("Boundaries",
              boundary("other end", "body_ymin", "Pressure", {{"Pressure", -pressure}}) +
                  xmlList("pin", xmlText("Node Set", "axis") +
                                     xmlList("Law", xmlText("Type", "Prescribed Displacement") + xmlNumber("Y", 0.0))));
    expectPulled(scene, elements.name());
  }
}

TEST(Axisymmetry, RefusesToHoldTheAxisAlongItself) {
  for (const auto& [law, words] : std::vector<std::pair<std::string, std::string>>{
           {boundary("axis", "body_xmin", "Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}}),
            "holds along the axis nodes on the axis of axisymmetry, the lowest at y = 0,"},
           {boundary("axis", "body_xmin", "Prescribed Displacement", {{"X", 0.1}}),
            "moves nodes on the axis of axisymmetry, the lowest at y = 0,"}}) {
    SceneInput scene = pulledShaft(planeElements[1]);
    scene.add("Boundaries", boundary("foot", "body_ymin", "Symmetry") + law);
    try {
      const SolvedScene run(scene);
      FAIL() << "no error";
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ExitCode::input);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
}

TEST(Axisymmetry, WeightIsThatOfTheWholeCircle) {
  SceneInput scene = revolved({"Quad4", "Full Integration", 2}, {3, 3}, [](const base::Vector3& x) {
    return base::Vector3{0.5 * x[0], x[1], 0.0};
  });
  scene.add("Parts/body/Body Force", xmlNumber("Y", -0.02));
  scene.add("Boundaries", boundary("ground", "body_ymin", "Symmetry"));
  scene.add("Responses", forceResponse("ground force", "ground", {0.0, 1.0}));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_NEAR(run.value("ground force"), 0.02 * pi * 0.25, 1e-9);
}

TEST(Axisymmetry, RefusesNegativeRadii) {
  SceneInput scene = revolved({"Quad8", "Full Integration", 2}, {2, 2}, [](const base::Vector3& x) {
    return base::Vector3{x[0] - 0.25, x[1], 0.0};
  });
  scene.add("Boundaries", boundary("ground", "body_ymin", "Symmetry"));
  try {
    const SolvedScene run(scene);
    FAIL() << "no error";
  } catch (const base::Error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("Part \"body\" has 5 nodes with a negative radius x, the farthest node"), std::string::npos)
        << message;
    EXPECT_NE(message.find("(-0.25, "), std::string::npos) << message;
  }
}

struct Rings {
  const char* element;
  const char* outerCells;
  double tolerance;
};

// Those of the inner one are 8 x 4.
const std::vector<Rings> rings = {
    {"Quad4", "{8, 4}", 5e-3}, {"Quad4", "{7, 5}", 5e-3}, {"Quad8", "{8, 4}", 2e-5}, {"Quad8", "{7, 5}", 2e-5}};

SceneInput pressedRing(const Rings& of) {
  SceneInput scene = SceneInput::fromFile("elements/pressed_ring.xml");
  scene.set("Mesh/Boxes/outer/Cells=" + std::string(of.outerCells));
  for (const char* box : {"inner", "outer"}) {
    scene.set("Mesh/Boxes/" + std::string(box) + "/Element=" + of.element);
  }
  return scene;
}

constexpr double bore = 1.0, seat = 2.0, rim = 3.0, ringModulus = 1e6, interference = 0.002;

// Lame: p = E d (b^2 - a^2)(c^2 - b^2) / (2 b^3 (c^2 - a^2)), and no stress along the axis, along which both are free.
const double ringPressure = ringModulus * interference * (seat * seat - bore * bore) * (rim * rim - seat * seat) /
                            (2.0 * seat * seat * seat * (rim * rim - bore * bore));

TEST(Axisymmetry, RingPressedOntoAnotherIsInClosedForm) {
  for (const Rings& of : rings) {
    const SolvedScene run(pressedRing(of));
    const std::string what = std::string(of.element) + of.outerCells;
    ASSERT_TRUE(run.isCertified()) << what << ": " << run.result.reason;
    const double u = 2.0 * ringPressure * seat * seat * rim / (ringModulus * (rim * rim - seat * seat));
    EXPECT_NEAR(run.value("u"), u, of.tolerance * u) << what;
    const double force = 2.0 * pi * seat * ringPressure;
    EXPECT_NEAR(run.value("press"), -force, of.tolerance * force) << what;
  }
}

// Pulled along the axis by a displacement until it slides as a whole.
TEST(Axisymmetry, RingSlidesAtTheFrictionOfItsSeat) {
  constexpr double mu = 0.15;
  for (const Rings& of : rings) {
    SceneInput scene = pressedRing(of);
    scene.set(assignment("Interfaces/contact/Law/Friction Coefficient", mu));
    scene.set(assignment("Boundaries/outer_below/Law/Y", -0.01));
    const SolvedScene run(scene);
    const std::string what = std::string(of.element) + of.outerCells;
    ASSERT_TRUE(run.isCertified()) << what << ": " << run.result.reason;
    EXPECT_NEAR(run.value("pull"), -mu * std::abs(run.value("press")), 1e-5 * mu * std::abs(run.value("press")))
        << what;
    EXPECT_NEAR(run.value("press"), -2.0 * pi * seat * ringPressure, 0.1 * 2.0 * pi * seat * ringPressure) << what;
    for (const PairValue& pair : run.pairs("contact")) EXPECT_EQ(pair.status, laws::Status::slip) << what;
  }
}

}  // namespace
}  // namespace harmos::verification
