#include <gtest/gtest.h>

#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/FaceMatching.hpp>
#include <harmos/mesh/Piece.hpp>
#include <harmos/mesh/detail/PartSkin.hpp>

namespace harmos::mesh {
namespace {

/// A plate of 20 x 20 cells with a post on one of them, and another one a little above it.
class PlateWithPosts : public ::testing::Test {
 protected:
  PlateWithPosts()
      : mesh(boxes({{"plate", {0, 0, 0}, {20, 20, 1}, {20, 20, 1}},
                    {"post", {7, 3, 1}, {8, 4, 3}, {1, 1, 2}},
                    {"raised", {12, 12, 1.1}, {13, 13, 3}, {1, 1, 2}}})) {}

  PartSkin skinOf(const std::string& block) const {
    return {mesh, skin(Elements(mesh), makePiece(mesh, block, {block}).elements)};
  }

  Mesh mesh;
};

TEST_F(PlateWithPosts, HaveFewFacesNearEachOther) {
  const PartSkin plate = skinOf("plate"), post = skinOf("post");
  const std::vector<Face> below = plate.near(post);
  EXPECT_LE(below.size(), 9U);
  EXPECT_EQ(post.near(plate).size(), 5U);  // not those of its upper half
  // Nothing that touches is lost.
  EXPECT_EQ(matchFaces(mesh, below, post.near(plate)).size(), 1U);
  EXPECT_EQ(matchNodes(mesh, below, post.near(plate)), matchNodes(mesh, plate.faces(), post.faces()));
}

TEST_F(PlateWithPosts, HaveNoneAcrossAGap) {
  const PartSkin plate = skinOf("plate"), raised = skinOf("raised");
  EXPECT_TRUE(plate.near(raised).empty());
  EXPECT_TRUE(raised.near(plate).empty());
}

}  // namespace
}  // namespace harmos::mesh
