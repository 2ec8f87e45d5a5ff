#include <gtest/gtest.h>

#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/Partition.hpp>
#include <harmos/mesh/TouchingParts.hpp>

namespace harmos::mesh {
namespace {

/// Four boxes around a common edge, of which `d` has other cells, and `far` apart from all.
class BoxesAroundAnEdge : public ::testing::Test {
 protected:
  BoxesAroundAnEdge()
      : mesh(boxes({{"a", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}},
                    {"b", {1, 0, 0}, {2, 1, 1}, {2, 2, 2}},
                    {"c", {0, 1, 0}, {1, 2, 1}, {2, 2, 2}},
                    {"d", {1, 1, 0}, {2, 2, 1}, {3, 3, 3}},
                    {"far", {2.01, 0, 0}, {3, 1, 1}, {2, 2, 2}}})) {
    for (Piece& piece : cutPart(mesh, makePiece(mesh, "a", {"a"}), 2)) pieces.push_back(std::move(piece));
    for (const char* name : {"b", "c", "d", "far"}) pieces.push_back(makePiece(mesh, name, {name}));
  }

  Mesh mesh;
  std::vector<Piece> pieces;
  std::vector<std::string> all{"a", "b", "c", "d", "far"};
};

TEST_F(BoxesAroundAnEdge, TouchWhereFacesLieOnEachOtherMatchingOrNot) {
  // a and d, as b and c, have an edge in common; between b and "far" is a gap.
  const std::vector<PartPair> expected{{"a", "b"}, {"a", "c"}, {"b", "d"}, {"c", "d"}};
  EXPECT_EQ(touchingParts(mesh, pieces, all, all), expected);
}

TEST_F(BoxesAroundAnEdge, TouchAPairOnceWithItsSidesAsTheListsSay) {
  EXPECT_EQ(touchingParts(mesh, pieces, {"d"}, all), (std::vector<PartPair>{{"d", "b"}, {"d", "c"}}));
  EXPECT_EQ(touchingParts(mesh, pieces, {"d", "b"}, {"b", "d"}), (std::vector<PartPair>{{"d", "b"}}));
  EXPECT_TRUE(touchingParts(mesh, pieces, {"far"}, all).empty());
}

}  // namespace
}  // namespace harmos::mesh
