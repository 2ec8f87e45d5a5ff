#include <gtest/gtest.h>

#include <cmath>

#include "Body.hpp"

namespace harmos::verification {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double nu = 0.3, shearModulus = 1.0 / (2.0 * (1.0 + nu));

const std::vector<Elements> planeElements = {{"Quad4", "Full Integration", 2},
                                             {"Quad8", "Full Integration", 2},
                                             {"Quad9", "Full Integration", 2},
                                             {"Tri6", "Full Integration", 2},
                                             {"Quad4", "B-Bar", 2}};

SceneInput twisted(const Elements& elements, const std::vector<int>& cells,
                   const std::function<base::Vector3(const base::Vector3&)>& place) {
  SceneInput scene = bodyOf(elements, cells, place);
  return scene.add("Model", xmlText("Kinematics", "Axisymmetric With Torsion"));
}

/// A boundary whose law has one formula.
std::string formula(const std::string& name, const std::string& sideSet, const std::string& law,
                    const std::string& value) {
  return xmlList(name, xmlText("Side Set", sideSet) +
                           xmlList("Law", xmlText("Type", law) + xmlNumber("Z", 1.0) + xmlText("Z Formula", value)));
}

std::string momentResponse(const std::string& name, const std::string& interface) {
  return xmlList(
      name, xmlText("Type", "Interface Moment") + xmlText("Interface", interface) + xmlNumbers("Centre", {0.0, 0.0}));
}

std::string torqueResponse(const std::string& name, const std::string& interface) {
  return xmlList(name,
                 xmlText("Type", "Section Force") + xmlText("Interface", interface) + xmlText("Component", "Torque"));
}

// Solid, with nodes on the axis: T = G phi pi R^4 / (2 L); nothing else is stressed. A turn about +y is -z at z = 0.
TEST(Torsion, ShaftTwistsByItsTorque) {
  constexpr double torque = 0.001, length = 2.0, radius = 0.5;
  const double polar = 0.5 * pi * std::pow(radius, 4);
  for (const Elements& elements : planeElements) {
    SceneInput scene = twisted(elements, {4, 3}, [](const base::Vector3& x) {
      return base::Vector3{radius * x[0], length * x[1], 0.0};
    });
    scene.add("Boundaries",
              boundary("below", "body_ymin", "Prescribed Displacement", {{"Y", 0.0}, {"Z", 0.0}}) +
                  formula("above", "body_ymax", "Prescribed Traction", std::to_string(-torque / polar) + " * x"));
    scene.add("Responses", meanDisplacement("u", "body_xmax", {0.0, 0.0, 1.0}) + momentResponse("hold", "below") +
                               torqueResponse("drive", "above") + forceResponse("axial", "below", {0.0, 1.0}));
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << elements.name() << ": " << run.result.reason;
    // Nodal tractions times nodal areas are not the integral of a traction that rises with the radius.
    const double tolerance = elements.element == "Quad4" ? 0.03 : 1e-3;
    EXPECT_NEAR(run.value("drive"), torque, tolerance * torque) << elements.name();
    const double phi = run.value("drive") * length / (shearModulus * polar);
    EXPECT_NEAR(run.value("u"), -0.5 * phi * radius, 1e-3 * phi * radius) << elements.name();
    EXPECT_NEAR(run.value("hold"), -run.value("drive"), 1e-6 * torque) << elements.name();
    EXPECT_NEAR(run.value("axial"), 0.0, 1e-9) << elements.name();
    for (const NodeValue& node : run.displacements()) {
      if (scene.mesh().nodes[node.meshNode][0] == 0.0) {
        EXPECT_EQ(node.displacement[2], 0.0);
      }
    }
  }
}

// The force is that of the whole circle: it twists the shaft by what it has in moment.
TEST(Torsion, ForceOnNodesTwists) {
  constexpr double force = 1e-3, length = 2.0, radius = 0.5;
  SceneInput scene = twisted({"Quad8", "Full Integration", 2}, {4, 8}, [](const base::Vector3& x) {
    return base::Vector3{radius * x[0], length * x[1], 0.0};
  });
  scene.changeMesh([&](mesh::Mesh& mesh) {
    mesh.nodeSets.push_back({"ring", 1, {}});
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      if (base::distance(mesh.nodes[n], {radius, length, 0.0}) < 1e-9) {
        mesh.nodeSets.back().node.push_back(static_cast<int>(n));
      }
    }
  });
  scene.add("Boundaries",
            boundary("below", "body_ymin", "Prescribed Displacement", {{"Y", 0.0}, {"Z", 0.0}}) +
                xmlList("ring", xmlText("Node Set", "ring") +
                                    xmlList("Law", xmlText("Type", "Nodal Force") + xmlNumber("Z", force))));
  scene.add("Responses", momentResponse("hold", "below") + forceResponse("given", "ring", {0.0, 0.0, 1.0}) +
                             xmlList("w", xmlText("Type", "Point Displacement") + xmlNumbers("Point", {radius, 1.0}) +
                                              xmlNumbers("Direction", {0.0, 0.0, 1.0})));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_NEAR(run.value("given"), force, 1e-9 * force);
  EXPECT_NEAR(run.value("hold"), force * radius, 1e-4 * force * radius);
  // In the middle of the shaft, far from both ends.
  const double polar = 0.5 * pi * std::pow(radius, 4);
  EXPECT_NEAR(run.value("w"), force * radius * radius * 1.0 / (shearModulus * polar), 0.02 * run.value("w"));
}

