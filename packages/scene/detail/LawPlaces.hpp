#pragma once

#include <vector>

#include <harmos/assembly/Interface.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::scene {

/// The geometry that laws of a scene act on.
struct LawPlaces {
  const mesh::Mesh& mesh;
  const std::vector<mesh::Piece>& pieces;               // the bodies of the interfaces
  const std::vector<mesh::InterfaceSurface>& surfaces;  // of interfaces, boundaries and cuts
  const std::vector<assembly::Interface>& interfaces;   // made of them
  int components;                                       // of a displacement
};

}  // namespace harmos::scene
