#pragma once

#include <memory>
#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/latin/Response.hpp>
#include <harmos/mesh/InterfaceFinder.hpp>

namespace harmos::scene {

/// The numbers that a scene may ask for.
std::vector<input::ParameterSpec> responseForms();

/// Builds the responses of a scene; reports sets, points and directions that do not fit the mesh to `errors`.
///
/// `parts` are the bodies of the assembly; interfaces carry the names of the scene.
std::vector<std::shared_ptr<const latin::Response>> makeResponses(
    const std::vector<input::Parameters>& responses, const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces,
    const mesh::InterfaceFinder& finder, const assembly::Assembly& assembly, input::ErrorList& errors);

}  // namespace harmos::scene
