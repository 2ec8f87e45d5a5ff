#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/BoltedJoint.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/FaceMatching.hpp>
#include <harmos/mesh/Partition.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {
namespace {

bool isConnected(const Mesh& mesh, const Piece& piece) {
  const Elements elements(mesh);
  std::vector<int> reached = {piece.elements.front()};
  std::vector<int> left(piece.elements.begin() + 1, piece.elements.end());
  const auto sides = [&](int element) {
    std::vector<std::vector<int>> keys;
    for (int side = 0; side < sidesPerElement(elements.type(element)); ++side) {
      keys.push_back(elements.side(element, side));
      std::sort(keys.back().begin(), keys.back().end());
    }
    return keys;
  };
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const auto own = sides(reached[i]);
    const auto touches = [&](int other) {
      const auto theirs = sides(other);
      return std::any_of(own.begin(), own.end(),
                         [&](const auto& key) { return std::find(theirs.begin(), theirs.end(), key) != theirs.end(); });
    };
    const auto rest = std::stable_partition(left.begin(), left.end(), [&](int other) { return !touches(other); });
    reached.insert(reached.end(), rest, left.end());
    left.erase(rest, left.end());
  }
  return left.empty();
}

void expectPartition(const Mesh& mesh, const Piece& piece, const std::vector<Piece>& pieces, std::size_t count) {
  ASSERT_EQ(pieces.size(), count);
  std::vector<int> all;
  for (std::size_t p = 0; p < count; ++p) {
    EXPECT_EQ(pieces[p].name, piece.name + "." + std::to_string(p + 1));
    EXPECT_EQ(pieces[p].part, piece.name);
    ASSERT_FALSE(pieces[p].elements.empty());
    EXPECT_TRUE(isConnected(mesh, pieces[p])) << count << " pieces, piece " << p + 1;
    all.insert(all.end(), pieces[p].elements.begin(), pieces[p].elements.end());
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, piece.elements);
}

TEST(Partition, CutsAPlateIntoEvenConnectedPieces) {
  const Mesh mesh = boltedJoint(0.5);
  const Piece plate = makePiece(mesh, "plate", {"centre"});
  for (const int count : {2, 3, 8}) {
    const auto pieces = cutPart(mesh, plate, count);
    expectPartition(mesh, plate, pieces, static_cast<std::size_t>(count));
    for (const Piece& piece : pieces) {
      EXPECT_GT(piece.elements.size() * static_cast<std::size_t>(count), plate.elements.size() * 3 / 4);
    }
    const auto again = cutPart(mesh, plate, count);
    for (std::size_t p = 0; p < pieces.size(); ++p) EXPECT_EQ(pieces[p].elements, again[p].elements);
  }
  EXPECT_EQ(cutPart(mesh, plate, 1)[0].name, "plate");
}

TEST(Partition, CutsEveryElementTypeDownToSingleElements) {
  for (const ElementType type : {ElementType::hex8, ElementType::tet4, ElementType::wedge6, ElementType::pyramid5,
                                 ElementType::quad4, ElementType::tri3}) {
    const Mesh mesh = boxes({{"box", {}, {3.0, 2.0, 1.0}, {3, 2, 1}, type}});
    const Piece piece = makePiece(mesh, "box", {"box"});
    const int elements = mesh.blocks[0].elements();
    for (int count = 2; count <= elements; ++count) {
      expectPartition(mesh, piece, cutPart(mesh, piece, count), static_cast<std::size_t>(count));
    }
  }
}

TEST(Partition, CutsUnconnectedBodiesOneByOne) {
  const Mesh mesh = boxes({{"a", {}, {4.0, 1.0, 1.0}, {8, 1, 1}}, {"b", {5.0, 0.0, 0.0}, {6.0, 1.0, 1.0}, {2, 1, 1}}});
  const Piece both = makePiece(mesh, "both", {"b", "a"});
  expectPartition(mesh, both, cutPart(mesh, both, 2), 2);
  const auto pieces = cutPart(mesh, both, 5);
  expectPartition(mesh, both, pieces, 5);
  EXPECT_EQ(pieces[4].elements, (std::vector<int>{8, 9}));
  const Mesh three = boxes({{"a", {}, {1.0, 1.0, 1.0}, {1, 1, 1}},
                            {"b", {5.0, 0.0, 0.0}, {6.0, 1.0, 1.0}, {1, 1, 1}},
                            {"c", {8.0, 0.0, 0.0}, {9.0, 1.0, 1.0}, {1, 1, 1}}});
  EXPECT_THROW(cutPart(three, makePiece(three, "all", {"a", "b", "c"}), 2), base::Error);
  EXPECT_THROW(cutPart(three, makePiece(three, "all", {"a", "b", "c"}), 4), base::Error);
  EXPECT_THROW(cutPart(three, makePiece(three, "all", {"a", "b", "c"}), 0), base::Error);
}