// Foeppl: a cone between two spheres about its apex turns by psi = C / rho^3, which no torsion of rods has.
TEST(Torsion, ConeIsInClosedForm) {
  constexpr double opening = 0.7, c = 1e-3;
  const double cosine = std::cos(opening);
  const double torque = 6.0 * pi * shearModulus * c * (2.0 / 3.0 - cosine + cosine * cosine * cosine / 3.0);
  std::vector<double> errors;
  for (const int cells : {4, 8}) {
    SceneInput scene = twisted({"Quad8", "Full Integration", 2}, {cells, cells}, [](const base::Vector3& x) {
      // xmin is the axis, xmax the mantle; ymin and ymax the spheres.
      const double angle = opening * x[0], rho = 1.0 + x[1];
      return base::Vector3{x[0] == 0.0 ? 0.0 : rho * std::sin(angle), rho * std::cos(angle), 0.0};
    });
    scene.add("Boundaries",
              formula("small", "body_ymin", "Prescribed Displacement", std::to_string(c) + " * x") +
                  formula("large", "body_ymax", "Prescribed Displacement", std::to_string(c) + " * x / 8") +
                  boundary("axial", "body_ymax", "Prescribed Displacement", {{"Y", 0.0}}));
    scene.add("Responses", momentResponse("torque", "small"));
    scene.set("Solver/Accuracy=1e-8");
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    errors.push_back(std::abs(run.value("torque") + torque) / torque);
  }
  EXPECT_LT(errors[1], 2e-5);
  EXPECT_LT(errors[1], 0.2 * errors[0]);
}

struct Rings {
  const char* element;
  const char* outerCells;
  double tolerance;
};

// Those of the inner one are 8 x 4.
const std::vector<Rings> rings = {
    {"Quad4", "{8, 4}", 5e-3}, {"Quad4", "{7, 5}", 5e-3}, {"Quad8", "{8, 4}", 2e-5}, {"Quad8", "{7, 5}", 2e-5}};

