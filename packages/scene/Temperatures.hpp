#pragma once

#include <map>
#include <memory>
#include <string>

#include <harmos/base/Matrix.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::scene {

class TemperatureField;

/// How much warmer the parts of a scene are than at their stress-free reference, at every load step.
class Temperatures {
 public:
  /// Reports variables that cannot be read to `errors`. Keeps a reference to the mesh, which must outlive it.
  Temperatures(const Scene& scene, const mesh::Mesh& mesh, input::ErrorList& errors);

  /// T - T_ref [temperature] at the nodes of a piece, nodes x load steps; 0 x 0 where its part has no temperature.
  /// Throws base::Error (input) where a formula has no value. Not collective.
  base::Matrix of(const mesh::Piece& piece) const;

 private:
  struct OfPart {
    std::shared_ptr<const TemperatureField> field;
    double reference = 0.0;
  };
  int steps_;
  std::map<std::string, OfPart> parts_;
};

}  // namespace harmos::scene
