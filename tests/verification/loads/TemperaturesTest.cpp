#include <gtest/gtest.h>

#include <cmath>

#include "../elements/Body.hpp"

namespace harmos::verification {
namespace {

constexpr double tolerance = 1e-6, alpha = 1.2e-3;

SceneInput warmBody(const Elements& elements, const std::vector<int>& cells, const base::Vector3& size) {
  SceneInput scene = bodyOf(elements, cells, [&](const base::Vector3& x) {
    return base::Vector3{size[0] * x[0], size[1] * x[1], size[2] * x[2]};
  });
  return scene.add("Materials/elastic", xmlNumber("Thermal Expansion", alpha));
}

std::string temperature(double value, const std::string& more = "") {
  return xmlList("heat", xmlText("Type", "Prescribed") + xmlNumber("Temperature", value) + more);
}

// N = -E alpha (T - T_ref) A, and no other stress.
TEST(Temperatures, RestrainedBarsPush) {
  SceneInput scene = warmBody({"Hex8", "Incompatible Modes", 3}, {3, 1, 1}, {3.0, 0.5, 0.5});
  scene.add("Boundaries", boundary("left", "body_xmin", "Symmetry") + boundary("right", "body_xmax", "Symmetry") +
                              boundary("front", "body_ymin", "Symmetry") + boundary("below", "body_zmin", "Symmetry"));
  scene.add("Temperatures", temperature(50.0, xmlNumber("Reference", 20.0)));
  scene.add("Responses", forceResponse("push", "right", {1, 0, 0}) + meanDisplacement("grows", "body_ymax", {0, 1, 0}) +
                             xmlList("stress", xmlText("Type", "Von Mises Stress") + xmlText("Part", "body")));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const auto material = scene.scene().input.lists("Materials")[0];
  const double push = -material.number("Young's Modulus") * alpha * 30.0 * 0.25;
  const double grows = (1.0 + material.number("Poisson's Ratio")) * alpha * 30.0 * 0.5;
  EXPECT_NEAR(run.value("push"), push, tolerance * std::abs(push));
  EXPECT_NEAR(run.value("grows"), grows, tolerance * grows);
  EXPECT_NEAR(run.value("stress"), std::abs(push) / 0.25, tolerance * std::abs(push) / 0.25);
}

// A linear temperature bends a free plate without stress: u_x = alpha G x y, u_y = alpha G (y^2 - x^2) / 2.
TEST(Temperatures, LinearFieldsBendFreely) {
  constexpr double slope = 10.0;
  SceneInput scene = warmBody({"Quad8", "Full Integration", 2}, {4, 2}, {4.0, 1.0, 0.0});
  scene.add("Model", xmlText("Kinematics", "Plane Stress"));
  scene.changeMesh([](mesh::Mesh& mesh) {
    mesh::NodeSet foot{"foot", 1, {}}, roller{"roller", 2, {}};
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      const base::Vector3& x = mesh.nodes[n];
      if (x[0] == 0.0 && x[1] == 0.0) foot.node.push_back(static_cast<int>(n));
      if (x[0] == 0.0 && x[1] == 1.0) roller.node.push_back(static_cast<int>(n));
    }
    mesh.nodeSets = {foot, roller};
  });
  const auto held = [](const std::string& name, const std::string& values) {
    return xmlList(name,
                   xmlText("Node Set", name) + xmlList("Law", xmlText("Type", "Prescribed Displacement") + values));
  };
  scene.add("Boundaries",
            held("foot", xmlNumber("X", 0.0) + xmlNumber("Y", 0.0)) + held("roller", xmlNumber("X", 0.0)));
  scene.addNodalVariable("heat", [](const base::Vector3& x) { return 5.0 * x[1]; });
  for (const bool isInFile : {false, true}) {
    scene.remove("Temperatures");
    scene.add("Temperatures", isInFile
                                  ? xmlList("heat", xmlText("Type", "Nodal Variable") + xmlText("Variable", "heat") +
                                                        xmlNumber("Factor", slope / 5.0))
                                  : temperature(slope, xmlText("Temperature Formula", "y")));
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    const mesh::Mesh mesh = scene.mesh();
    for (const NodeValue& node : run.displacements()) {
      const base::Vector3& x = mesh.nodes[node.meshNode];
      EXPECT_NEAR(node.displacement[0], alpha * slope * x[0] * x[1], 1e-5 * alpha * slope * 8.0);
      EXPECT_NEAR(node.displacement[1], 0.5 * alpha * slope * (x[1] * x[1] - x[0] * x[0]), 1e-5 * alpha * slope * 8.0);
    }
  }
}

// Timoshenko (1925): two strips of one thickness and modulus curve by 3/2 (alpha_2 - alpha_1) T / h.
TEST(Temperatures, BimetalStripsCurve) {
  constexpr double span = 20.0, height = 1.0, degrees = 10.0;
  SceneInput scene = SceneInput::fromFile("../../xml/bimetal_strip.xml");
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double end = 0.5 * 1.5 * (2.0e-5 - 1.0e-5) * degrees / height * span * span;
  EXPECT_NEAR(run.value("deflection"), end, 0.01 * end);
}

}  // namespace
}  // namespace harmos::verification
