#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/BoltedJoint.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/FaceIntegrals.hpp>
#include <harmos/mesh/Refinement.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {
namespace {

Mesh box(ElementType type, int cells = 2) {
  Box one;
  one.name = "box";
  one.element = type;
  one.upper = {1.0, 2.0, dimensionOf(type) == 3 ? 3.0 : 0.0};
  one.cells = {cells, cells, cells};
  return boxes({one});
}

std::vector<int> all(const Mesh& mesh) {
  std::vector<int> elements(Elements(mesh).count());
  for (std::size_t e = 0; e < elements.size(); ++e) elements[e] = static_cast<int>(e);
  return elements;
}

double areaOf(const Mesh& mesh, const std::vector<Face>& faces) {
  double area = 0.0;
  for (const Face& face : faces) {
    for (const NodalWeight& weight : integrateFace(mesh.dimension, pointsOf(mesh, face.nodes), 1.0).weight) {
      area += weight.area;
    }
  }
  return area;
}

std::vector<Face> facesOf(const Mesh& mesh, const SideSet& set) {
  const Elements elements(mesh);
  std::vector<Face> faces;
  for (std::size_t i = 0; i < set.element.size(); ++i) {
    faces.push_back({set.element[i], set.side[i], elements.side(set.element[i], set.side[i])});
  }
  return faces;
}

/// Elements have a volume and share sides with the same nodes: the skin has the area of the box, every set its own.
void expectSound(const Mesh& mesh, double skinArea, const std::vector<double>& setAreas) {
  EXPECT_NEAR(areaOf(mesh, skin(Elements(mesh), all(mesh))), skinArea, 1e-12 * skinArea);
  for (std::size_t s = 0; s < setAreas.size(); ++s) {
    EXPECT_NEAR(areaOf(mesh, facesOf(mesh, mesh.sideSets[s])), setAreas[s], 1e-12 * skinArea) << mesh.sideSets[s].name;
  }
  std::set<base::Vector3> places(mesh.nodes.begin(), mesh.nodes.end());
  EXPECT_EQ(places.size(), mesh.nodes.size());
}

class EveryType : public ::testing::TestWithParam<ElementType> {
 protected:
  void expectBox(const Mesh& mesh) const {
    if (mesh.dimension == 3) {
      expectSound(mesh, 22.0, {6.0, 6.0, 3.0, 3.0, 2.0, 2.0});
    } else {
      expectSound(mesh, 6.0, {2.0, 2.0, 1.0, 1.0});
    }
  }
};

TEST_P(EveryType, SplitsIntoElementsThatShareSides) {
  const Mesh coarse = box(GetParam());
  const Mesh fine = refined(coarse);
  EXPECT_EQ(fine.blocks[0].type, GetParam());
  EXPECT_EQ(fine.blocks[0].elements(), coarse.blocks[0].elements() * (coarse.dimension == 3 ? 8 : 4));
  EXPECT_EQ(fine.nodes.size(), box(GetParam(), 4).nodes.size());
  EXPECT_TRUE(std::equal(coarse.nodes.begin(), coarse.nodes.end(), fine.nodes.begin()));
  expectBox(fine);
  expectBox(refined(fine));
}

TEST_P(EveryType, IsRaisedOnce) {
  const Mesh mesh = raised(box(GetParam()));
  EXPECT_TRUE(isQuadratic(mesh.blocks[0].type));
  EXPECT_EQ(linearType(mesh.blocks[0].type), linearType(GetParam()));
  EXPECT_EQ(mesh.nodes.size(), box(mesh.blocks[0].type).nodes.size());
  expectBox(mesh);
  const Mesh again = raised(mesh);
  EXPECT_EQ(again.blocks[0].connectivity, mesh.blocks[0].connectivity);
  EXPECT_EQ(again.nodes.size(), mesh.nodes.size());
}

INSTANTIATE_TEST_SUITE_P(Elements, EveryType,
                         ::testing::Values(ElementType::tri3, ElementType::quad4, ElementType::tet4,
                                           ElementType::wedge6, ElementType::hex8, ElementType::tri6,
                                           ElementType::quad8, ElementType::quad9, ElementType::tet10,
                                           ElementType::wedge15, ElementType::hex20, ElementType::hex27),
                         [](const auto& type) { return std::string(exodusName(type.param)); });

TEST(Refinement, KeepsTheNumbersOfParentsAndOldNodes) {
  Mesh mesh = box(ElementType::quad4, 1);
  mesh.numbering = {"plate.e", {1017}, {7, 5, 3, 1}, false};
  EXPECT_EQ(elementName(mesh, 0), "element 1017 of \"plate.e\" (block \"box\")");
  const Mesh higher = raised(mesh), fine = refined(mesh);
  EXPECT_EQ(elementName(higher, 0), elementName(mesh, 0));
  for (int e = 0; e < 4; ++e) {
    EXPECT_EQ(elementName(fine, e), "a child of element 1017 of \"plate.e\" (block \"box\")");
    EXPECT_EQ(elementName(refined(higher), e), elementName(fine, e));
  }
  for (const Mesh& made : {higher, fine}) {
    EXPECT_EQ(nodeName(made, 3), "node 1 of \"plate.e\" at (1, 2)");
    EXPECT_EQ(nodeName(made, 4).rfind("a node made by Mesh/Refine or Mesh/Order at (", 0), 0U);
  }
  const Mesh four = refined(box(ElementType::quad4));
  EXPECT_EQ(elementName(four, 15), "a child of element 4 of the mesh (block \"box\")");
  EXPECT_EQ(nodeName(four, 9), "a node made by Mesh/Refine or Mesh/Order at (0.25, 0)");
}

TEST(Refinement, PutsNewNodesOntoTheCurveOfQuadraticEdges) {
  Mesh mesh = box(ElementType::quad9, 1);
  // A parabola, which quadratic edges hold exactly.
  const auto bend = [](const base::Vector3& x) { return base::Vector3{x[0], x[1] + 0.3 * x[0] * x[0], 0.0}; };
  for (base::Vector3& x : mesh.nodes) x = bend(x);
  const Mesh fine = refined(mesh);
  Mesh straight = refined(box(ElementType::quad9, 1));
  ASSERT_EQ(fine.nodes.size(), straight.nodes.size());
  for (std::size_t i = 0; i < fine.nodes.size(); ++i) {
    EXPECT_LT(base::distance(fine.nodes[i], bend(straight.nodes[i])), 1e-14);
  }
}

TEST(Refinement, PutsNodesIntoSetsOnTheSurfaceAndInWholeElementsOnly) {
  Mesh mesh = box(ElementType::hex8, 1);
  const auto set = [&](const std::string& name, const auto& isIn) {
    NodeSet result{name, 1, {}};
    for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i) {
      if (isIn(mesh.nodes[i])) result.node.push_back(i);
    }
    mesh.nodeSets.push_back(result);
  };
  set("bottom", [](const auto& x) { return x[2] == 0.0; });
  set("edge", [](const auto& x) { return x[2] == 0.0 && x[1] == 0.0; });
  set("opposite edges", [](const auto& x) { return (x[2] == 0.0) == (x[1] == 0.0); });
  set("volume", [](const auto&) { return true; });
  const Mesh fine = refined(mesh);
  EXPECT_EQ(fine.nodeSets[0].node.size(), 9U);
  EXPECT_EQ(fine.nodeSets[1].node.size(), 3U);
  EXPECT_EQ(fine.nodeSets[2].node.size(), 6U);
  EXPECT_EQ(fine.nodeSets[3].node.size(), 27U);
  const Mesh quadratic = raised(mesh);
  EXPECT_EQ(quadratic.nodeSets[0].node.size(), 8U);
  EXPECT_EQ(quadratic.nodeSets[1].node.size(), 3U);
  EXPECT_EQ(quadratic.nodeSets[2].node.size(), 6U);
  EXPECT_EQ(quadratic.nodeSets[3].node.size(), 20U);
}

