#include <harmos/mesh/Interpenetration.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/Elements.hpp>

namespace harmos::mesh {
namespace {

// Of the way from the middle of a face to that of its element: facets of one curved surface deviate by less.
constexpr double beneath = 0.1;
constexpr std::size_t facesAtMost = 500;
constexpr double pi = 3.14159265358979323846;

/// Triangles of a surface in space, or its lines in the plane, whose third corner is not used.
using Simplex = std::array<base::Vector3, 3>;

std::vector<Simplex> simplices(const Mesh& mesh, const std::vector<Face>& skin) {
  std::vector<Simplex> result;
  for (const Face& face : skin) {
    const auto at = [&](int corner) { return mesh.nodes[face.nodes[corner]]; };
    if (mesh.dimension == 2) result.push_back({at(0), at(1), at(1)});
    for (int i = 2; i < cornersOfFace(mesh.dimension, face.nodes.size()); ++i)
      result.push_back({at(0), at(i - 1), at(i)});
  }
  return result;
}

/// Angle [rad], or solid angle [sr], under which a point sees a simplex, with a sign.
double angle(const Simplex& simplex, const base::Vector3& point, int dimension) {
  const base::Vector3 a = simplex[0] - point, b = simplex[1] - point, c = simplex[2] - point;
  if (dimension == 2) return std::atan2(a[0] * b[1] - a[1] * b[0], dot(a, b));
  const double la = norm(a), lb = norm(b), lc = norm(c);
  return 2.0 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

base::Vector3 nearestOnLine(const base::Vector3& a, const base::Vector3& b, const base::Vector3& point) {
  const base::Vector3 along = b - a;
  const double square = dot(along, along);
  const double share = square > 0.0 ? std::clamp(dot(point - a, along) / square, 0.0, 1.0) : 0.0;
  return a + share * along;
}

double distanceTo(const Simplex& simplex, const base::Vector3& point, int dimension) {
  const auto& [a, b, c] = simplex;
  double least = distance(point, nearestOnLine(a, b, point));
  if (dimension == 2) return least;
  least = std::min({least, distance(point, nearestOnLine(b, c, point)), distance(point, nearestOnLine(c, a, point))});
  const base::Vector3 normal = cross(b - a, c - a);
  const double size = norm(normal);
  if (size == 0.0) return least;
  const base::Vector3 foot = point - (dot(point - a, normal) / (size * size)) * normal;
  const auto isWithin = [&](const base::Vector3& from, const base::Vector3& to) {
    return dot(cross(to - from, foot - from), normal) >= 0.0;
  };
  if (isWithin(a, b) && isWithin(b, c) && isWithin(c, a)) least = std::min(least, distance(point, foot));
  return least;
}

base::Vector3 middle(const Mesh& mesh, const int* nodes, int count) {
  base::Vector3 sum{};
  for (int i = 0; i < count; ++i) sum = sum + mesh.nodes[nodes[i]];
  return (1.0 / count) * sum;
}

}  // namespace

Interpenetration interpenetration(const Mesh& mesh, const std::vector<Face>& skin1, const std::vector<Face>& skin2) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  base::Vector3 lower{infinity, infinity, infinity}, upper{-infinity, -infinity, -infinity};
  for (const Face& face : skin2) {
    for (const int node : face.nodes) {
      for (std::size_t c = 0; c < 3; ++c) {
        lower[c] = std::min(lower[c], mesh.nodes[node][c]);
        upper[c] = std::max(upper[c], mesh.nodes[node][c]);
      }
    }
  }
  const Elements elements(mesh);
  std::vector<std::pair<int, base::Vector3>> points;  // with their elements
  for (const Face& face : skin1) {
    const base::Vector3 onFace = middle(mesh, face.nodes.data(), cornersOfFace(mesh.dimension, face.nodes.size()));
    const int corners = nodesPerElement(linearType(elements.type(face.element)));
    const base::Vector3 point = onFace + beneath * (middle(mesh, elements.nodes(face.element), corners) - onFace);
    bool isInBox = true;
    for (std::size_t c = 0; c < 3; ++c) isInBox = isInBox && point[c] >= lower[c] && point[c] <= upper[c];
    if (isInBox) points.emplace_back(face.element, point);
  }
  const std::vector<Simplex> surface = simplices(mesh, skin2);
  const double once = mesh.dimension == 2 ? 2.0 * pi : 4.0 * pi;
  Interpenetration result;
  const std::size_t stride = points.size() / facesAtMost + 1;
  int last = -1;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const auto& [element, point] = points[i];
    double around = 0.0, depth = infinity;
    for (const Simplex& simplex : surface) around += angle(simplex, point, mesh.dimension);
    if (std::abs(around) < 0.5 * once) continue;
    for (const Simplex& simplex : surface) depth = std::min(depth, distanceTo(simplex, point, mesh.dimension));
    if (element != last) ++result.elements;
    last = element;
    if (depth > result.depth) {
      result.depth = depth;
      result.element = element;
      result.place = point;
    }
  }
  return result;
}

void demandNoOverlap(const Mesh& mesh, const std::string& where, const std::string& part1,
                     const std::vector<Face>& skin1, const std::string& part2, const std::vector<Face>& skin2) {
  const Interpenetration first = interpenetration(mesh, skin1, skin2), second = interpenetration(mesh, skin2, skin1);
  const bool isFirst = first.depth >= second.depth;
  const Interpenetration& worse = isFirst ? first : second;
  if (worse.element < 0) return;
  std::ostringstream message;
  message << where << ": parts \"" << part1 << "\" and \"" << part2 << "\" overlap: " << worse.elements
          << (worse.elements == 1 ? " element" : " elements") << " at the surface of part \""
          << (isFirst ? part1 : part2) << "\" " << (worse.elements == 1 ? "reaches" : "reach") << " into part \""
          << (isFirst ? part2 : part1) << "\", farthest " << elementName(mesh, worse.element) << ", by " << worse.depth
          << " at (" << worse.place[0] << ", " << worse.place[1] << ", " << worse.place[2]
          << "). Move or mesh them so that they touch; for an interference, name the sides that touch by side sets.";
  throw base::Error(message.str(), base::ExitCode::input);
}

}  // namespace harmos::mesh
