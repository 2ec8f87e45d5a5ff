#pragma once

#include <vector>

#include <harmos/input/ErrorList.hpp>
#include <harmos/mesh/InterfaceFinder.hpp>
#include <harmos/scene/Bodies.hpp>
#include <harmos/scene/JoinedMeshes.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::scene {

/// Where interfaces and boundaries are.
struct Surfaces {
  std::vector<mesh::InterfaceSurface> all;
  std::vector<JoinedMeshes> joined;  // of the interfaces whose meshes do not match
  KeptTogether crossed;              // what pieces must not divide, for such interfaces; else empty
};

/// Finds the surfaces of all interfaces and boundaries of a scene and, between the pieces of a part that was cut, of
/// perfect interfaces. Reports sets that do not exist, sides that do not fit together, nodes without the normal that
/// their law needs and parts that nothing touches to `errors`. Nodes at creases are several pairs where the law says
/// so. Meshes that do not match are joined on points; where cuts of METIS divide what a point sees, `crossed` says so,
/// and there are no surfaces: parts have to be cut otherwise. In the order of Interfaces, then Boundaries, then cuts;
/// after errors in the first two the rest is not looked at. Every rank finds all of them.
Surfaces findSurfaces(const Scene& scene, const mesh::Mesh& mesh, const Model& model, const Bodies& bodies,
                      const mesh::InterfaceFinder& finder, input::ErrorList& errors);

}  // namespace harmos::scene
