#pragma once

#include <string>
#include <vector>

#include <harmos/input/Parameters.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::scene {

/// What fields are made of, besides their entries.
struct FieldContext {
  const mesh::Mesh& mesh;
  const std::vector<mesh::Piece>& pieces;
  const std::vector<mesh::InterfaceSurface>& surfaces;  // of interfaces and boundaries
  const input::Parameters& scene;                       // whole
  const std::string& scenePath;                         // where relative names of files start
  const std::vector<double>& times;                     // end of each load step [time]
};

}  // namespace harmos::scene
