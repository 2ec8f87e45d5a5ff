#pragma once

#include <memory>
#include <vector>

#include <harmos/base/ErrorList.hpp>
#include <harmos/base/ParameterSpec.hpp>
#include <harmos/base/Parameters.hpp>
#include <harmos/interface/Assembly.hpp>
#include <harmos/latin/Response.hpp>
#include <harmos/mesh/InterfaceFinder.hpp>

namespace harmos::setup {

/// The numbers that a scene may ask for.
std::vector<base::ParameterSpec> responseForms();

/// Builds the responses of a scene; reports sets, points and directions that do not fit the mesh to `errors`.
///
/// `parts` are the bodies of the assembly; interfaces carry the names of the scene.
std::vector<std::shared_ptr<const latin::Response>> makeResponses(
    const std::vector<base::Parameters>& responses, const mesh::Mesh& mesh, const std::vector<mesh::Part>& parts,
    const mesh::InterfaceFinder& finder, const interface::Assembly& assembly, base::ErrorList& errors);

}  // namespace harmos::setup
