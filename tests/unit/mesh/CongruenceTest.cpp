#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/BoltedJoint.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/Congruence.hpp>

namespace harmos::mesh {
namespace {

double determinant(const base::Frame& q) {
  return dot(cross(q[0], q[1]), q[2]);
}

void expectCarries(const Mesh& mesh, const Piece& first, const Piece& second, const Congruence& congruence) {
  const auto place = [&](const Piece& piece, std::size_t node) { return mesh.nodes[piece.nodes[node]]; };
  const auto image = [&](std::size_t a) { return place(second, static_cast<std::size_t>(congruence.node[a])); };
  for (std::size_t a = 1; a < first.nodes.size(); ++a) {
    const base::Vector3 from = place(first, a) - place(first, 0);
    const base::Vector3 to = image(a) - image(0);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(dot(congruence.rotation[i], from), to[i], 1e-8);
  }
  EXPECT_NEAR(std::abs(determinant(congruence.rotation)), 1.0, 1e-12);
}

/// Boxes without symmetry, the second moved by Q and with its nodes and elements shuffled.
struct Pair {
  Mesh mesh;
  Piece first, second;

  Pair(const base::Frame& q, ElementType type) {
    const bool plane = dimensionOf(type) == 2;
    mesh = boxes({{"a", {}, {3.0, 2.0, 1.0}, {3, 2, 2}, type}, {"b", {}, {3.0, 2.0, 1.0}, {3, 2, 2}, type}});
    for (base::Vector3& p : mesh.nodes) {
      p = p + base::Vector3{0.05 * p[1] * p[1], 0.03 * p[0] * p[0] * p[1], plane ? 0.0 : 0.02 * p[0] * p[1] * p[2]};
    }
    const std::size_t half = mesh.nodes.size() / 2;
    std::vector<int> number(mesh.nodes.size());
    for (std::size_t i = 0; i < number.size(); ++i) number[i] = static_cast<int>(i);
    std::mt19937 random(3);
    std::shuffle(number.begin() + static_cast<std::ptrdiff_t>(half), number.end(), random);
    for (std::size_t i = half; i < mesh.nodes.size(); ++i) {
      const base::Vector3& p = mesh.nodes[i - half];
      mesh.nodes[number[i]] =
          base::Vector3{dot(q[0], p), dot(q[1], p), dot(q[2], p)} + base::Vector3{20.0, 5.0, plane ? 0.0 : -3.0};
    }
    auto& connectivity = mesh.blocks[1].connectivity;
    for (int& node : connectivity) node = number[node];
    std::rotate(connectivity.begin(), connectivity.begin() + 2 * nodesPerElement(type), connectivity.end());
    first = makePiece(mesh, "a", {"a"});
    second = makePiece(mesh, "b", {"b"});
  }
};

const double c = std::cos(0.7);
const double s = std::sin(0.7);
const std::vector<base::Frame> planeMotions = {
    base::Frame{base::Vector3{1, 0, 0}, base::Vector3{0, 1, 0}, base::Vector3{0, 0, 1}},
    base::Frame{base::Vector3{0, -1, 0}, base::Vector3{1, 0, 0}, base::Vector3{0, 0, 1}},
    base::Frame{base::Vector3{-1, 0, 0}, base::Vector3{0, 1, 0}, base::Vector3{0, 0, 1}},
    base::Frame{base::Vector3{c, s, 0}, base::Vector3{s, -c, 0}, base::Vector3{0, 0, 1}}};
const std::vector<base::Frame> spaceMotions = {
    base::Frame{base::Vector3{0, 0, 1}, base::Vector3{1, 0, 0}, base::Vector3{0, 1, 0}},
    base::Frame{base::Vector3{1, 0, 0}, base::Vector3{0, 1, 0}, base::Vector3{0, 0, -1}},
    base::Frame{base::Vector3{c, 0, s}, base::Vector3{0, 1, 0}, base::Vector3{-s, 0, c}},
    base::Frame{base::Vector3{0, c, s}, base::Vector3{0, -s, c}, base::Vector3{-1, 0, 0}}};

TEST(Congruence, FindsMotionsAndMirrorImages) {
  for (const ElementType type : {ElementType::hex8, ElementType::tet4, ElementType::wedge6, ElementType::pyramid5,
                                 ElementType::quad4, ElementType::tri3}) {
    auto motions = planeMotions;
    if (dimensionOf(type) == 3) motions.insert(motions.end(), spaceMotions.begin(), spaceMotions.end());
    for (const base::Frame& q : motions) {
      const Pair pair(q, type);
      const auto found = findCongruence(pair.mesh, pair.first, pair.second);
      ASSERT_TRUE(found) << exodusName(type);
      expectCarries(pair.mesh, pair.first, pair.second, *found);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(distance(found->rotation[i], q[i]), 1e-9);
    }
  }
}

TEST(Congruence, FindsTheEqualBodiesOfTheBoltedJoint) {
  const Mesh mesh = boltedJoint();
  const auto piece = [&](const char* block) { return makePiece(mesh, block, {block}); };
  for (const auto& [a, b, turn] :
       {std::tuple("bolt_1", "bolt_2", 1.0), std::tuple("head_1", "head_2", 1.0),
        std::tuple("cover_bottom", "cover_top", 1.0), std::tuple("cover_bottom", "centre", -1.0)}) {
    const auto found = findCongruence(mesh, piece(a), piece(b));
    ASSERT_TRUE(found) << a << " " << b;
    expectCarries(mesh, piece(a), piece(b), *found);
    EXPECT_EQ(found->rotation[0][0], turn) << a << " " << b;
  }
  EXPECT_FALSE(findCongruence(mesh, piece("bolt_1"), piece("head_1")));
}

TEST(Congruence, KeepsTheKindsOfNodes) {
  const Mesh mesh = boltedJoint();
  const Piece lower = makePiece(mesh, "cover_bottom", {"cover_bottom"}),
              upper = makePiece(mesh, "cover_top", {"cover_top"});
  const auto kinds = [&](const Piece& piece, double z) {
    std::vector<int> result;
    for (const int node : piece.nodes) result.push_back(mesh.nodes[node][2] == z ? 1 : 0);
    return result;
  };
  // Both touch the plate between them.
  const std::vector<int> below = kinds(lower, 10.0), above = kinds(upper, 20.0);
  const auto found = findCongruence(mesh, lower, upper, below, above);
  ASSERT_TRUE(found);
  expectCarries(mesh, lower, upper, *found);
  EXPECT_EQ(found->rotation[2][2], -1.0);
  for (std::size_t a = 0; a < below.size(); ++a) EXPECT_EQ(below[a], above[static_cast<std::size_t>(found->node[a])]);
  // As many nodes of each kind, but no motion between them.
  std::vector<int> other = above;
  std::swap(*std::find(other.begin(), other.end(), 0), *std::find(other.begin(), other.end(), 1));
  EXPECT_FALSE(findCongruence(mesh, lower, upper, below, other));
}

TEST(Congruence, SeesASmallDifference) {
  Pair moved(spaceMotions[0], ElementType::hex8);
  moved.mesh.nodes[moved.second.nodes[5]][1] += 1e-6;
  EXPECT_FALSE(findCongruence(moved.mesh, moved.first, moved.second));
  // The same nodes, but cells divided along the other diagonal.
  Mesh mesh = boxes({{"a", {}, {1.0, 1.0, 0.0}, {2, 3, 0}, ElementType::tri3},
                     {"b", {}, {1.0, 1.0, 0.0}, {2, 3, 0}, ElementType::tri3}});
  for (base::Vector3& p : mesh.nodes) p[0] += 0.1 * p[1] + 0.07 * p[0] * p[0];
  auto& connectivity = mesh.blocks[1].connectivity;
  for (std::size_t cell = 0; cell < connectivity.size(); cell += 6) {
    const int n[4] = {connectivity[cell], connectivity[cell + 1], connectivity[cell + 2], connectivity[cell + 5]};
    const int other[6] = {n[0], n[1], n[3], n[1], n[2], n[3]};
    std::copy(other, other + 6, connectivity.begin() + static_cast<std::ptrdiff_t>(cell));
  }
  EXPECT_FALSE(findCongruence(mesh, makePiece(mesh, "a", {"a"}), makePiece(mesh, "b", {"b"})));
}

}  // namespace
}  // namespace harmos::mesh
