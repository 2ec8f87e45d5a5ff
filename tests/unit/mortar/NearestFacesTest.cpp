// Places on and beside faces of every shape, in space and in the plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <harmos/mortar/NearestFaces.hpp>

#include "SurfaceMeshes.hpp"

namespace harmos::mortar {
namespace {

double linear(const base::Vector3& x) {
  return 1.0 + 2.0 * x[0] - 3.0 * x[1] + x[2];
}

double interpolated(const NearestFaces::Found& found, const mesh::Mesh& mesh) {
  double sum = 0.0;
  for (const auto& [node, weight] : found.weights) sum += weight * linear(mesh.nodes[node]);
  return sum;
}

class NearestFacesOf : public testing::TestWithParam<int> {
 protected:
  /// A grid of faces in a plane that lies askew.
  NearestFacesOf() {
    mesh_.dimension = isFlat() ? 2 : 3;
    Grid grid;
    grid.nodesPerFace = std::abs(GetParam());
    grid.first = 3;
    grid.second = isFlat() ? 1 : 2;
    grid.map = isFlat() ? plane() : turned(plane());
    grid.distortion = isFlat() ? 0.0 : 0.2;
    faces_ = meshGrid(mesh_, "side", grid).faces;
  }
  /// Negative: of a line in the plane.
  bool isFlat() const { return GetParam() < 0; }

  base::Vector3 place(double first, double second) const {
    return isFlat() ? plane()(first, 0.0) : turned(plane())(first, second);
  }

  mesh::Mesh mesh_;
  std::vector<mesh::Face> faces_;
};

TEST_P(NearestFacesOf, ReproducesLinearFields) {
  const NearestFaces search(mesh_.dimension, std::make_shared<const std::vector<base::Vector3>>(mesh_.nodes), faces_);
  for (const double first : {0.0, 0.05, 0.31, 0.5, 0.97, 1.0}) {
    for (const double second : {0.0, 0.13, 0.5, 0.71, 1.0}) {
      const base::Vector3 x = place(first, second);
      const auto found = search.at(x);
      ASSERT_FALSE(found.empty());
      EXPECT_NEAR(found.front().distance, 0.0, 1e-12);
      EXPECT_NEAR(interpolated(found.front(), mesh_), linear(x), 1e-11);
    }
  }
}

TEST_P(NearestFacesOf, FindsAllFacesOfANode) {
  const NearestFaces search(mesh_.dimension, std::make_shared<const std::vector<base::Vector3>>(mesh_.nodes), faces_);
  for (std::size_t node = 0; node < mesh_.nodes.size(); ++node) {
    std::size_t around = 0;
    for (const mesh::Face& face : faces_) {
      around += static_cast<std::size_t>(std::count(face.nodes.begin(), face.nodes.end(), static_cast<int>(node)));
    }
    EXPECT_EQ(search.at(mesh_.nodes[node]).size(), around);
  }
}

TEST_P(NearestFacesOf, MeasuresTheDistance) {
  const NearestFaces search(mesh_.dimension, std::make_shared<const std::vector<base::Vector3>>(mesh_.nodes), faces_);
  const base::Vector3 edge = place(1.0, 0.5), inner = place(0.9, 0.5);
  const base::Vector3 beyond = edge + 3.0 * (edge - inner);
  EXPECT_NEAR(search.at(beyond).front().distance, 3.0 * distance(edge, inner), 1e-9);
  EXPECT_LE(search.distanceToBox(beyond), 3.0 * distance(edge, inner) + 1e-12);
  EXPECT_NEAR(search.distanceToBox(inner), 0.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(All, NearestFacesOf, testing::Values(-2, -3, 3, 4, 6, 8, 9));

}  // namespace
}  // namespace harmos::mortar
