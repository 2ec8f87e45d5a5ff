#pragma once

#include <map>
#include <memory>
#include <set>
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
  std::map<std::string, int> pieces;  // of parts that were cut because that pays, by name
  std::set<std::string> iterated;     // parts that are solved iteratively because they do not fit, by name
  std::string cuts;                   // what these save, a sentence; empty: there are none
};

/// Whether parts whose "Pieces" are not given may be cut, and those without "Linear Solver" solved iteratively.
enum class Cutting {
  asGiven,   ///< none is
  automatic  ///< large ones are, where the cost model says that it saves much time, or memory that there is not
};

/// Reads the mesh and builds everything. Collective over comm, which is not kept; throws on all ranks or on none.
///
/// Time is charged to the phases "read" and "assemble". Throws one base::Error (input) that lists all errors found in
/// the names of blocks and sets, in the fit of interfaces, in laws that contradict each other, and in elements.
///
/// Cutting::automatic says what was chosen in `pieces`, `iterated` and `cuts`; nothing is cut that cannot be. It is for
/// single runs: studies solve so often that only stages count.
Problem makeProblem(const Scene& scene, const Teuchos::Comm<int>& comm, base::Timers& timers,
                    Cutting cutting = Cutting::asGiven);

}  // namespace harmos::scene
