#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>

#include <harmos/assembly/Interface.hpp>
#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/elasticity/Material.hpp>
#include <harmos/elasticity/Stiffness.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/laws/SpatialField.hpp>
#include <harmos/mesh/Depth.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Partition.hpp>
#include <harmos/mesh/Piece.hpp>
#include <harmos/scene/BodyForceComponent.hpp>
#include <harmos/scene/Scene.hpp>
#include <harmos/scene/Temperatures.hpp>
#include <harmos/substructure/Substructure.hpp>

namespace harmos::scene {

/// How elements turn displacements into stress, the same for the whole scene.
struct Model {
  elasticity::Kinematics kinematics = elasticity::Kinematics::threeDimensional;  // of all parts
  double thickness = 1.0;  // [length], of plane strain and plane stress only
};

/// The kinematics asked for, see checkDimensions(); else those that are usual for the mesh: plane strain in the plane.
/// `model` is the list Model of the scene.
Model makeModel(const input::Parameters& model, const mesh::Mesh& mesh);

/// How far the plane reaches out of it: the thickness, or the whole circle of axisymmetry.
mesh::Depth depthOf(const Model& model);

/// What the scene says of a part, for all bodies that it is cut into.
struct PartOptions {
  std::string name;
  std::string where;  // it stands, for messages
  elasticity::Formulation formulation = elasticity::Formulation::fullIntegration;
  std::optional<std::array<BodyForceComponent, 3>> bodyForce;  // global components
  std::string section;    // interface that divides the part along a plane; empty: none does
  bool iterates = false;  // it is solved iteratively instead of factored
};

/// What of each part, by name, stays in one piece.
using KeptTogether = std::map<std::string, std::vector<mesh::Together>>;

/// The elastic bodies of the assembly: the parts of the scene, or the pieces they were cut into. The lists are
/// parallel.
struct Bodies {
  std::vector<mesh::Piece> pieces;  // in the order of the list Parts; bodies are counted in this order everywhere
  std::vector<PartOptions> parts;
  std::vector<std::shared_ptr<const elasticity::Material>> materials;        // shared with the scene
  KeptTogether together;                                                     // when parts were cut
  std::vector<std::shared_ptr<const substructure::Congruence>> congruences;  // see findCongruences(); null until then
};

/// Cuts the parts of the scene into pieces, those that an interface divides along a plane at least into its two sides,
/// the one behind the plane first. Reports blocks that do not exist, belong to two parts or to none, and parts that
/// cannot be cut, to `errors`; after errors in blocks there are no bodies. Every rank makes all of them. `pieces`: how
/// many, by name of the part, where the scene does not say; else one.
Bodies makeBodies(const Scene& scene, const mesh::Mesh& mesh, input::ErrorList& errors,
                  const KeptTogether& together = {}, const std::map<std::string, int>& pieces = {});

/// For every body the earlier one that it equals up to a rigid motion or mirror image, elasticity and all; null: none.
/// That one equals none itself. Bodies with materials of two names are never equal; a turned one is equal only when it
/// is isotropic; in axisymmetry equal ones have the same radii.
///
/// Of several motions one that carries what `interfaces` join and hold onto what they join and hold of a body that
/// equals the same one, if there is any: with the same search directions there, both can share a factor. A lower and an
/// upper plate of a clamp are mirror images.
std::vector<std::shared_ptr<const substructure::Congruence>> findCongruences(
    const Bodies& bodies, const mesh::Mesh& mesh, elasticity::Kinematics kinematics,
    const std::vector<assembly::Interface>& interfaces);

/// Which rank owns which body: the largest first, each to the rank that has least to do. One rank, from 0, per body.
/// The work of a body goes with the number of its nodes to the power 4/3.
std::vector<int> distribute(const Bodies& bodies, int ranks);

/// Stiffness and loads of the bodies that this rank owns; of congruent bodies the stiffness of what they equal. Reports
/// elements that cannot be used to `errors`, on the ranks that own them, and loads that have no meaning on all.
/// `fields`: those that body forces may name.
///
/// Every rank gets all bodies, in their order, with names and nodes; the rest is empty where it has no use. Stiffness
/// is in [force/length], loads are nodal forces [force], degrees of freedom x load steps. Not collective.
std::vector<substructure::Substructure> assemble(const Scene& scene, const mesh::Mesh& mesh, const Model& model,
                                                 const Bodies& bodies, const Temperatures& temperatures,
                                                 const laws::SpatialFields& fields, const std::vector<int>& owner,
                                                 int rank, input::ErrorList& errors);

}  // namespace harmos::scene
