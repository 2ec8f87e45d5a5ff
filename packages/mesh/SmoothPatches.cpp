#include <harmos/mesh/SmoothPatches.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace harmos::mesh {
namespace {

// Angles of regular meshes are often those that users name; coordinates in files have few digits [degrees].
constexpr double angleRounding = 1e-4;

/// Between two vectors, 0 to 180 [degrees]; 0 if one has no length.
double angleBetween(const base::Vector3& a, const base::Vector3& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b)) * 180.0 / std::acos(-1.0);
}

/// Numbers of the groups that `areJoined` makes of 0, ..., count - 1, by their first members.
template <typename Joined>
std::vector<int> groups(std::size_t count, const Joined& areJoined) {
  std::vector<int> group(count);
  std::iota(group.begin(), group.end(), 0);
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (group[i] == group[j] || !areJoined(i, j)) continue;
      const auto [kept, lost] = std::minmax({group[i], group[j]});
      for (std::size_t k = 0; k <= i; ++k) {
        if (group[k] == lost) group[k] = kept;
      }
    }
  }
  std::map<int, int> number;
  for (int& one : group) one = number.emplace(one, static_cast<int>(number.size())).first->second;
  return group;
}

}  // namespace

std::vector<std::vector<int>> smoothPatches(const std::vector<OrientedFace>& faces, double creaseAngle) {
  struct Corner {
    std::size_t face, corner;
  };
  std::map<NodePair, std::vector<Corner>> around;
  std::vector<std::vector<int>> patch;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    patch.emplace_back(faces[f].pairs.size(), 0);
    for (std::size_t i = 0; i < faces[f].pairs.size(); ++i) around[faces[f].pairs[i]].push_back({f, i});
  }
  for (const auto& [pair, corners] : around) {
    const auto found = groups(corners.size(), [&, &corners = corners](std::size_t i, std::size_t j) {
      return angleBetween(faces[corners[i].face].normal, faces[corners[j].face].normal) <= creaseAngle + angleRounding;
    });
    for (std::size_t i = 0; i < corners.size(); ++i) patch[corners[i].face][corners[i].corner] = found[i];
  }
  return patch;
}

}  // namespace harmos::mesh
