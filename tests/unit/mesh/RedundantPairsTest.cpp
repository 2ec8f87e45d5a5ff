#include <gtest/gtest.h>

#include <map>
#include <set>

#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/InterfaceFinder.hpp>
#include <harmos/mesh/Partition.hpp>
#include <harmos/mesh/RedundantPairs.hpp>

namespace harmos::mesh {
namespace {

/// Two stacked boxes, each cut into four pieces, and the contact between them.
class CutBoxes : public ::testing::Test {
 protected:
  CutBoxes() : mesh(boxes({{"lower", {0, 0, 0}, {4, 4, 2}, {4, 4, 2}}, {"upper", {0, 0, 2}, {4, 4, 4}, {4, 4, 2}}})) {
    for (const char* name : {"lower", "upper"}) {
      for (Piece& piece : cutPart(mesh, makePiece(mesh, name, {name}), 4)) pieces.push_back(std::move(piece));
    }
    const InterfaceFinder finder(mesh, pieces);
    surfaces = finder.betweenParts("contact", "lower", "upper");
    for (InterfaceSurface& cut : finder.cuts()) surfaces.push_back(std::move(cut));
    carriers = mergeRedundantPairs(pieces, mesh.dimension, surfaces);
  }

  int meshNode(int piece, int node) const { return pieces[piece].nodes[node]; }
  bool carries(std::size_t s, std::size_t p) const {
    return carriers[s][p].surface == static_cast<int>(s) && carriers[s][p].pair == static_cast<int>(p);
  }

  Mesh mesh;
  std::vector<Piece> pieces;
  std::vector<InterfaceSurface> surfaces;
  std::vector<std::vector<PairCarrier>> carriers;
};

TEST_F(CutBoxes, EveryContactNodeHasOneCarrierAndTheAreaOfTheUncutContact) {
  std::set<int> nodes;
  double area = 0.0;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (surfaces[s].name != "contact") continue;
    for (int p = 0; p < surfaces[s].pairs(); ++p) {
      EXPECT_GE(carriers[s][p].surface, 0);
      if (!carries(s, p)) continue;
      EXPECT_TRUE(nodes.insert(meshNode(surfaces[s].piece1, surfaces[s].trace1.node(p))).second);
      area += surfaces[s].area[p];
    }
  }
  EXPECT_EQ(nodes.size(), 25u);
  EXPECT_NEAR(area, 16.0, 1e-12);  // sums of a few dozen terms
}

// Such points have no copies: what each feels is its own.
TEST_F(CutBoxes, PairsThatFeelSeveralNodesKeepTheirUnknowns) {
  std::vector<InterfaceSurface> mixed = surfaces;
  for (InterfaceSurface& surface : mixed) {
    if (surface.name != "contact") continue;
    surface.trace2 = {};
    for (int p = 0; p < surface.pairs(); ++p) surface.trace2.append({{0, 0.5}, {1, 0.5}});
  }
  const auto found = mergeRedundantPairs(pieces, mesh.dimension, mixed);
  for (std::size_t s = 0; s < mixed.size(); ++s) {
    for (std::size_t p = 0; p < found[s].size(); ++p) {
      if (mixed[s].name == "contact") {
        EXPECT_EQ(found[s][p].surface, static_cast<int>(s));
        EXPECT_EQ(found[s][p].pair, static_cast<int>(p));
        EXPECT_EQ(mixed[s].area[p], surfaces[s].area[p]);
      } else {
        EXPECT_EQ(found[s][p].surface, carriers[s][p].surface);
      }
    }
  }
}

TEST_F(CutBoxes, PiecesThatShareANodeAreTiedOnce) {
  std::map<int, int> copies;
  for (const Piece& piece : pieces) {
    for (const int node : piece.nodes) ++copies[node];
  }
  std::map<int, int> ties;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (surfaces[s].name == "contact") continue;
    for (int p = 0; p < surfaces[s].pairs(); ++p) {
      if (carries(s, p)) ++ties[meshNode(surfaces[s].piece1, surfaces[s].trace1.node(p))];
    }
  }
  bool meetsThree = false;
  for (const auto& [node, count] : copies) {
    EXPECT_EQ(ties[node], count - 1) << "mesh node " << node;
    meetsThree = meetsThree || count > 2;
  }
  EXPECT_TRUE(meetsThree);
}

/// A box whose halves are parts of their own that share the nodes between them.
TEST(RedundantPairs, PartsThatShareNodesBothHaveTheirs) {
  Mesh mesh = boxes({{"left", {0, 0, 0}, {4, 4, 2}, {4, 4, 2}}});
  ElementBlock right = mesh.blocks[0];
  const auto half = static_cast<std::ptrdiff_t>(right.connectivity.size() / 2);
  right.name = "right";
  right.id = 2;
  right.connectivity.erase(right.connectivity.begin(), right.connectivity.begin() + half);
  mesh.blocks[0].connectivity.resize(half);
  mesh.blocks.push_back(right);
  const std::vector<Piece> pieces{makePiece(mesh, "left", {"left"}), makePiece(mesh, "right", {"right"})};
  const InterfaceFinder finder(mesh, pieces);
  std::vector<InterfaceSurface> surfaces = finder.onSideSet("held", "left_xmin");
  ASSERT_EQ(surfaces.size(), 2u) << "the halves are above each other";
  const auto shared = surfaces;
  const auto carriers = mergeRedundantPairs(pieces, mesh.dimension, surfaces);
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    EXPECT_EQ(surfaces[s].pairs(), 10);
    EXPECT_EQ(surfaces[s].area, shared[s].area);
    for (std::size_t p = 0; p < carriers[s].size(); ++p) {
      EXPECT_EQ(carriers[s][p].surface, static_cast<int>(s));
      EXPECT_EQ(carriers[s][p].pair, static_cast<int>(p));
    }
  }
}

}  // namespace
}  // namespace harmos::mesh