TEST(Refinement, KeepsBodiesApartThatShareNoNodes) {
  const Mesh mesh = boltedJoint(0.5);
  const Mesh quadratic = raised(mesh);
  for (std::size_t block = 0; block < mesh.blocks.size(); ++block) {
    const auto& nodes = quadratic.blocks[block].connectivity;
    const std::set<int> own(nodes.begin(), nodes.end());
    for (std::size_t other = 0; other < block; ++other) {
      for (const int node : quadratic.blocks[other].connectivity) ASSERT_EQ(own.count(node), 0U);
    }
  }
  for (std::size_t s = 0; s < mesh.sideSets.size(); ++s) {
    EXPECT_EQ(quadratic.sideSets[s].element, mesh.sideSets[s].element);
    EXPECT_NEAR(areaOf(quadratic, facesOf(quadratic, quadratic.sideSets[s])),
                areaOf(mesh, facesOf(mesh, mesh.sideSets[s])), 1e-9);
  }
}

TEST(Refinement, GeneratorsPutQuadraticNodesOntoTheirCurves) {
  // Plane faces: the area of the head's ring tells how round it is. 12 straight edges per turn at half refinement.
  const auto ring = [](const Mesh& mesh) {
    const auto found = std::find_if(mesh.sideSets.begin(), mesh.sideSets.end(),
                                    [](const SideSet& set) { return set.name == "head_1_cover_1"; });
    return areaOf(mesh, facesOf(mesh, *found));
  };
  const double exact = 3.14159265358979323846 * (100.0 - 36.0);
  EXPECT_GT(std::abs(ring(boltedJoint(0.5)) / exact - 1.0), 0.03);
  EXPECT_LT(std::abs(ring(boltedJoint(0.5, ElementType::hex20)) / exact - 1.0), 5e-4);
}

TEST(Refinement, RefusesPyramids) {
  EXPECT_THROW(refined(box(ElementType::pyramid5)), base::Error);
  EXPECT_THROW(raised(box(ElementType::pyramid5)), base::Error);
}

}  // namespace
}  // namespace harmos::mesh
