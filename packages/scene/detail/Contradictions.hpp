#pragma once

#include <vector>

#include <harmos/assembly/Interface.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::scene {

/// The geometry that laws of a scene act on.
struct LawPlaces {
  const mesh::Mesh& mesh;
  const std::vector<mesh::Piece>& pieces;               // the bodies of the interfaces
  const std::vector<mesh::InterfaceSurface>& surfaces;  // of interfaces, boundaries and cuts
  const std::vector<assembly::Interface>& interfaces;   // made of them
  int components;                                       // of a displacement
};

/// Reports to `errors` what no displacement or no traction can obey:
/// * nodes whose displacement along one direction boundaries hold at different values, at any load step; nodes that
///   Perfect interfaces join count as one,
/// * tractions that everywhere act along a direction that another boundary holds on the same faces,
/// * faces with two laws that are not affine, or with such a law and one that holds its normal: what each of them
///   carries is not determined.
/// Affine laws are asked at all load steps, whatever they are called.
void checkContradictions(const Scene& scene, const LawPlaces& places, input::ErrorList& errors);

}  // namespace harmos::scene
