#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/base/Timers.hpp>
#include <harmos/latin/Response.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/scene/Bodies.hpp>
#include <harmos/scene/Interfaces.hpp>
#include <harmos/scene/JoinedMeshes.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::scene {

/// A scene made of numbers: mesh, bodies and interfaces, ready to be solved.
struct Problem {
  mesh::Mesh mesh;                                   // whole, on every rank
  Model model;                                       // kinematics and thickness
  Bodies bodies;                                     // geometry and materials, parallel to assembly.bodies
  std::vector<mesh::InterfaceSurface> surfaces;      // of interfaces, boundaries and cuts
  std::vector<JoinedMeshes> joined;                  // interfaces whose meshes do not match
  std::vector<std::vector<PairPlace>> places;        // per surface and pair: where its unknowns are
  std::shared_ptr<const Temperatures> temperatures;  // of the parts
  assembly::Assembly assembly;                       // what LATIN solves
  std::vector<std::shared_ptr<const latin::Response>>
      responses;                      // in the order of the list Responses; then the load factor
  std::vector<std::string> warnings;  // those of the scene, and what its mesh adds
};

/// Reads the mesh and builds everything. Collective over comm, which is not kept; throws on all ranks or on none.
///
/// Time is charged to the phases "read" and "assemble". Throws one base::Error (input) that lists all errors found in
/// the names of blocks and sets, in the fit of interfaces, in laws that contradict each other, and in elements.
Problem makeProblem(const Scene& scene, const Teuchos::Comm<int>& comm, base::Timers& timers);

}  // namespace harmos::scene
