#include <harmos/files/detail/EntityMatch.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include <harmos/mesh/ElementType.hpp>
#include <harmos/mesh/PointSearch.hpp>

namespace harmos::files {

namespace {

std::string text(const base::Vector3& p) {
  std::ostringstream stream;
  stream << "(" << p[0] << ", " << p[1] << ", " << p[2] << ")";
  return stream.str();
}

const int* nodesOf(const ResultMesh::Block& block, int element) {
  return block.connectivity.data() + static_cast<std::ptrdiff_t>(element) * block.nodesPerElement;
}

const base::Vector3& position(const ResultMesh& mesh, int node) {
  return mesh.nodes[node];
}

std::vector<base::Vector3> centres(const ResultMesh& mesh, const ResultMesh::Block& block) {
  std::vector<base::Vector3> result;
  for (int e = 0; e < block.elements(); ++e) {
    base::Vector3 centre{};
    for (int k = 0; k < block.nodesPerElement; ++k)
      for (std::size_t d = 0; d < 3; ++d) centre[d] += position(mesh, nodesOf(block, e)[k])[d] / block.nodesPerElement;
    result.push_back(centre);
  }
  return result;
}

/// How the nodes of an element are connected, whichever of them it starts with: the nodes around each side of a volume,
/// around the whole of another element.
std::vector<std::vector<int>> loops(const std::string& type, const std::vector<int>& nodes) {
  std::vector<std::vector<int>> result;
  if (const auto known = mesh::elementTypeFromExodus(type, 3, static_cast<int>(nodes.size()))) {
    for (int side = 0; side < mesh::sidesPerElement(*known); ++side) {
      auto& loop = result.emplace_back();
      for (const int k : mesh::sideNodes(*known, side)) loop.push_back(nodes[k]);
    }
  } else {
    result.push_back(nodes);
  }
  for (auto& loop : result) std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  std::sort(result.begin(), result.end());
  return result;
}

/// Matches one block of A with one of B of the same name.
class BlockMatch {
 public:
  BlockMatch(const ResultMesh& meshA, const ResultMesh& meshB, double tolerance, EntityMatch& match)
      : a_(meshA), b_(meshB), tolerance_(tolerance), match_(match) {}

  void run(const ResultMesh::Block& blockA, int firstA, const ResultMesh::Block& blockB, int firstB) {
    const auto centresA = centres(a_, blockA), centresB = centres(b_, blockB);
    const mesh::PointSearch search(centresB);
    std::vector<bool> taken(centresB.size(), false);
    for (int e = 0; e < blockA.elements(); ++e) {
      const auto& centre = centresA[e];
      const int numberInA = firstA + e;
      const auto candidates = search.within(centre, tolerance_);
      const auto found = std::find_if(candidates.begin(), candidates.end(), [&](int candidate) {
        return !taken[candidate] && tryElement(blockA, e, blockB, candidate);
      });
      if (found == candidates.end()) {
        match_.mismatch.push_back("block " + blockA.name + ": no element of the second file fits element " +
                                  std::to_string(numberInA + 1) + " of the first with its centre at " + text(centre));
        return;  // one sentence per block is enough: the others are seldom different
      }
      taken[*found] = true;
      match_.element[numberInA] = firstB + *found;
    }
  }

 private:
  // The element of B whose nodes lie where those of A's element do; remembers the pairs of nodes when all are found.
  bool tryElement(const ResultMesh::Block& blockA, int elementA, const ResultMesh::Block& blockB, int elementB) {
    const int* nodesA = nodesOf(blockA, elementA);
    const int* nodesB = nodesOf(blockB, elementB);
    const int count = blockA.nodesPerElement;
    std::vector<int> partner(count, -1);
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        // Elements may start with another node in the other file; a node once paired keeps its partner.
        const int earlier = match_.node[nodesA[i]];
        if (earlier >= 0 && earlier != nodesB[j]) continue;
        if (distance(position(a_, nodesA[i]), position(b_, nodesB[j])) <= tolerance_) partner[i] = nodesB[j];
      }
      if (partner[i] < 0) return false;
    }
    if (loops(blockA.type, partner) != loops(blockB.type, {nodesB, nodesB + count})) return false;
    for (int i = 0; i < count; ++i) match_.node[nodesA[i]] = partner[i];
    return true;
  }

  const ResultMesh& a_;
  const ResultMesh& b_;
  double tolerance_;
  EntityMatch& match_;
};

void requireSameCount(std::size_t a, std::size_t b, const std::string& what, EntityMatch& match) {
  if (a != b)
    match.mismatch.push_back(std::to_string(a) + " " + what + " in the first file, " + std::to_string(b) +
                             " in the second");
}

