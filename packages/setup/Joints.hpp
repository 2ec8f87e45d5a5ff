#pragma once

#include <vector>

#include <harmos/base/ErrorList.hpp>
#include <harmos/interface/Interface.hpp>
#include <harmos/mesh/InterfaceFinder.hpp>
#include <harmos/setup/Scene.hpp>

namespace harmos::setup {

/// Finds the surfaces of all interfaces and boundaries of a scene and, between the pieces of a part that was cut, of
/// perfect interfaces. Reports sets that do not exist, sides that do not fit together and parts that nothing touches.
std::vector<mesh::InterfaceSurface> findSurfaces(const Scene& scene, const mesh::Mesh& mesh,
                                                 const std::vector<mesh::Part>& parts,
                                                 const mesh::InterfaceFinder& finder, base::ErrorList& errors);

/// One interface of the assembly per surface, with the law of that name. `isConsistent`: with the consistent interface
/// mass where the surface has faces.
std::vector<interface::Interface> makeInterfaces(const Scene& scene,
                                                 const std::vector<mesh::InterfaceSurface>& surfaces,
                                                 bool isConsistent);

}  // namespace harmos::setup
