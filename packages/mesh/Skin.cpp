#include <harmos/mesh/Skin.hpp>

#include <algorithm>
#include <array>
#include <tuple>

namespace harmos::mesh {
namespace {

constexpr std::size_t mostNodes = 9;

struct Candidate {
  std::array<int, mostNodes> key;  // node numbers, ascending
  int element;
  int side;
};

}  // namespace

int cornersOfFace(int dimension, std::size_t nodes) {
  if (dimension == 2) return 2;
  return nodes == 3 || nodes == 6 ? 3 : 4;
}

std::vector<Face> skin(const Elements& mesh, const std::vector<int>& elements) {
  std::vector<Candidate> candidates;
  for (const int element : elements) {
    const ElementType type = mesh.type(element);
    const int* nodes = mesh.nodes(element);
    for (int side = 0; side < sidesPerElement(type); ++side) {
      Candidate candidate{{}, element, side};
      candidate.key.fill(-1);
      auto next = candidate.key.begin();
      for (const int local : sideNodes(type, side)) *next++ = nodes[local];
      std::sort(candidate.key.begin(), candidate.key.end());
      candidates.push_back(candidate);
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) { return a.key < b.key; });
  std::vector<Face> faces;
  for (std::size_t begin = 0, end = 0; begin < candidates.size(); begin = end) {
    while (end < candidates.size() && candidates[end].key == candidates[begin].key) ++end;
    if (end - begin > 1) continue;
    const Candidate& only = candidates[begin];
    faces.push_back({only.element, only.side, mesh.side(only.element, only.side)});
  }
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return std::tie(a.element, a.side) < std::tie(b.element, b.side); });
  return faces;
}

}  // namespace harmos::mesh
