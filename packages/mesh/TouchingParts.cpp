#include <harmos/mesh/TouchingParts.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include <harmos/mesh/FaceMatching.hpp>
#include <harmos/mesh/detail/FaceOverlap.hpp>
#include <harmos/mesh/detail/PartSkin.hpp>

namespace harmos::mesh {
namespace {

namespace geometry = boost::geometry;
using Corner = geometry::model::point<double, 3, geometry::cs::cartesian>;
using Box = geometry::model::box<Corner>;

// Of the size of a box: faces that lie on each other may be a little apart.
constexpr double margin = 0.05;

/// What is asked of a part: elements, and once it comes near another the skin.
class Part {
 public:
  void add(const Mesh& mesh, const Piece& piece) {
    elements_.insert(elements_.end(), piece.elements.begin(), piece.elements.end());
    for (const int node : piece.nodes) {
      const base::Vector3& x = mesh.nodes[node];
      for (int c = 0; c < 3; ++c) {
        lower_[c] = isEmpty_ ? x[c] : std::min(lower_[c], x[c]);
        upper_[c] = isEmpty_ ? x[c] : std::max(upper_[c], x[c]);
      }
      isEmpty_ = false;
    }
  }
  Box box() const {
    double size = 0.0;
    for (int c = 0; c < 3; ++c) size = std::max(size, upper_[c] - lower_[c]);
    const double by = margin * size;
    return {Corner(lower_[0] - by, lower_[1] - by, lower_[2] - by),
            Corner(upper_[0] + by, upper_[1] + by, upper_[2] + by)};
  }
  const PartSkin& skin(const Mesh& mesh, const Elements& elements) {
    if (!skin_) skin_.emplace(mesh, mesh::skin(elements, elements_));
    return *skin_;
  }

 private:
  std::vector<int> elements_;
  base::Vector3 lower_{}, upper_{};
  bool isEmpty_ = true;
  std::optional<PartSkin> skin_;
};

bool haveCommonFaces(const Mesh& mesh, const PartSkin& part1, const PartSkin& part2) {
  const std::vector<Face> skin1 = part1.near(part2), skin2 = part2.near(part1);
  const auto pairs = matchFaces(mesh, skin1, skin2);
  return !pairs.empty() || !findOverlap(mesh, skin1, skin2, pairs).faces1.empty();
}

}  // namespace

std::vector<PartPair> touchingParts(const Mesh& mesh, const std::vector<Piece>& pieces,
                                    const std::vector<std::string>& parts1, const std::vector<std::string>& parts2) {
  const Elements elements(mesh);
  std::map<std::string, Part> parts;
  for (const Piece& piece : pieces) parts[piece.part].add(mesh, piece);
  std::vector<std::pair<Box, int>> boxes;  // position in parts2
  for (std::size_t j = 0; j < parts2.size(); ++j) boxes.emplace_back(parts.at(parts2[j]).box(), static_cast<int>(j));
  const geometry::index::rtree<std::pair<Box, int>, geometry::index::quadratic<16>> tree(boxes);
  std::vector<PartPair> pairs;
  std::set<PartPair> seen;
  for (const std::string& first : parts1) {
    std::vector<std::pair<Box, int>> near;
    tree.query(geometry::index::intersects(parts.at(first).box()), std::back_inserter(near));
    std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    for (const auto& [box, position] : near) {
      const std::string& second = parts2[position];
      if (first == second || !seen.insert(std::minmax(first, second)).second) continue;
      if (haveCommonFaces(mesh, parts.at(first).skin(mesh, elements), parts.at(second).skin(mesh, elements))) {
        pairs.emplace_back(first, second);
      }
    }
  }
  return pairs;
}

}  // namespace harmos::mesh