/// The bore of the inner ring is kept from turning, the rim of the outer one is turned in the second step.
SceneInput turnedRing(const Rings& of, double friction) {
  SceneInput scene = SceneInput::fromFile("elements/pressed_ring.xml");
  scene.set("Model/Kinematics=Axisymmetric With Torsion");
  scene.set("Mesh/Boxes/outer/Cells=" + std::string(of.outerCells));
  for (const char* box : {"inner", "outer"}) {
    scene.set("Mesh/Boxes/" + std::string(box) + "/Element=" + of.element);
  }
  scene.set(assignment("Interfaces/contact/Law/Friction Coefficient", friction));
  scene.add("Boundaries", boundary("bore", "inner_xmin", "Prescribed Displacement", {{"Z", 0.0}}));
  scene.add("Responses", momentResponse("hold", "bore") + torqueResponse("seat", "contact"));
  return scene;
}

std::string turnOfRim(double z) {
  return xmlList(
      "rim", xmlText("Side Set", "outer_xmax") + xmlList("Law", xmlText("Type", "Prescribed Displacement") +
                                                                    xmlNumber("Z", z) + xmlText("Z History", "pull")));
}

constexpr double bore = 1.0, seat = 2.0, rim = 3.0, ringModulus = 1e6, interference = 0.002, mu = 0.15;
const double ringPressure = ringModulus * interference * (seat * seat - bore * bore) * (rim * rim - seat * seat) /
                            (2.0 * seat * seat * seat * (rim * rim - bore * bore));
const double slipTorque = 2.0 * pi * seat * seat * 1.0 * mu * ringPressure;  // 2 pi r^2 L mu p

TEST(Torsion, RingCarriesTheTorqueOfItsFriction) {
  for (const Rings& of : rings) {
    SceneInput scene = turnedRing(of, mu);
    scene.add("Boundaries", turnOfRim(-0.2));
    const SolvedScene run(scene);
    const std::string what = std::string(of.element) + of.outerCells;
    ASSERT_TRUE(run.isCertified()) << what << ": " << run.result.reason;
    EXPECT_NEAR(run.value("seat"), slipTorque, of.tolerance * slipTorque) << what;
    EXPECT_NEAR(run.value("hold"), -slipTorque, of.tolerance * slipTorque) << what;
    EXPECT_NEAR(run.value("seat", 0), 0.0, 1e-6 * slipTorque) << what;
    for (const PairValue& pair : run.pairs("contact")) {
      EXPECT_EQ(pair.status, laws::Status::slip) << what;
      EXPECT_NEAR(std::abs(pair.traction[2]), mu * std::abs(pair.traction[0]), 1e-3 * mu * ringPressure) << what;
      EXPECT_NEAR(pair.traction[1], 0.0, 1e-3 * mu * ringPressure) << what;
    }
  }
}

// Below the torque of its friction the ring sticks: tubes in shear, phi = T / (4 pi G L) (1/a^2 - 1/b^2) each.
TEST(Torsion, RingSticksBelowTheTorqueOfItsFriction) {
  const double shear = ringModulus / 2.0, turn = 1e-5;  // without Poisson's ratio, which would make the press slip
  const double compliance = (1.0 / (bore * bore) - 1.0 / (rim * rim)) / (4.0 * pi * shear);
  for (const Rings& of : rings) {
    SceneInput scene = turnedRing(of, mu);
    scene.add("Boundaries", turnOfRim(-turn * rim));
    scene.set("Materials/solid/Poisson's Ratio=0");
    const SolvedScene run(scene);
    const std::string what = std::string(of.element) + of.outerCells;
    ASSERT_TRUE(run.isCertified()) << what << ": " << run.result.reason;
    EXPECT_NEAR(run.value("seat"), turn / compliance, of.tolerance * turn / compliance) << what;
    for (const PairValue& pair : run.pairs("contact")) EXPECT_EQ(pair.status, laws::Status::stick) << what;
  }
}

