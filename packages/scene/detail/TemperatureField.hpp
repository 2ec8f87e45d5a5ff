#pragma once

#include <string>

#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/input/Registry.hpp>
#include <harmos/mesh/Mesh.hpp>

namespace harmos::scene {

/// A temperature of parts over the load steps.
class TemperatureField {
 public:
  virtual ~TemperatureField() = default;
  /// Temperature [temperature] at a load step, counted from 0, and a node of the mesh. Throws base::Error (input) where
  /// there is none.
  virtual double at(int step, int node) const = 0;
};

/// What temperatures are made of, besides their entries.
struct TemperatureContext {
  const mesh::Mesh& mesh;
  const input::Parameters& source;  // the list Mesh of the scene
  const std::string& scenePath;
};

/// The temperatures that a scene may name: Prescribed and Nodal Variable.
using TemperatureRegistry = input::Registry<TemperatureField, const TemperatureContext&>;
const TemperatureRegistry& builtInTemperatures();

/// Declares what all temperatures have.
void describeTemperature(input::ParameterSpec& spec);

}  // namespace harmos::scene
