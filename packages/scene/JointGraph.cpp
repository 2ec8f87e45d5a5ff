#include <harmos/scene/detail/JointGraph.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <harmos/assembly/NodeClusters.hpp>
#include <harmos/base/DisjointSets.hpp>

namespace harmos::scene {
namespace {

using assembly::Interface;

/// Carries pressure, perhaps with friction, and no tension.
bool presses(const Interface& interface) {
  if (interface.law->prescribesTraction() || interface.law->isAffine() || interface.pairs() == 0) return false;
  const auto tractions = interface.law->admissibleTractions(0);
  return tractions && tractions->upper[0] == 0.0;
}

/// Neighbours of all groups of bodies, those of single bodies at their representatives.
using Neighbours = std::vector<std::set<int>>;

Neighbours neighboursOf(const std::vector<Interface>& interfaces, const std::vector<std::string>& parts,
                        base::DisjointSets& bodies) {
  std::map<std::string, int> first;
  for (std::size_t b = 0; b < parts.size(); ++b) {
    const int body = static_cast<int>(b);
    bodies.join(body, first.try_emplace(parts[b], body).first->second);
  }
  for (const Interface& interface : interfaces) {
    if (interface.sides() == 2 && interface.law->isAffine()) bodies.join(interface.body1, interface.body2);
  }
  Neighbours near(parts.size());
  for (const Interface& interface : interfaces) {
    if (interface.sides() != 2 || !presses(interface)) continue;
    const int a = bodies.root(interface.body1), b = bodies.root(interface.body2);
    if (a == b) continue;
    near[a].insert(b);
    near[b].insert(a);
  }
  return near;
}

/// Which groups are left when those with a single neighbour are taken away again and again: those in loops, and between
/// them.
std::vector<bool> inLoops(const Neighbours& near) {
  std::vector<std::size_t> degree;
  std::vector<int> ends;
  std::vector<bool> isLeft(near.size(), true);
  for (std::size_t b = 0; b < near.size(); ++b) {
    degree.push_back(near[b].size());
    if (degree[b] < 2) ends.push_back(static_cast<int>(b));
  }
  while (!ends.empty()) {
    const int end = ends.back();
    ends.pop_back();
    isLeft[end] = false;
    for (const int other : near[end]) {
      if (isLeft[other] && --degree[other] == 1) ends.push_back(other);
    }
  }
  return isLeft;
}

/// Joints from the ground to every group, that of what is held by itself counted; 0: nothing leads there.
std::vector<int> heights(const std::vector<Interface>& interfaces, const Neighbours& near, base::DisjointSets& bodies) {
  std::vector<int> height(near.size(), 0);
  std::vector<int> front;
  for (const Interface& interface : interfaces) {
    if (interface.sides() != 1 || interface.law->prescribesTraction()) continue;
    const int body = bodies.root(interface.body1);
    if (height[body] == 0) front.push_back(body);
    height[body] = 1;
  }
  while (!front.empty()) {
    std::vector<int> next;
    for (const int body : front) {
      for (const int other : near[body]) {
        if (height[other] > 0) continue;
        height[other] = height[body] + 1;
        next.push_back(other);
      }
    }
    front.swap(next);
  }
  return height;
}

/// How many groups of nodes that pairs with friction link hang together in a ring, or at two ends that are held.
double sharedNodes(const std::vector<Interface>& interfaces) {
  using assembly::NodeClusters;
  std::set<NodeClusters::Node> held;
  for (const Interface& interface : interfaces) {
    if (interface.sides() != 1 || interface.law->prescribesTraction() || presses(interface)) continue;
    for (int p = 0; p < interface.pairs(); ++p) {
      for (const auto& [node, weight] : interface.trace1.row(p)) held.emplace(interface.body1, node);
    }
  }
  const NodeClusters clusters(
      interfaces, [&](int i) { return presses(interfaces[i]) && interfaces[i].mass.empty(); },
      [&](const NodeClusters::Node& node) { return held.count(node) > 0; });
  const auto hasFriction = [&](const NodeClusters::Pair& pair) {
    return interfaces[pair.interface].law->admissibleTractions(0)->friction > 0.0;
  };
  return static_cast<double>(std::count_if(clusters.all().begin(), clusters.all().end(), [&](const auto& one) {
    return one.mayHideTractions() && std::any_of(one.pairs.begin(), one.pairs.end(), hasFriction);
  }));
}

/// Points along the longest side of the box around an interface.
double pointsAlong(const Interface& interface, int dimension) {
  if (interface.pairs() < 2) return 1.0;
  base::Vector3 low = interface.position[0], high = low;
  double area = 0.0, longest = 0.0;
  for (int p = 0; p < interface.pairs(); ++p) {
    area += interface.area[p];
    for (std::size_t c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], interface.position[p][c]);
      high[c] = std::max(high[c], interface.position[p][c]);
    }
  }
  for (std::size_t c = 0; c < 3; ++c) longest = std::max(longest, high[c] - low[c]);
  return 1.0 + longest / std::pow(area / interface.pairs(), 1.0 / (dimension - 1));
}

}  // namespace

JointGraph jointGraphOf(const std::vector<Interface>& interfaces, const std::vector<std::string>& parts,
                        int dimension) {
  JointGraph graph;
  for (const Interface& interface : interfaces) {
    if (interface.sides() == 2) graph.points = std::max(graph.points, pointsAlong(interface, dimension));
  }
  base::DisjointSets bodies(parts.size());
  const Neighbours near = neighboursOf(interfaces, parts, bodies);
  const std::vector<bool> isInLoop = inLoops(near);
  const std::vector<int> height = heights(interfaces, near, bodies);
  for (std::size_t b = 0; b < near.size(); ++b) {
    if (isInLoop[b] && !near[b].empty()) graph.height = std::max(graph.height, static_cast<double>(height[b]));
  }
  graph.sharedNodes = sharedNodes(interfaces);
  return graph;
}

}  // namespace harmos::scene
