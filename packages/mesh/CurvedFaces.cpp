#include <harmos/mesh/CurvedFaces.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <utility>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {
namespace {

// Distance of nodes from their surface over its radius: more is another surface.
constexpr double offSurface = 1e-3;
// Distance over the radius that is none, for nodes on several surfaces, and how often they are moved from one to
// another.
constexpr double onSurface = 1e-12;
constexpr int mostMoves = 200;

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw base::Error("curved surface " + base::quoted(name) + ": " + what, base::ExitCode::input);
}

const SideSet& find(const Mesh& mesh, const std::string& name, const std::string& sideSet) {
  const auto found =
      std::find_if(mesh.sideSets.begin(), mesh.sideSets.end(), [&](const SideSet& set) { return set.name == sideSet; });
  if (found == mesh.sideSets.end()) {
    std::vector<std::string> known;
    for (const SideSet& set : mesh.sideSets) known.push_back(set.name);
    refuse(name,
           "there is no side set " + base::quoted(sideSet) + ".\n  " + base::suggestName(sideSet, known, "Side sets"));
  }
  if (found->element.empty()) refuse(name, "side set " + base::quoted(sideSet) + " has no faces.");
  return *found;
}

base::Vector3 normalOf(const Mesh& mesh, const std::vector<int>& nodes) {
  const int corners = cornersOfFace(mesh.dimension, nodes.size());
  base::Vector3 sum{};
  for (int i = 1; i + 1 < corners; ++i) {
    const base::Vector3& origin = mesh.nodes[nodes[0]];
    sum = sum + base::cross(mesh.nodes[nodes[i]] - origin, mesh.nodes[nodes[i + 1]] - origin);
  }
  return sum;
}

}  // namespace

CurvedFaces curvedFaces(const Mesh& mesh, const std::string& name, CurvedSurface::Kind kind,
                        const std::vector<std::string>& sideSets) {
  if (sideSets.empty()) refuse(name, "no side set is named.\n  Give the side sets whose faces lie on it.");
  const Elements elements(mesh);
  std::set<int> nodes;
  std::vector<base::Vector3> normals;
  for (const std::string& sideSet : sideSets) {
    const SideSet& set = find(mesh, name, sideSet);
    for (std::size_t i = 0; i < set.element.size(); ++i) {
      const std::vector<int> face = elements.side(set.element[i], set.side[i]);
      nodes.insert(face.begin(), face.end());
      if (mesh.dimension == 3) normals.push_back(normalOf(mesh, face));
    }
  }
  if (mesh.dimension == 2 && kind == CurvedSurface::Kind::cone) {
    refuse(name, "a cone is straight in the plane.\n  Leave it out, or give Type = Cylinder for a circle.");
  }
  std::vector<base::Vector3> places;
  for (const int node : nodes) places.push_back(mesh.nodes[node]);
  CurvedFaces result{name, sideSets, {}};
  try {
    result.surface = mesh.dimension == 2                     ? CurvedSurface::circle(places)
                     : kind == CurvedSurface::Kind::cylinder ? CurvedSurface::cylinder(places, normals)
                     : kind == CurvedSurface::Kind::cone     ? CurvedSurface::cone(places, normals)
                                                             : CurvedSurface::sphere(places);
  } catch (const base::Error& error) {
    refuse(name, error.what());
  }
  const auto offset = [&](int node) { return result.surface.distance(mesh.nodes[node]); };
  const int worst = *std::max_element(nodes.begin(), nodes.end(), [&](int a, int b) { return offset(a) < offset(b); });
  if (offset(worst) > offSurface * result.surface.radius()) {
    std::ostringstream text;
    text << nodeName(mesh, worst) << " lies " << offset(worst) << " off the surface that fits best, of radius "
         << result.surface.radius() << ".\n  Name side sets of one surface only, and no faces beside it.";
    refuse(name, text.str());
  }
  return result;
}

int straightBeside(const Mesh& mesh, const std::vector<CurvedFaces>& faces) {
  const Elements elements(mesh);
  std::set<std::pair<int, int>> named;  // element and side
  std::vector<std::array<base::Vector3, 2>> boxes;
  for (const CurvedFaces& curved : faces) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<base::Vector3, 2> box{{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}}};
    for (const std::string& sideSet : curved.sideSets) {
      const SideSet& set = find(mesh, curved.name, sideSet);
      for (std::size_t i = 0; i < set.element.size(); ++i) {
        named.insert({set.element[i], set.side[i]});
        for (const base::Vector3& place : pointsOf(mesh, elements.side(set.element[i], set.side[i]))) {
          for (int axis = 0; axis < 3; ++axis) {
            box[0][axis] = std::min(box[0][axis], place[axis] - offSurface * curved.surface.radius());
            box[1][axis] = std::max(box[1][axis], place[axis] + offSurface * curved.surface.radius());
          }
        }
      }
    }
    boxes.push_back(box);
  }
  std::vector<int> all(static_cast<std::size_t>(elements.count()));
  std::iota(all.begin(), all.end(), 0);
  int count = 0;
  for (const Face& face : skin(elements, all)) {
    if (named.count({face.element, face.side}) > 0) continue;
    const std::vector<base::Vector3> places = pointsOf(mesh, face.nodes);
    for (std::size_t s = 0; s < faces.size(); ++s) {
      const CurvedSurface& surface = faces[s].surface;
      const auto isOn = [&](const base::Vector3& place) {
        for (int axis = 0; axis < 3; ++axis) {
          if (place[axis] < boxes[s][0][axis] || place[axis] > boxes[s][1][axis]) return false;
        }
        return surface.distance(place) <= offSurface * surface.radius();
      };
      if (!std::all_of(places.begin(), places.end(), isOn)) continue;
      ++count;
      break;
    }
  }
  return count;
}

void moveOnto(const std::vector<CurvedFaces>& faces, int first, Mesh& mesh) {
  const Elements elements(mesh);
  std::map<int, std::set<std::size_t>> surfacesOf;  // per new node
  for (std::size_t s = 0; s < faces.size(); ++s) {
    for (const std::string& sideSet : faces[s].sideSets) {
      const SideSet& set = find(mesh, faces[s].name, sideSet);
      for (std::size_t i = 0; i < set.element.size(); ++i) {
        for (const int node : elements.side(set.element[i], set.side[i])) {
          if (node >= first) surfacesOf[node].insert(s);
        }
      }
    }
  }
  for (const auto& [node, surfaces] : surfacesOf) {
    base::Vector3& place = mesh.nodes[node];
    const std::string before = nodeName(mesh, node);
    const auto isOff = [&](std::size_t s) {
      return faces[s].surface.distance(place) > onSurface * faces[s].surface.radius();
    };
    int moves = 0;
    do {
      for (const std::size_t s : surfaces) place = faces[s].surface.nearest(place);
    } while (std::any_of(surfaces.begin(), surfaces.end(), isOff) && ++moves < mostMoves);
    if (moves == mostMoves) {
      refuse(faces[*surfaces.begin()].name, "it does not meet curved surface " +
                                                base::quoted(faces[*surfaces.rbegin()].name) + " near " + before +
                                                ", which lies on both.");
    }
  }
}

}  // namespace harmos::mesh
