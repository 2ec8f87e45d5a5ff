#include <vector>

#include <gtest/gtest.h>

#include <harmos/assembly/NodeClusters.hpp>

namespace harmos::assembly {
namespace {

using Nodes = std::vector<int>;

Interface between(int body1, const Nodes& nodes1, int body2, const Nodes& nodes2) {
  Interface interface;
  interface.body1 = body1;
  interface.body2 = body2;
  interface.trace1 = mesh::TraceOperator(nodes1);
  interface.trace2 = mesh::TraceOperator(nodes2);
  return interface;
}

Interface onGround(int body, const Nodes& nodes) {
  return between(body, nodes, -1, {});
}

/// Four bodies around an edge, at their nodes 0: a ring of as many of its joints.
std::vector<Interface> aroundAnEdge(int joints) {
  std::vector<Interface> interfaces;
  for (int body = 0; body < joints; ++body) interfaces.push_back(between(body, {0}, (body + 1) % 4, {0}));
  return interfaces;
}

std::vector<NodeClusters::Cluster> clustersOf(const std::vector<Interface>& interfaces, const NodeClusters::Node& held,
                                              int left = -1) {
  return NodeClusters(
             interfaces, [&](int i) { return i != left; }, [&](const NodeClusters::Node& node) { return node == held; })
      .all();
}

constexpr NodeClusters::Node none{-1, -1};

TEST(NodeClusters, HideTractionsWhereTheyCloseInARing) {
  const auto chain = clustersOf(aroundAnEdge(3), none), ring = clustersOf(aroundAnEdge(4), none);
  ASSERT_EQ(chain.size(), 1u);
  EXPECT_EQ(chain[0].nodes, 4);
  EXPECT_EQ(chain[0].links, 3);
  EXPECT_FALSE(chain[0].mayHideTractions());
  ASSERT_EQ(ring.size(), 1u);
  EXPECT_EQ(ring[0].links, 4);
  EXPECT_TRUE(ring[0].mayHideTractions());
  EXPECT_FALSE(clustersOf(aroundAnEdge(4), none, 2).front().mayHideTractions());  // one joint does not count
}

TEST(NodeClusters, HideTractionsWhereTheyEndTwice) {
  std::vector<Interface> interfaces = aroundAnEdge(2);
  interfaces.push_back(onGround(0, {0}));
  EXPECT_FALSE(clustersOf(interfaces, none).front().mayHideTractions());
  EXPECT_TRUE(clustersOf(interfaces, {2, 0}).front().mayHideTractions());
  interfaces.push_back(onGround(2, {0}));
  const auto clusters = clustersOf(interfaces, none);
  EXPECT_EQ(clusters[0].ends, 2);
  EXPECT_TRUE(clusters[0].mayHideTractions());
}

TEST(NodeClusters, ArePairsThatShareNodes) {
  const auto clusters = clustersOf({between(0, {4, 7}, 1, {2, 3}), between(1, {3}, 2, {5})}, none);
  ASSERT_EQ(clusters.size(), 2u);
  EXPECT_EQ(clusters[0].nodes + clusters[1].nodes, 5);
  for (const NodeClusters::Cluster& one : clusters) {
    const bool isChain = one.pairs.size() == 2;
    EXPECT_EQ(one.nodes, isChain ? 3 : 2);
    EXPECT_EQ(one.pairs.front().interface, 0);
    EXPECT_EQ(one.pairs.front().pair, isChain ? 1 : 0);
  }
}

TEST(NodeClusters, AreLeftAsTheyAreWhereTheyAreLarge) {
  std::vector<Interface> interfaces(NodeClusters::mostPairs + 1, onGround(0, {0}));
  EXPECT_FALSE(clustersOf(interfaces, none).front().mayHideTractions());
  interfaces.pop_back();
  EXPECT_TRUE(clustersOf(interfaces, none).front().mayHideTractions());
}

}  // namespace
}  // namespace harmos::assembly