template <typename Set, typename Size>
void compareSets(const std::vector<Set>& a, const std::vector<Set>& b, const std::string& kind, Size size,
                 EntityMatch& match) {
  requireSameCount(a.size(), b.size(), kind + "s", match);
  for (const auto& set : a) {
    const auto partner = std::find_if(b.begin(), b.end(), [&](const Set& other) { return other.name == set.name; });
    if (partner == b.end())
      match.mismatch.push_back("the second file has no " + kind + " " + set.name);
    else
      requireSameCount(size(set), size(*partner), "members of " + kind + " " + set.name, match);
  }
}

/// Tells the faces of a side set apart: by element and nodes, because elements may start with another node in the other
/// file; by element and number where the sides of the element are not known.
std::vector<int> faceKey(const ResultMesh& mesh, int element, int side) {
  int first = 0;
  auto block = mesh.blocks.begin();
  for (; element >= first + block->elements(); ++block) first += block->elements();
  const auto known = mesh::elementTypeFromExodus(block->type, mesh.dimension, block->nodesPerElement);
  if (!known || side < 0 || side >= mesh::sidesPerElement(*known)) return {element, side};
  std::vector<int> key{element, -1};
  for (const int k : mesh::sideNodes(*known, side)) key.push_back(nodesOf(*block, element - first)[k]);
  return key;
}

/// The key of a face of A in the numbers of B.
std::vector<int> inB(std::vector<int> key, const EntityMatch& match) {
  key[0] = match.element[key[0]];
  for (std::size_t i = 2; i < key.size(); ++i) key[i] = match.node[key[i]];
  return key;
}

template <typename Set>
const Set& named(const std::string& name, const std::vector<Set>& sets) {
  return *std::find_if(sets.begin(), sets.end(), [&](const Set& set) { return set.name == name; });
}

/// Compares the members of sets that are equally large, of meshes that are equal otherwise.
void compareMembers(const ResultMesh& a, const ResultMesh& b, EntityMatch& match) {
  const auto sorted = [](std::vector<int> key) {
    std::sort(key.begin() + 2, key.end());
    return key;
  };
  for (const auto& set : a.sideSets) {
    const auto& partner = named(set.name, b.sideSets);
    std::multiset<std::vector<int>> faces;
    for (std::size_t i = 0; i < partner.element.size(); ++i)
      faces.insert(sorted(faceKey(b, partner.element[i], partner.side[i])));
    for (std::size_t i = 0; i < set.element.size(); ++i) {
      const auto found = faces.find(sorted(inB(faceKey(a, set.element[i], set.side[i]), match)));
      if (found == faces.end()) {
        match.mismatch.push_back("side set " + set.name + " of the second file lacks side " +
                                 std::to_string(set.side[i] + 1) + " of element " + std::to_string(set.element[i] + 1) +
                                 " of the first");
        break;
      }
      faces.erase(found);
    }
  }
  for (const auto& set : a.nodeSets) {
    const auto& partner = named(set.name, b.nodeSets);
    std::multiset<int> nodes(partner.node.begin(), partner.node.end());
    for (const int node : set.node) {
      const int other = match.node[node];
      if (other < 0) continue;  // of no element
      const auto found = nodes.find(other);
      if (found == nodes.end()) {
        match.mismatch.push_back("node set " + set.name + " of the second file lacks node " + std::to_string(node + 1) +
                                 " of the first");
        break;
      }
      nodes.erase(found);
    }
  }
}

}  // namespace

EntityMatch matchEntities(const ResultMesh& a, const ResultMesh& b, double tolerance) {
  EntityMatch match;
  match.node.assign(a.nodes.size(), -1);
  match.element.assign(a.elements(), -1);
  requireSameCount(a.nodes.size(), b.nodes.size(), "nodes", match);
  requireSameCount(a.blocks.size(), b.blocks.size(), "blocks", match);
  compareSets(
      a.sideSets, b.sideSets, "side set", [](const mesh::SideSet& set) { return set.element.size(); }, match);
  compareSets(
      a.nodeSets, b.nodeSets, "node set", [](const mesh::NodeSet& set) { return set.node.size(); }, match);

  BlockMatch blocks(a, b, tolerance, match);
  int firstA = 0;
  for (const auto& blockA : a.blocks) {
    int firstB = 0;
    const ResultMesh::Block* partner = nullptr;
    for (const auto& blockB : b.blocks) {
      if (blockB.name == blockA.name) {
        partner = &blockB;
        break;
      }
      firstB += blockB.elements();
    }
    if (!partner) {
      match.mismatch.push_back("the second file has no block " + blockA.name);
    } else if (partner->elements() != blockA.elements() || partner->nodesPerElement != blockA.nodesPerElement) {
      match.mismatch.push_back("block " + blockA.name + ": " + std::to_string(blockA.elements()) + " " + blockA.type +
                               " in the first file, " + std::to_string(partner->elements()) + " " + partner->type +
                               " in the second");
    } else {
      blocks.run(blockA, firstA, *partner, firstB);
    }
    firstA += blockA.elements();
  }
  if (match.mismatch.empty()) compareMembers(a, b, match);
  return match;
}

}  // namespace harmos::files