// A torque beyond the friction has no equilibrium, one below it has.
TEST(Torsion, TorqueBeyondTheFrictionHasNoEquilibrium) {
  for (const double share : {0.95, 1.05}) {
    SceneInput scene = turnedRing(rings[1], mu);
    const double traction = -share * slipTorque / (2.0 * pi * rim * rim * 1.0);
    scene.add("Boundaries",
              xmlList("rim", xmlText("Side Set", "outer_xmax") +
                                 xmlList("Law", xmlText("Type", "Prescribed Traction") + xmlNumber("Z", traction) +
                                                    xmlText("Z History", "pull"))));
    scene.set("Solver/Accuracy=1e-4");
    const SolvedScene run(scene);
    EXPECT_EQ(run.result.outcome, share < 1.0 ? latin::Outcome::certified : latin::Outcome::noEquilibrium)
        << share << ": " << run.result.reason;
  }
}

// Two plates of no lateral contraction, pressed together and turned: T = 2/3 pi mu p (b^3 - a^3).
TEST(Torsion, ClutchSlipsAtItsTorque) {
  constexpr double pressure = 50.0;
  for (const char* cells : {"{8, 4}", "{5, 3}"}) {
    for (const char* element : {"Quad4", "Quad8"}) {
      SceneInput scene = SceneInput::fromFile("elements/pressed_ring.xml");
      scene.set("Model/Kinematics=Axisymmetric With Torsion");
      scene.set("Materials/solid/Poisson's Ratio=0");
      scene.set("Mesh/Boxes/outer/Lower Corner={1, 1}").set("Mesh/Boxes/outer/Upper Corner={2, 2}");
      scene.set("Mesh/Boxes/outer/Cells=" + std::string(cells));
      for (const char* box : {"inner", "outer"}) scene.set("Mesh/Boxes/" + std::string(box) + "/Element=" + element);
      scene.set("Interfaces/contact/Side 1=inner_ymax").set("Interfaces/contact/Side 2=outer_ymin");
      scene.set("Interfaces/contact/Law/Gap=0").set(assignment("Interfaces/contact/Law/Friction Coefficient", mu));
      scene.remove("Boundaries/outer_below").remove("Responses/pull").remove("Responses/press");
      scene.add("Boundaries",
                boundary("still", "inner_ymin", "Prescribed Displacement", {{"Z", 0.0}}) +
                    boundary("push", "outer_ymax", "Pressure", {{"Pressure", pressure}}) +
                    xmlList("turn",
                            xmlText("Side Set", "outer_ymax") +
                                xmlList("Law", xmlText("Type", "Prescribed Displacement") + xmlNumber("Z", 1.0) +
                                                   xmlText("Z History", "pull") + xmlText("Z Formula", "-1e-3 * x"))));
      scene.add("Responses", torqueResponse("torque", "contact"));
      const SolvedScene run(scene);
      const std::string what = std::string(element) + cells;
      ASSERT_TRUE(run.isCertified()) << what << ": " << run.result.reason;
      const double torque = 2.0 / 3.0 * pi * mu * pressure * (8.0 - 1.0);
      // Side 1 is below: about its normal +y it is turned along.
      EXPECT_NEAR(run.value("torque"), torque, 1e-5 * torque) << what;
    }
  }
}

// An angular acceleration of a shaft that is held at one end: T = rho e pi R^4 L / 2.
TEST(Torsion, InertiaTwistsAShaft) {
  SceneInput scene = twisted({"Quad8", "Full Integration", 2}, {3, 3}, [](const base::Vector3& x) { return x; });
  scene.add("Materials/elastic", xmlNumber("Density", 2.0));
  scene.add("Loads", xmlList("start", xmlText("Type", "Rotation") + xmlNumber("Angular Velocity", 0.0) +
                                          xmlNumber("Angular Acceleration", 1e-3)));
  scene.add("Boundaries", boundary("below", "body_ymin", "Prescribed Displacement", {{"Y", 0.0}, {"Z", 0.0}}));
  scene.add("Responses", momentResponse("hold", "below"));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  // The support turns along +y and takes the shaft with it.
  EXPECT_NEAR(run.value("hold"), 2.0 * 1e-3 * 0.5 * pi, 1e-9);
}

}  // namespace
}  // namespace harmos::verification
