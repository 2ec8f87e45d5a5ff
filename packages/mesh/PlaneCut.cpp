#include <harmos/mesh/PlaneCut.hpp>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {
namespace {

// Distance of the nodes of a layer of faces from their plane, over the extent of the layer: what meshing leaves.
constexpr double flat = 1e-3;

/// Smallest and largest of some numbers.
struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void include(double x) {
    least = std::min(least, x);
    most = std::max(most, x);
  }
  double width() const { return most - least; }
  std::string text() const {
    std::ostringstream out;
    out << least << " and " << most;
    return out.str();
  }
};

[[noreturn]] void refuse(const std::string& text) {
  throw base::Error(text, base::ExitCode::input);
}

/// Nodes of the faces that two groups of elements share.
std::set<int> nodesOfCommonFaces(const Elements& elements, const std::vector<int>& first,
                                 const std::vector<int>& second) {
  std::set<std::vector<int>> faces;
  const auto key = [](std::vector<int> nodes) {
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  };
  for (const Face& face : skin(elements, first)) faces.insert(key(face.nodes));
  std::set<int> nodes;
  for (const Face& face : skin(elements, second)) {
    if (faces.count(key(face.nodes)) > 0) nodes.insert(face.nodes.begin(), face.nodes.end());
  }
  return nodes;
}

}  // namespace

std::pair<std::vector<int>, std::vector<int>> divideAlong(const Mesh& mesh, const Piece& part, const Plane& plane) {
  const Elements elements(mesh);
  const base::Vector3 normal = (1.0 / base::norm(plane.normal)) * plane.normal;
  const auto height = [&](int node) { return base::dot(mesh.nodes[node] - plane.point, normal); };
  std::vector<int> behind, beyond;
  Range whole;
  for (const int element : part.elements) {
    const int count = nodesPerElement(elements.type(element));
    const int* nodes = elements.nodes(element);
    double sum = 0.0;
    for (int a = 0; a < count; ++a) {
      sum += height(nodes[a]);
      whole.include(height(nodes[a]));
    }
    (sum <= 0.0 ? behind : beyond).push_back(element);
  }
  if (behind.empty() || beyond.empty()) {
    refuse("no layer of element faces of part \"" + part.name +
           "\" is nearest to the plane: along the normal, counted from the point, the part lies between " +
           whole.text() + ".\n  Choose a point inside of the part.");
  }
  const std::set<int> nodes = nodesOfCommonFaces(elements, behind, beyond);
  Range along;
  base::Vector3 lower{}, upper{};
  for (const int node : nodes) {
    along.include(height(node));
    const base::Vector3& x = mesh.nodes[node];
    for (std::size_t c = 0; c < 3; ++c) {
      lower[c] = node == *nodes.begin() ? x[c] : std::min(lower[c], x[c]);
      upper[c] = node == *nodes.begin() ? x[c] : std::max(upper[c], x[c]);
    }
  }
  const Piece other = makePiece(mesh, part.name, part.name, behind);
  const Piece rest = makePiece(mesh, part.name, part.name, beyond);
  const bool isTouchedElsewhere = std::any_of(other.nodes.begin(), other.nodes.end(), [&](int node) {
    return localNode(rest, node) >= 0 && nodes.count(node) == 0;
  });
  if (nodes.empty() || isTouchedElsewhere || along.width() > flat * base::norm(upper - lower)) {
    refuse("the plane cuts through elements of part \"" + part.name + "\" that have no layer of faces there: " +
           (nodes.empty()
                ? std::string("no faces lie near it")
                : "the faces nearest to it lie between " + along.text() + " along the normal, counted from the point") +
           ".\n  Choose a plane between two layers of elements, divide the part there before it is meshed, or give two "
           "parts.");
  }
  return {std::move(behind), std::move(beyond)};
}

}  // namespace harmos::mesh
