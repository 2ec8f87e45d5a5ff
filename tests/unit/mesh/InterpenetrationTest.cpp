#include <cmath>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/InterfaceFinder.hpp>
#include <harmos/mesh/Interpenetration.hpp>

namespace harmos::mesh {
namespace {

/// How far the part b of a mesh reaches into its part a.
Interpenetration reachOf(const Mesh& mesh) {
  const Elements elements(mesh);
  return interpenetration(mesh, skin(elements, makePiece(mesh, "b", {"b"}).elements),
                          skin(elements, makePiece(mesh, "a", {"a"}).elements));
}

// Above the middle of a box of 2 x 2 x 2, the lowest layer of another one dips into it.
TEST(Interpenetration, IsTheDepthBelowTheSurface) {
  for (const ElementType type : {ElementType::hex8, ElementType::tet4, ElementType::wedge6, ElementType::hex20}) {
    for (const double overlap : {0.1, 0.4}) {
      const Mesh mesh = boxes({{"a", {}, {2.0, 2.0, 2.0}, {2, 2, 2}, type},
                               {"b", {0.5, 0.5, 2.0 - overlap}, {1.5, 1.5, 3.0}, {2, 2, 4}, ElementType::hex8}});
      const Interpenetration found = reachOf(mesh);
      EXPECT_EQ(found.elements, 4);                // layers above begin higher
      const double layer = (1.0 + overlap) / 4.0;  // of whose height a tenth of a half is beneath the face
      EXPECT_NEAR(found.depth, overlap - 0.05 * layer, 1e-12);
    }
  }
}

TEST(Interpenetration, IsNoneWherePartsTouchOrAreApart) {
  for (const base::Vector3& corner : {base::Vector3{0, 0, 1}, {1, 1, 1}, {1, 1, 0}, {0.3, 0.2, 1}, {0, 0, 1.2}}) {
    const base::Vector3 end{corner[0] + 1, corner[1] + 1, corner[2] + 1};
    const Mesh mesh = boxes({{"a", {}, {1.0, 1.0, 1.0}, {3, 2, 2}}, {"b", corner, end, {2, 3, 1}}});
    EXPECT_EQ(reachOf(mesh).elements, 0);
    EXPECT_EQ(reachOf(mesh).element, -1);
  }
}

TEST(Interpenetration, IsFoundInThePlaneAndWherePartsAreTheSame) {
  const auto plane = [](const base::Vector3& corner) {
    return boxes({{"a", {}, {1.0, 1.0, 1.0}, {2, 2, 1}, ElementType::quad4},
                  {"b", corner, {2.0, 2.0, 1.0}, {3, 3, 1}, ElementType::tri3}});
  };
  EXPECT_GT(reachOf(plane({0.5, 0.5, 0.0})).depth, 0.2);
  EXPECT_EQ(reachOf(plane({1.0, 0.5, 0.0})).elements, 0);
  const Mesh twice = boxes({{"a", {}, {1.0, 1.0, 1.0}, {1, 1, 1}}, {"b", {}, {1.0, 1.0, 1.0}, {1, 1, 1}}});
  EXPECT_EQ(reachOf(twice).elements, 1);
}

// Four corners coincide, where edges of both boxes cross: no interface.
TEST(Interpenetration, RefusesAnInterfaceOfPartsThatOverlap) {
  const Mesh mesh = boxes({{"a", {}, {1.0, 1.0, 1.0}, {4, 4, 4}}, {"b", {0.0, 0.0, 0.5}, {1.0, 1.0, 1.5}, {3, 3, 3}}});
  const std::vector<Piece> pieces{makePiece(mesh, "a", {"a"}), makePiece(mesh, "b", {"b"})};
  const InterfaceFinder finder(mesh, pieces);
  try {
    finder.betweenParts("joint", "a", "b", 30.0);
    FAIL() << "joined";
  } catch (const base::Error& error) {
    EXPECT_NE(std::string(error.what()).find("parts \"a\" and \"b\" overlap"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace harmos::mesh
