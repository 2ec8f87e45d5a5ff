#include <gtest/gtest.h>

#include <cmath>

#include <harmos/base/Error.hpp>

#include "../elements/Body.hpp"

namespace harmos::verification {
namespace {

constexpr double inner = 1.0, outer = 2.0, young = 1.0, poisson = 0.3, shear = young / 2.0 / (1.0 + poisson);
const base::Vector3 centre{3.0, -1.0, 0.0};

/// A sector of a ring in plane strain, from 20 to 100 degrees about the centre.
SceneInput ring() {
  return bodyOf({"Quad8", "Full Integration", 2}, {8, 10}, [](const base::Vector3& x) {
    const double radius = inner + (outer - inner) * x[0], angle = (20.0 + 80.0 * x[1]) * M_PI / 180.0;
    return centre + radius * base::Vector3{std::cos(angle), std::sin(angle), 0.0};
  });
}

std::string cylindrical(const std::string& name, const std::string& law, const std::string& sideSet,
                        const std::vector<std::pair<std::string, double>>& values,
                        const std::vector<double>& point = {centre[0], centre[1]}) {
  std::string entries = xmlText("Type", "Cylindrical " + law) + xmlNumbers("Point", point);
  for (const auto& [entry, value] : values) entries += xmlNumber(entry, value);
  return xmlList(name, xmlText("Side Set", sideSet) + xmlList("Law", entries));
}

/// Calls with the radius and the radial and tangential displacement of every node.
void forEachNode(const SceneInput& scene, const std::function<void(double, double, double)>& check) {
  const mesh::Mesh mesh = scene.mesh();
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  for (const NodeValue& node : run.displacements()) {
    const base::Vector3 arm = mesh.nodes[node.meshNode] - centre;
    const base::Vector3 radial = (1.0 / base::norm(arm)) * arm;
    check(base::norm(arm), base::dot(radial, node.displacement),
          radial[0] * node.displacement[1] - radial[1] * node.displacement[0]);
  }
}

// Lame: u = A r + B / r with u(inner) = 1e-3 and no stress at the outer radius.
TEST(CylindricalDisplacement, WidensARing) {
  SceneInput scene = ring();
  scene.add("Boundaries", cylindrical("bore", "Displacement", "body_xmin", {{"Radial", 1e-3}}) +
                              cylindrical("ends", "Displacement", "body_ymin", {{"Tangential", 0.0}}) +
                              cylindrical("other", "Displacement", "body_ymax", {{"Tangential", 0.0}}));
  const double ratio = (1.0 - 2.0 * poisson) / (outer * outer);  // A / B
  const double b = 1e-3 / (ratio * inner + 1.0 / inner);
  forEachNode(scene, [&](double radius, double radial, double tangential) {
    EXPECT_NEAR(radial, b * (ratio * radius + 1.0 / radius), 2e-4 * 1e-3);
    EXPECT_NEAR(tangential, 0.0, 2e-4 * 1e-3);
  });
}

// A ring turned at its rim: sigma_rt = tau b^2 / r^2, u_t = tau b^2 / (2 G) (r / a^2 - 1 / r).
TEST(CylindricalTraction, TurnsARing) {
  constexpr double tau = 1e-4;
  SceneInput scene = ring();
  scene.add("Boundaries", cylindrical("bore", "Displacement", "body_xmin", {{"Radial", 0.0}, {"Tangential", 0.0}}) +
                              cylindrical("ends", "Displacement", "body_ymin", {{"Radial", 0.0}}) +
                              cylindrical("other", "Displacement", "body_ymax", {{"Radial", 0.0}}) +
                              cylindrical("rim", "Traction", "body_xmax", {{"Tangential", tau}}));
  const double factor = tau * outer * outer / (2.0 * shear);
  forEachNode(scene, [&](double radius, double radial, double tangential) {
    EXPECT_NEAR(tangential, factor * (radius / inner / inner - 1.0 / radius), 1e-3 * factor * 1.5);
    EXPECT_NEAR(radial, 0.0, 1e-3 * factor);
  });
}

TEST(CylindricalDisplacement, NeedsADirection) {
  SceneInput scene = ring();
  scene.add("Boundaries", cylindrical("bore", "Displacement", "body_xmin", {{"Radial", 1e-3}},
                                      {centre[0] + std::cos(M_PI / 9.0), centre[1] + std::sin(M_PI / 9.0)}));
  try {
    const SolvedScene run(scene);
    FAIL() << "accepted";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    EXPECT_NE(std::string(error.what()).find("lies on the axis"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace harmos::verification
