#pragma once

#include <memory>
#include <vector>

#include <harmos/assembly/Interface.hpp>
#include <harmos/laws/SpatialField.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/Piece.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::scene {

/// Where the unknowns of a surface's pair are: a pair of an interface of the assembly; interface = -1: it has none.
struct PairPlace {
  int interface = -1;  // position in Interfaces::interfaces
  int pair = -1;       // position in that interface
};

/// The interfaces of an assembly and the way back to the surfaces that they were made of.
struct Interfaces {
  std::vector<assembly::Interface> interfaces;  // those with unknowns, in the order of the surfaces
  std::vector<std::vector<PairPlace>> places;   // per surface and pair
};

/// An interface for every surface that carries unknowns, with the law of that name. Merges pairs that cuts make
/// redundant (the areas of `surfaces` change), unless `isConsistent`: then every pair of a surface is kept, with the
/// consistent interface mass where the surface has faces. A traction that is prescribed in the frame of the interface
/// gets |int N n dS| for areas and no mass: a uniform pressure then has the nodal forces and the resultant of the faces
/// themselves. `dimension`: 2 or 3. Laws are shared with the scene; those whose
/// numbers vary over the surface get `fields`, see makeFields(). Throws base::Error (input) where such a number leaves
/// its range, or a field is not known.
Interfaces makeInterfaces(const Scene& scene, int dimension, const std::vector<mesh::Piece>& pieces,
                          std::vector<mesh::InterfaceSurface>& surfaces, bool isConsistent,
                          const std::shared_ptr<const laws::SpatialFields>& fields);

}  // namespace harmos::scene
