#include <harmos/output/EntityMatch.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <harmos/mesh/PointSearch.hpp>

namespace harmos::output {

namespace {

using mesh::Point;

std::string text(const Point& p) {
  std::ostringstream stream;
  stream << "(" << p[0] << ", " << p[1] << ", " << p[2] << ")";
  return stream.str();
}

double distance(const Point& p, const Point& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

const int* nodesOf(const ResultMesh::Block& block, int element) {
  return block.connectivity.data() + static_cast<std::ptrdiff_t>(element) * block.nodesPerElement;
}

const Point& position(const ResultMesh& mesh, int node) {
  return mesh.nodes[static_cast<std::size_t>(node)];
}

std::vector<Point> centres(const ResultMesh& mesh, const ResultMesh::Block& block) {
  std::vector<Point> result;
  for (int e = 0; e < block.elements(); ++e) {
    Point centre{};
    for (int k = 0; k < block.nodesPerElement; ++k)
      for (std::size_t d = 0; d < 3; ++d) centre[d] += position(mesh, nodesOf(block, e)[k])[d] / block.nodesPerElement;
    result.push_back(centre);
  }
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
      const auto& centre = centresA[static_cast<std::size_t>(e)];
      const int numberInA = firstA + e;
      const auto candidates = search.within(centre, tolerance_);
      const auto found = std::find_if(candidates.begin(), candidates.end(), [&](int candidate) {
        return !taken[static_cast<std::size_t>(candidate)] && tryElement(blockA, e, blockB, candidate);
      });
      if (found == candidates.end()) {
        match_.mismatch.push_back("block " + blockA.name + ": no element of the second file fits element " +
                                  std::to_string(numberInA + 1) + " of the first with its centre at " + text(centre));
        return;  // one sentence per block is enough: the others are seldom different
      }
      taken[static_cast<std::size_t>(*found)] = true;
      match_.element[static_cast<std::size_t>(numberInA)] = firstB + *found;
    }
  }

 private:
  // The element of B whose nodes lie where those of A's element do; remembers the pairs of nodes when all are found.
  bool tryElement(const ResultMesh::Block& blockA, int elementA, const ResultMesh::Block& blockB, int elementB) {
    const int* nodesA = nodesOf(blockA, elementA);
    const int* nodesB = nodesOf(blockB, elementB);
    const int count = blockA.nodesPerElement;
    std::vector<int> partner(static_cast<std::size_t>(count), -1);
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        // Elements may start with another node in the other file; a node once paired keeps its partner.
        const int earlier = match_.node[static_cast<std::size_t>(nodesA[i])];
        if (earlier >= 0 && earlier != nodesB[j]) continue;
        if (distance(position(a_, nodesA[i]), position(b_, nodesB[j])) <= tolerance_)
          partner[static_cast<std::size_t>(i)] = nodesB[j];
      }
      if (partner[static_cast<std::size_t>(i)] < 0) return false;
    }
    for (int i = 0; i < count; ++i)
      match_.node[static_cast<std::size_t>(nodesA[i])] = partner[static_cast<std::size_t>(i)];
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

}  // namespace

EntityMatch matchEntities(const ResultMesh& a, const ResultMesh& b, double tolerance) {
  EntityMatch match;
  match.node.assign(a.nodes.size(), -1);
  match.element.assign(static_cast<std::size_t>(a.elements()), -1);
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
  return match;
}

}  // namespace harmos::output