// Elements at the nodes of a face are in one piece, those of two faces that do not meet may be in two.
TEST(Partition, KeepsElementsAtGivenNodesTogether) {
  for (const ElementType type : {ElementType::hex8, ElementType::tet4, ElementType::wedge6, ElementType::hex20}) {
    const Mesh mesh = boxes({{"box", {}, {4.0, 3.0, 6.0}, {4, 3, 6}, type}});
    const Piece piece = makePiece(mesh, "box", {"box"});
    const Elements elements(mesh);
    std::vector<Together> together(2);
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
      if (mesh.nodes[node][2] == 0.0) together[0].nodes.push_back(static_cast<int>(node));
      if (mesh.nodes[node][2] == 6.0) together[1].nodes.push_back(static_cast<int>(node));
    }
    for (const int count : {2, 3, 5, 8}) {
      const auto pieces = cutPart(mesh, piece, count, together);
      expectPartition(mesh, piece, pieces, static_cast<std::size_t>(count));
      for (const Together& kept : together) {
        const std::vector<int>& nodes = kept.nodes;
        const auto touches = [&](int element) {
          const int* own = elements.nodes(element);
          return std::any_of(own, own + nodesPerElement(elements.type(element)),
                             [&](int node) { return std::count(nodes.begin(), nodes.end(), node) > 0; });
        };
        const auto holders = std::count_if(pieces.begin(), pieces.end(), [&](const Piece& each) {
          return std::any_of(each.elements.begin(), each.elements.end(), touches);
        });
        EXPECT_EQ(holders, 1) << count << " pieces";
      }
    }
  }
  const Mesh flat = boxes({{"box", {}, {4.0, 3.0, 1.0}, {4, 3, 1}}});
  std::vector<int> all(flat.nodes.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_THROW(cutPart(flat, makePiece(flat, "box", {"box"}), 2, {{all, ""}}), base::Error);
}

// They may weigh as much as many pieces; the others are even all the same.
TEST(Partition, CutsWhatIsNotKeptTogetherEvenly) {
  const Mesh mesh = boxes({{"box", {}, {12.0, 12.0, 12.0}, {12, 12, 12}}});
  const Piece piece = makePiece(mesh, "box", {"box"});
  std::vector<Together> together(1);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    if (mesh.nodes[node][2] <= 3.0) together[0].nodes.push_back(static_cast<int>(node));
  }
  for (const int count : {8, 20}) {
    auto pieces = cutPart(mesh, piece, count, together);
    expectPartition(mesh, piece, pieces, static_cast<std::size_t>(count));
    std::sort(pieces.begin(), pieces.end(),
              [](const Piece& one, const Piece& other) { return one.elements.size() < other.elements.size(); });
    EXPECT_GE(pieces.back().elements.size(), 4u * 144u);
    const double mean = 8.0 * 144.0 / (count - 1);
    EXPECT_GE(pieces.front().elements.size(), 0.8 * mean) << count << " pieces";
    EXPECT_LE(pieces[static_cast<std::size_t>(count) - 2].elements.size(), 1.2 * mean) << count << " pieces";
  }
}

// Not even a piece of its own.
TEST(Partition, LeavesTheLittleThatIsEnclosedToWhatIsKeptTogether) {
  const Mesh mesh = boxes({{"box", {}, {12.0, 12.0, 12.0}, {12, 12, 12}}});
  std::vector<Together> together(1);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    if (mesh.nodes[node][2] >= 2.0 && mesh.nodes[node][2] <= 4.0) together[0].nodes.push_back(static_cast<int>(node));
  }
  const auto pieces = cutPart(mesh, makePiece(mesh, "box", {"box"}), 4, together);
  ASSERT_EQ(pieces.size(), 4u);
  for (const Piece& piece : pieces) EXPECT_GE(piece.elements.size(), 300u);  // the lowest layer has 144
}

TEST(Piece, NamesUnknownAndRepeatedBlocks) {
  const Mesh mesh = boxes({{"plate", {}, {1.0, 1.0, 1.0}, {1, 1, 1}}});
  try {
    makePiece(mesh, "cover", {"plat"});
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_NE(std::string(error.what()).find("Did you mean \"plate\"?"), std::string::npos) << error.what();
  }
  EXPECT_THROW(makePiece(mesh, "cover", {"plate", "plate"}), base::Error);
  const Piece piece = makePiece(mesh, "cover", {"plate"});
  EXPECT_EQ(localNode(piece, 7), 7);
  EXPECT_EQ(localNode(piece, 8), -1);
}

}  // namespace
}  // namespace harmos::mesh
