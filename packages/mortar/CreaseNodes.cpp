#include <harmos/mortar/detail/CreaseNodes.hpp>

#include <algorithm>
#include <optional>

namespace harmos::mortar {
namespace {

using Points = std::vector<std::vector<PointKey>>;
using FacesOfPoints = std::map<PointKey, std::vector<int>>;

std::optional<PointKey> keptOf(const std::vector<PointKey>& points, const std::set<PointKey>& kept) {
  const auto found = std::find_if(points.begin(), points.end(), [&](const PointKey& p) { return kept.count(p) > 0; });
  return found == points.end() ? std::nullopt : std::optional(*found);
}

/// A point of the neighbour that shares most points with a face.
std::optional<PointKey> pointBeside(int face, const Points& points, const FacesOfPoints& facesOf,
                                    const std::set<PointKey>& kept) {
  std::map<int, int> shared;  // points, by neighbour
  for (const PointKey& point : points[face]) {
    for (const int neighbour : facesOf.at(point)) ++shared[neighbour];
  }
  std::optional<PointKey> best;
  int most = 0;
  for (const auto& [neighbour, count] : shared) {
    if (count <= most) continue;
    const auto candidate = keptOf(points[neighbour], kept);
    if (!candidate) continue;
    best = candidate;
    most = count;
  }
  return best;
}

}  // namespace

SmoothPoints withoutCreases(const Points& points) {
  FacesOfPoints facesOf;
  for (std::size_t face = 0; face < points.size(); ++face) {
    for (const PointKey& point : points[face]) facesOf[point].push_back(static_cast<int>(face));
  }
  std::map<int, int> patches;  // by node
  for (const auto& [point, faces] : facesOf) ++patches[point.first];
  SmoothPoints result;
  for (const auto& [point, faces] : facesOf) {
    if (patches[point.first] == 1) result.kept.insert(point);
  }
  for (std::size_t face = 0; face < points.size(); ++face) {
    if (points[face].empty() || keptOf(points[face], result.kept)) continue;
    if (const auto beside = pointBeside(static_cast<int>(face), points, facesOf, result.kept)) {
      result.adopted.emplace(static_cast<int>(face), *beside);
    } else {
      result.kept.insert(points[face].front());
    }
  }
  return result;
}

}  // namespace harmos::mortar
