#include <harmos/mortar/NearestFaces.hpp>

#include <algorithm>

#include <harmos/mesh/FaceMatching.hpp>
#include <harmos/mortar/detail/FlatFace.hpp>

namespace harmos::mortar {

namespace {

using Points = std::vector<base::Vector3>;

base::Vector3 centreOf(int dimension, const Points& nodes, const mesh::Face& face) {
  const int corners = mesh::cornersOfFace(dimension, face.nodes.size());
  base::Vector3 sum{};
  for (int c = 0; c < corners; ++c) sum = sum + nodes[face.nodes[c]];
  return (1.0 / corners) * sum;
}

Points centresOf(int dimension, const Points& nodes, const std::vector<mesh::Face>& faces) {
  Points centres;
  for (const mesh::Face& face : faces) centres.push_back(centreOf(dimension, nodes, face));
  return centres;
}

/// Along the normal of the plane through its corners, which need not lie in one.
base::Vector3 normalOf(int dimension, const Points& nodes, const mesh::Face& face) {
  const auto corner = [&](int c) { return nodes[face.nodes[c]]; };
  base::Vector3 normal{};
  if (dimension == 2) {
    const base::Vector3 edge = corner(1) - corner(0);
    normal = {edge[1], -edge[0], 0.0};
  } else if (mesh::cornersOfFace(3, face.nodes.size()) == 3) {
    normal = cross(corner(1) - corner(0), corner(2) - corner(0));
  } else {
    normal = cross(corner(2) - corner(0), corner(3) - corner(1));
  }
  return (1.0 / norm(normal)) * normal;
}

/// The nearest place of the parent domain.
Parent inside(const FaceShape& shape, Parent at) {
  if (shape.corners() != 3) {
    at[0] = std::clamp(at[0], -1.0, 1.0);
    at[1] = shape.parentDimension() == 1 ? 0.0 : std::clamp(at[1], -1.0, 1.0);
    return at;
  }
  if (at[0] + at[1] > 1.0 && at[0] > -1.0 && at[1] > -1.0) {
    const double along = std::clamp(0.5 * (1.0 + at[0] - at[1]), 0.0, 1.0);
    return {along, 1.0 - along};
  }
  return {std::clamp(at[0], 0.0, 1.0), std::clamp(at[1], 0.0, 1.0)};
}

}  // namespace

NearestFaces::NearestFaces(int dimension, Nodes nodes, std::vector<mesh::Face> faces)
    : dimension_(dimension),
      nodes_(std::move(nodes)),
      faces_(std::move(faces)),
      centres_(centresOf(dimension, *nodes_, faces_)) {
  lower_ = upper_ = (*nodes_)[faces_.front().nodes.front()];
  for (const mesh::Face& face : faces_) {
    const base::Vector3 centre = centreOf(dimension_, *nodes_, face);
    for (const int node : face.nodes) {
      const base::Vector3& point = (*nodes_)[node];
      radius_ = std::max(radius_, distance(point, centre));
      for (std::size_t c = 0; c < 3; ++c) {
        lower_[c] = std::min(lower_[c], point[c]);
        upper_[c] = std::max(upper_[c], point[c]);
      }
    }
  }
}

double NearestFaces::distanceToBox(const base::Vector3& place) const {
  base::Vector3 beyond{};
  for (std::size_t c = 0; c < 3; ++c) beyond[c] = std::max({0.0, lower_[c] - place[c], place[c] - upper_[c]});
  return norm(beyond);
}

NearestFaces::Found NearestFaces::nearestOn(const mesh::Face& face, const base::Vector3& place) const {
  const FaceShape& shape = FaceShape::of(dimension_, face.nodes.size());
  const Plane plane(centreOf(dimension_, *nodes_, face), normalOf(dimension_, *nodes_, face), dimension_);
  const FlatFace flat(shape, *nodes_, face.nodes, plane);
  const FaceShape::Values values = shape.values(inside(shape, flat.parentOf(plane.project(place))));
  Found found;
  found.element = face.element;
  found.size = flat.size();
  base::Vector3 point{};
  for (std::size_t n = 0; n < face.nodes.size(); ++n) {
    found.weights.emplace_back(face.nodes[n], values[n]);
    point = point + values[n] * (*nodes_)[face.nodes[n]];
  }
  found.distance = distance(point, place);
  return found;
}

std::vector<NearestFaces::Found> NearestFaces::at(const base::Vector3& place) const {
  const double reach = centres_.nearest(place).distance + radius_;
  std::vector<Found> found;
  for (const int f : centres_.within(place, reach)) found.push_back(nearestOn(faces_[f], place));
  const auto nearest = *std::min_element(found.begin(), found.end(),
                                         [](const auto& a, const auto& b) { return a.distance < b.distance; });
  const double limit = nearest.distance + mesh::conformingTolerance * nearest.size;
  found.erase(std::remove_if(found.begin(), found.end(), [&](const Found& f) { return f.distance > limit; }),
              found.end());
  return found;
}

}  // namespace harmos::mortar
