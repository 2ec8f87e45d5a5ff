#include <gtest/gtest.h>

#include <cmath>

#include <harmos/base/Error.hpp>

#include "../elements/Body.hpp"

namespace harmos::verification {
namespace {

constexpr double length = 4.0;
const base::Vector3 force{1e-4, -2e-4, 3e-4};

/// A bar 4 x 1 x 1 along x, held at x = 0; the node set "loaded" has the nodes that `isLoaded`.
SceneInput bar(const std::string& element, const std::function<bool(const base::Vector3&)>& isLoaded) {
  SceneInput scene = bodyOf({element}, {8, 2, 2}, [](const base::Vector3& x) {
    return base::Vector3{length * x[0], x[1], x[2]};
  });
  scene.changeMesh([&](mesh::Mesh& mesh) {
    mesh.nodeSets.push_back({"loaded", 1, {}});
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      if (isLoaded(mesh.nodes[n])) mesh.nodeSets.back().node.push_back(static_cast<int>(n));
    }
  });
  const auto moment = [](const std::string& name, const std::vector<double>& axis) {
    return xmlList(name, xmlText("Type", "Interface Moment") + xmlText("Interface", "foot") +
                             xmlNumbers("Centre", {0.0, 0.0, 0.0}) + xmlNumbers("Axis", axis));
  };
  scene.add("Boundaries",
            boundary("foot", "body_xmin", "Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}}) +
                xmlList("load", xmlText("Node Set", "loaded") +
                                    xmlList("Law", xmlText("Type", "Nodal Force") + xmlNumber("X", force[0]) +
                                                       xmlNumber("Y", force[1]) + xmlNumber("Z", force[2]))));
  scene.add("Responses", forceResponse("x", "foot", {1, 0, 0}) + forceResponse("y", "foot", {0, 1, 0}) +
                             forceResponse("z", "foot", {0, 0, 1}) + forceResponse("given", "load", {1, 0, 0}) +
                             moment("mx", {1, 0, 0}) + moment("my", {0, 1, 0}) + moment("mz", {0, 0, 1}));
  return scene;
}

bool isCorner(const base::Vector3& x) {
  const auto isEnd = [](double s) { return s < 1e-9 || s > 1.0 - 1e-9; };
  return x[0] > length - 1e-9 && isEnd(x[1]) && isEnd(x[2]);
}

/// The foot takes `count` forces in the mean of their places.
void expectReactions(const SolvedScene& run, int count, const base::Vector3& middle) {
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const base::Vector3 sum = static_cast<double>(count) * force, about = base::cross(middle, sum);
  const char* names[] = {"x", "y", "z", "mx", "my", "mz"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(run.value(names[i]), -sum[i], 1e-5 * base::norm(sum));
    EXPECT_NEAR(run.value(names[i + 3]), -about[i], 1e-5 * base::norm(sum) * length);
  }
  EXPECT_NEAR(run.value("given"), sum[0], 1e-9 * base::norm(sum));
}

// Corners of TET10 faces have no share of their area, those of HEX20 a negative one: a force is a force.
TEST(NodalForce, ActsOnEveryNodeOfTheSet) {
  for (const std::string element : {"Hex8", "Tet4", "Tet10", "Hex20", "Wedge15"}) {
    SCOPED_TRACE(element);
    expectReactions(SolvedScene(bar(element, isCorner)), 4, {length, 0.5, 0.5});
  }
}

TEST(NodalForce, ActsInsideOfAPart) {
  const base::Vector3 place{1.5, 0.5, 0.5};
  for (const std::string element : {"Hex8", "Tet10"}) {
    SCOPED_TRACE(element);
    const auto isThere = [&](const base::Vector3& x) { return base::norm(x - place) < 1e-9; };
    expectReactions(SolvedScene(bar(element, isThere)), 1, place);
  }
}

// Nodes on cuts belong to several pieces, and a whole cross-section has some for sure.
TEST(RanksNodalForce, ActsOncePerNodeOfCutParts) {
  for (const std::string mass : {"Lumped", "Consistent"}) {
    SCOPED_TRACE(mass);
    SceneInput scene = bar("Hex8", [](const base::Vector3& x) { return x[2] > 1.0 - 1e-9 && x[1] < 1e-9; });
    scene.set("Parts/body/Pieces=3").set("Solver/Interface Mass=" + mass);
    expectReactions(SolvedScene(scene), 9, {0.5 * length, 0.0, 1.0});
  }
}

// A ring of forces per circle: the whole force, whatever the radius.
TEST(NodalForce, IsThatOfTheWholeCircle) {
  SceneInput scene = bodyOf({"Quad8", "Full Integration", 2}, {2, 4}, [](const base::Vector3& x) {
    return base::Vector3{1.0 + x[0], 3.0 * x[1], 0.0};
  });
  scene.add("Model", xmlText("Kinematics", "Axisymmetric"));
  scene.changeMesh([](mesh::Mesh& mesh) {
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      const base::Vector3& x = mesh.nodes[n];
      if (std::hypot(x[0] - 2.0, x[1] - 3.0) < 1e-9) mesh.nodeSets.push_back({"rim", 1, {static_cast<int>(n)}});
    }
  });
  scene.add("Boundaries",
            boundary("foot", "body_ymin", "Prescribed Displacement", {{"Y", 0.0}}) +
                xmlList("load", xmlText("Node Set", "rim") +
                                    xmlList("Law", xmlText("Type", "Nodal Force") + xmlNumber("Y", -7.0))));
  scene.add("Responses", forceResponse("foot", "foot", {0.0, 1.0}));
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_NEAR(run.value("foot"), 7.0, 1e-5);
}

}  // namespace
}  // namespace harmos::verification
