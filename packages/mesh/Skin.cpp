#include <harmos/mesh/Skin.hpp>

#include <algorithm>
#include <array>
#include <tuple>

namespace harmos::mesh {
namespace {

struct Candidate {
  std::array<int, 4> key;  // node numbers, ascending
  int element;
  int side;
};

}  // namespace

std::vector<Face> skin(const Elements& mesh, const std::vector<int>& elements) {
  std::vector<Candidate> candidates;
  for (const int element : elements) {
    const ElementType type = mesh.type(element);
    const int* nodes = mesh.nodes(element);
    for (int side = 0; side < sidesPerElement(type); ++side) {
      Candidate candidate{{-1, -1, -1, -1}, element, side};
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
