#include <harmos/mesh/Skin.hpp>

#include <algorithm>
#include <array>
#include <tuple>

namespace harmos::mesh {
namespace {

constexpr std::size_t mostNodes = 9;

struct Candidate {
  std::array<int, mostNodes> key;  // node numbers, ascending
  int element, side;
  int next;  // of the same chain, or -1
  bool isInner;
};

std::size_t hashOf(const std::array<int, mostNodes>& key) {
  std::size_t hash = 0;
  for (const int node : key) hash = 1099511628211U * (hash ^ static_cast<std::size_t>(node + 1));
  return hash ^ (hash >> 29);
}

}  // namespace

int cornersOfFace(int dimension, std::size_t nodes) {
  if (dimension == 2) return 2;
  return nodes == 3 || nodes == 6 ? 3 : 4;
}

std::vector<Face> skin(const Elements& mesh, const std::vector<int>& elements) {
  std::size_t count = 0, buckets = 1;
  for (const int element : elements) count += static_cast<std::size_t>(sidesPerElement(mesh.type(element)));
  while (buckets < count) buckets *= 2;
  std::vector<int> chains(buckets, -1);  // the last candidate of each
  std::vector<Candidate> candidates;
  candidates.reserve(count);
  for (const int element : elements) {
    const ElementType type = mesh.type(element);
    const int* nodes = mesh.nodes(element);
    for (int side = 0; side < sidesPerElement(type); ++side) {
      Candidate candidate{{}, element, side, -1, false};
      candidate.key.fill(-1);
      auto end = candidate.key.begin();
      for (const int local : sideNodes(type, side)) *end++ = nodes[local];
      std::sort(candidate.key.begin(), end);
      int& chain = chains[hashOf(candidate.key) & (buckets - 1)];
      int known = chain;
      while (known >= 0 && candidates[known].key != candidate.key) known = candidates[known].next;
      if (known >= 0) {
        candidates[known].isInner = true;
        continue;
      }
      candidate.next = chain;
      chain = static_cast<int>(candidates.size());
      candidates.push_back(candidate);
    }
  }
  std::vector<Face> faces;
  for (const Candidate& one : candidates) {
    if (!one.isInner) faces.push_back({one.element, one.side, mesh.side(one.element, one.side)});
  }
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return std::tie(a.element, a.side) < std::tie(b.element, b.side); });
  return faces;
}

std::vector<Face> skinAt(const Elements& mesh, const std::vector<int>& elements, const std::vector<int>& nodes) {
  const auto isOne = [&](int node) { return std::binary_search(nodes.begin(), nodes.end(), node); };
  std::vector<int> around;  // what shares a side with some of the nodes is among them
  for (const int element : elements) {
    const int* own = mesh.nodes(element);
    if (std::any_of(own, own + nodesPerElement(mesh.type(element)), isOne)) around.push_back(element);
  }
  std::vector<Face> faces;
  for (Face& face : skin(mesh, around)) {
    if (std::any_of(face.nodes.begin(), face.nodes.end(), isOne)) faces.push_back(std::move(face));
  }
  return faces;
}

}  // namespace harmos::mesh
