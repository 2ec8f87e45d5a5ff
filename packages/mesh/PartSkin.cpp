#include <harmos/mesh/detail/PartSkin.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>

#include <harmos/base/Vector3.hpp>

namespace harmos::mesh {
namespace {

constexpr double margin = 0.01;  // of the size of a face

}  // namespace

PartSkin::PartSkin(const Mesh& mesh, std::vector<Face> faces)
    : faces_(std::move(faces)), tree_(boxesOf(mesh, faces_)) {}

std::vector<std::pair<PartSkin::Box, int>> PartSkin::boxesOf(const Mesh& mesh, const std::vector<Face>& faces) {
  std::vector<std::pair<Box, int>> boxes;
  for (const Face& face : faces) {
    base::Vector3 lower = mesh.nodes[face.nodes[0]], upper = lower;
    double size = 0.0;
    for (const int node : face.nodes) {
      for (std::size_t c = 0; c < 3; ++c) {
        lower[c] = std::min(lower[c], mesh.nodes[node][c]);
        upper[c] = std::max(upper[c], mesh.nodes[node][c]);
        size = std::max(size, upper[c] - lower[c]);
      }
    }
    const double by = margin * size;
    boxes.emplace_back(
        Box(Corner(lower[0] - by, lower[1] - by, lower[2] - by), Corner(upper[0] + by, upper[1] + by, upper[2] + by)),
        static_cast<int>(boxes.size()));
  }
  return boxes;
}

std::vector<Face> PartSkin::near(const PartSkin& other) const {
  std::vector<Face> result;
  if (other.faces_.empty()) return result;
  std::vector<std::pair<Box, int>> found;
  tree_.query(boost::geometry::index::intersects(other.tree_.bounds()), std::back_inserter(found));
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  for (const auto& [box, face] : found) result.push_back(faces_[face]);
  return result;
}

}  // namespace harmos::mesh
