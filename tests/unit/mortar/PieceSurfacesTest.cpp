#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/RedundantPairs.hpp>
#include <harmos/mortar/PieceSurfaces.hpp>

namespace harmos::mortar {
namespace {

/// A plate and a block on a part of it, with other nodes.
mesh::Mesh plateAndBlock() {
  return mesh::boxes(
      {{"plate", {0.0, 0.0, 0.0}, {2.0, 1.0, 0.5}, {8, 4, 1}}, {"block", {0.3, 0.2, 0.5}, {1.7, 0.9, 1.0}, {5, 3, 1}}});
}

/// The parts, of which the named one is cut in two at x = `at`.
std::vector<mesh::Piece> cutPart(const mesh::Mesh& mesh, const std::string& name, double at) {
  const mesh::Elements elements(mesh);
  std::vector<mesh::Piece> pieces;
  for (const mesh::ElementBlock& block : mesh.blocks) {
    const mesh::Piece part = mesh::makePiece(mesh, block.name, {block.name});
    if (block.name != name) {
      pieces.push_back(part);
      continue;
    }
    std::vector<int> left, right;
    for (const int element : part.elements) {
      const int* nodes = elements.nodes(element);
      const bool isLeft = mesh.nodes[nodes[0]][0] + mesh.nodes[nodes[6]][0] < 2.0 * at;
      (isLeft ? left : right).push_back(element);
    }
    pieces.push_back(mesh::makePiece(mesh, name + ".1", name, left));
    pieces.push_back(mesh::makePiece(mesh, name + ".2", name, right));
  }
  return pieces;
}

Side sideOf(const mesh::Mesh& mesh, const std::string& name) {
  const mesh::Elements elements(mesh);
  Side side{"side set \"" + name + "\"", {}};
  for (const mesh::SideSet& set : mesh.sideSets) {
    if (set.name != name) continue;
    for (std::size_t i = 0; i < set.element.size(); ++i) {
      side.faces.push_back({set.element[i], set.side[i], elements.side(set.element[i], set.side[i])});
    }
  }
  return side;
}

PieceSurfaces divide(const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces, const JoinedSurface& joined) {
  const mesh::Elements elements(mesh);
  const mesh::PieceMap map(mesh, elements, pieces);
  return divideByPieces("seat", joined, sideOf(mesh, "plate_zmax"), sideOf(mesh, "block_zmin"), pieces, map);
}

JoinedSurface join(const mesh::Mesh& mesh, int pointsOn) {
  JoinOptions options;
  options.pointsOn = pointsOn;
  return joinSurfaces("test", mesh, sideOf(mesh, "plate_zmax"), sideOf(mesh, "block_zmin"), options);
}

TEST(PieceSurfaces, AreOneOfWholeParts) {
  const mesh::Mesh mesh = plateAndBlock();
  const auto pieces = cutPart(mesh, "", 0.0);
  for (const int pointsOn : {0, 1}) {
    const JoinedSurface joined = join(mesh, pointsOn);
    const PieceSurfaces divided = divide(mesh, pieces, joined);
    ASSERT_EQ(divided.surfaces.size(), 1u);
    const mesh::InterfaceSurface& surface = divided.surfaces[0];
    EXPECT_EQ(surface.area, joined.area);
    EXPECT_EQ(surface.face, joined.face);
    for (int p = 0; p < surface.pairs(); ++p) {
      for (const auto& [trace, piece] : {std::pair(surface.trace1, 0), std::pair(surface.trace2, 1)}) {
        base::Vector3 place{};
        for (const auto& entry : trace.row(p))
          place = place + entry.weight * mesh.nodes[pieces[piece].nodes[entry.node]];
        EXPECT_NEAR(distance(place, joined.place[p]), 0.0, 1e-12);
      }
    }
  }
}

/// The side with the points may be cut: every point is in one surface, faces at the cut have copies.
TEST(PieceSurfaces, HaveEveryPointOnceWhereTheSideWithThePointsIsCut) {
  const mesh::Mesh mesh = plateAndBlock();
  const auto pieces = cutPart(mesh, "plate", 1.0);
  const JoinedSurface joined = join(mesh, 0);
  PieceSurfaces divided = divide(mesh, pieces, joined);
  ASSERT_EQ(divided.surfaces.size(), 2u);
  std::set<int> points;
  std::size_t faces = 0;
  int copies = 0;
  double area = 0.0;
  for (const mesh::InterfaceSurface& surface : divided.surfaces) {
    faces += surface.face.size();
    EXPECT_EQ(surface.piece2, 2);
    for (int p = 0; p < surface.pairs(); ++p) {
      area += surface.area[p];
      if (surface.area[p] == 0.0) {
        ++copies;
        EXPECT_EQ(surface.trace1.row(p).begin(), surface.trace1.row(p).end());
      } else {
        EXPECT_TRUE(points.insert(surface.point[p]).second);
      }
    }
  }
  EXPECT_EQ(points.size(), joined.node.size());
  EXPECT_EQ(faces, joined.face.size());
  EXPECT_GT(copies, 0);
  EXPECT_NEAR(area, 1.4 * 0.7, 1e-12);

  const auto carriers = mesh::mergeRedundantPairs(pieces, 3, divided.surfaces);
  for (std::size_t s = 0; s < 2; ++s) {
    for (int p = 0; p < divided.surfaces[s].pairs(); ++p) {
      const mesh::PairCarrier& carrier = carriers[s][p];
      ASSERT_GE(carrier.surface, 0);
      EXPECT_GT(divided.surfaces[carrier.surface].area[carrier.pair], 0.0);
      EXPECT_EQ(divided.surfaces[carrier.surface].point[carrier.pair], divided.surfaces[s].point[p]);
    }
  }
}

TEST(PieceSurfaces, CountPointsWhoseNodesAreInSeveralPieces) {
  const mesh::Mesh mesh = plateAndBlock();
  const PieceSurfaces divided = divide(mesh, cutPart(mesh, "block", 1.0), join(mesh, 0));
  EXPECT_EQ(divided.crossed[0], 0);
  EXPECT_GE(divided.crossed[1], 4);
  EXPECT_NEAR(divided.firstCrossed[0], 1.0, 0.3);
  EXPECT_TRUE(divided.surfaces.empty());
}

}  // namespace
}  // namespace harmos::mortar
