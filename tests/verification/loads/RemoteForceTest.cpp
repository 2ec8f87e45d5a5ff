#include <gtest/gtest.h>

#include <cmath>

#include <harmos/base/Error.hpp>

#include "../elements/Body.hpp"

namespace harmos::verification {
namespace {

constexpr double tolerance = 1e-6, length = 10.0, side = 1.0;

/// A bar 10 x 1 x 1 along x, held at x = 0, without Poisson's effect.
SceneInput bar(const std::string& element) {
  SceneInput scene = bodyOf({element, element == "Hex8" ? "Incompatible Modes" : "Full Integration", 3}, {10, 2, 2},
                            [](const base::Vector3& x) {
                              return base::Vector3{length * x[0], side * (x[1] - 0.5), side * (x[2] - 0.5)};
                            });
  return scene.set("Materials/elastic/Poisson's Ratio=0");
}

std::string remote(const std::string& sideSet, const std::vector<std::pair<std::string, double>>& values,
                   const std::vector<double>& point = {}) {
  std::string entries = xmlText("Type", "Remote Force") + (point.empty() ? "" : xmlNumbers("Point", point));
  for (const auto& [name, value] : values) entries += xmlNumber(name, value);
  return xmlList("load", xmlText("Side Set", sideSet) + xmlList("Law", entries));
}

std::string clamp() {
  return boundary("foot", "body_xmin", "Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}});
}

std::string moment(const std::string& name, const std::vector<double>& axis) {
  return xmlList(name, xmlText("Type", "Interface Moment") + xmlText("Interface", "foot") +
                           xmlNumbers("Centre", {0.0, 0.0, 0.0}) + xmlNumbers("Axis", axis));
}

// A force beyond the end of a bar: F L^3 / (3 E I) + F a L^2 / (2 E I) and the shear of Timoshenko.
TEST(RemoteForce, BendsFromAfar) {
  constexpr double force = 1e-4, arm = 5.0;
  for (const char* element : {"Hex8", "Hex20"}) {
    SceneInput scene = bar(element);
    scene.add("Boundaries", clamp() + remote("body_xmax", {{"Y", force}}, {length + arm, 0.0, 0.0}));
    scene.add("Responses", meanDisplacement("end", "body_xmax", {0, 1, 0}) + forceResponse("shear", "foot", {0, 1, 0}) +
                               moment("bend", {0, 0, 1}) + moment("twist", {1, 0, 0}));
    const SolvedScene run(scene);
    ASSERT_TRUE(run.isCertified()) << run.result.reason;
    const double stiffness = 1.0 / 12.0, shear = 0.5 * 5.0 / 6.0;
    const double end =
        force * (std::pow(length, 3) / 3.0 + arm * length * length / 2.0) / stiffness + force * length / shear;
    EXPECT_NEAR(run.value("end"), end, 5e-3 * end) << element;
    EXPECT_NEAR(run.value("shear"), -force, tolerance * force);
    EXPECT_NEAR(run.value("bend"), -force * (length + arm), tolerance * force * length);
    EXPECT_NEAR(run.value("twist"), 0.0, tolerance * force * length);
  }
}

// Pure bending is exact: the tractions are those of the solution, u_y = M x^2 / (2 E I).
TEST(RemoteForce, MomentsBendPurely) {
  constexpr double couple = 1e-3;
  SceneInput scene = bar("Hex20");
  scene.changeMesh([](mesh::Mesh& mesh) {
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      if (base::norm(mesh.nodes[n]) < 1e-9) mesh.nodeSets.push_back({"middle", 1, {static_cast<int>(n)}});
    }
  });
  scene.add("Boundaries",
            boundary("foot", "body_xmin", "Symmetry") + boundary("back", "body_zmin", "Symmetry") +
                remote("body_xmax", {{"Moment Z", couple}}) +
                xmlList("pin", xmlText("Node Set", "middle") +
                                   xmlList("Law", xmlText("Type", "Prescribed Displacement") + xmlNumber("Y", 0.0))));
  scene.add("Responses", meanDisplacement("end", "body_xmax", {0, 1, 0}));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double end = couple * length * length / 2.0 * 12.0;
  EXPECT_NEAR(run.value("end"), end, 1e-5 * end);
}

// All six numbers, over the pieces that the face lies on, on any number of ranks.
TEST(RanksRemoteForce, ReachesTheFootOverPieces) {
  SceneInput scene = bar("Hex8");
  scene.set("Parts/body/Pieces=3");
  scene.add(
      "Boundaries",
      clamp() +
          remote("body_ymax",
                 {{"X", 1e-4}, {"Y", 2e-4}, {"Z", -3e-4}, {"Moment X", 4e-4}, {"Moment Y", 5e-4}, {"Moment Z", -6e-4}},
                 {1.0, 2.0, 3.0}));
  scene.add("Responses", forceResponse("x", "foot", {1, 0, 0}) + forceResponse("y", "foot", {0, 1, 0}) +
                             forceResponse("z", "foot", {0, 0, 1}) + moment("mx", {1, 0, 0}) + moment("my", {0, 1, 0}) +
                             moment("mz", {0, 0, 1}));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const base::Vector3 force{1e-4, 2e-4, -3e-4};
  const base::Vector3 about = base::Vector3{4e-4, 5e-4, -6e-4} + base::cross({1.0, 2.0, 3.0}, force);
  const char* names[] = {"x", "y", "z", "mx", "my", "mz"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(run.value(names[i]), -force[i], 1e-9);
    EXPECT_NEAR(run.value(names[i + 3]), -about[i], 1e-8);
  }
}

TEST(RemoteForce, NeedsAFace) {
  SceneInput scene = bar("Hex8");
  scene.changeMesh([](mesh::Mesh& mesh) {
    mesh.nodeSets.push_back({"edge", 1, {}});
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      const base::Vector3& x = mesh.nodes[n];
      if (x[0] > length - 1e-9 && x[1] > 0.5 * side - 1e-9) mesh.nodeSets.back().node.push_back(static_cast<int>(n));
    }
  });
  scene.add("Boundaries",
            clamp() + xmlList("load", xmlText("Node Set", "edge") +
                                          xmlList("Law", xmlText("Type", "Remote Force") + xmlNumber("X", 1.0))));
  try {
    const SolvedScene run(scene);
    FAIL() << "accepted";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    EXPECT_NE(std::string(error.what()).find("\"Remote Force\" turns its face, but all nodes here lie on one line"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace harmos::verification
