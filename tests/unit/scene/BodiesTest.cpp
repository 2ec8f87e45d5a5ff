#include <gtest/gtest.h>

#include <harmos/scene/MeshSource.hpp>

#include "Sample.hpp"

namespace harmos::scene {
namespace {

TEST(Bodies, PiecesKeepTheOptionsOfTheirPart) {
  const Scene scene = sample({"Parts/lower/Pieces=2"});
  const mesh::Mesh mesh = makeMesh(scene.input.list("Mesh"), "");
  input::ErrorList errors;
  const Bodies bodies = makeBodies(scene, mesh, errors);
  ASSERT_EQ(errors.count(), 0);
  ASSERT_EQ(bodies.pieces.size(), 3u);
  EXPECT_EQ(bodies.parts[0].name, "lower");
  EXPECT_EQ(bodies.parts[1].name, "lower");
  EXPECT_EQ(bodies.parts[2].name, "upper");
}

TEST(Bodies, EqualBodiesAreFoundButNotAcrossFormulations) {
  for (const std::string formulation : {"Full Integration", "B-Bar"}) {
    const Scene scene = sample({"Parts/upper/Formulation=" + formulation});
    const mesh::Mesh mesh = makeMesh(scene.input.list("Mesh"), "");
    input::ErrorList errors;
    const auto congruences =
        findCongruences(makeBodies(scene, mesh, errors), mesh, elasticity::Kinematics::threeDimensional);
    EXPECT_EQ(congruences[0], nullptr);
    EXPECT_EQ(congruences[1] != nullptr, formulation == "Full Integration");
  }
}

TEST(Bodies, RingsOfOtherRadiiAreNotEqual) {
  Scene scene = sample({"Parts/upper/Formulation=Full Integration"});
  mesh::Mesh mesh = makeMesh(scene.input.list("Mesh"), "");
  input::ErrorList errors;
  const Bodies bodies = makeBodies(scene, mesh, errors);
  const auto isEqual = [&] {
    return findCongruences(bodies, mesh, elasticity::Kinematics::axisymmetric)[1] != nullptr;
  };
  EXPECT_TRUE(isEqual());  // one above the other
  for (const int node : bodies.pieces[1].nodes) mesh.nodes[node][0] += 3.0;
  EXPECT_FALSE(isEqual());
}

TEST(Bodies, LargestGoFirstToTheLeastBusyRank) {
  Bodies bodies;
  for (const std::size_t nodes : {10u, 100u, 60u, 50u}) {
    bodies.pieces.emplace_back();
    bodies.pieces.back().nodes.resize(nodes);
  }
  EXPECT_EQ(distribute(bodies, 1), (std::vector<int>{0, 0, 0, 0}));
  EXPECT_EQ(distribute(bodies, 2), (std::vector<int>{1, 0, 1, 1}));
}

}  // namespace
}  // namespace harmos::scene
