#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/PointSearch.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mortar {

/// Finds the faces on which a place lies, and what it is made of their nodes.
class NearestFaces {
 public:
  /// Places of mesh nodes [length], shared by several of these.
  using Nodes = std::shared_ptr<const std::vector<base::Vector3>>;
  /// `faces`: of a mesh of `dimension` with these nodes, at least one.
  NearestFaces(int dimension, Nodes nodes, std::vector<mesh::Face> faces);

  /// The point of a face that is nearest to a place.
  struct Found {
    int element = -1;                             // mesh element number of the face
    double distance = 0.0;                        // of the point from the place [length]
    double size = 0.0;                            // of the face, mean length of its edges [length]
    std::vector<std::pair<int, double>> weights;  // mesh nodes and their shape functions at the point
  };
  /// The nearest face, and all others that are as near but for mesh::conformingTolerance of its size; in the order of
  /// the faces. `place`: [length]. Safe to use from several threads.
  std::vector<Found> at(const base::Vector3& place) const;
  /// Distance of a place from the box around all faces [length]: none is nearer.
  double distanceToBox(const base::Vector3& place) const;

 private:
  Found nearestOn(const mesh::Face& face, const base::Vector3& place) const;

  int dimension_;
  Nodes nodes_;
  std::vector<mesh::Face> faces_;
  mesh::PointSearch centres_;
  base::Vector3 lower_{}, upper_{};  // corners of the box around all faces [length]
  double radius_ = 0.0;              // of the largest face, from its centre [length]
};

}  // namespace harmos::mortar
