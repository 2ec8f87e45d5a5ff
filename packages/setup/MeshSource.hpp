#pragma once

#include <string>
#include <vector>

#include <harmos/base/ParameterSpec.hpp>
#include <harmos/base/Parameters.hpp>
#include <harmos/mesh/Mesh.hpp>

namespace harmos::setup {

/// Where a scene may take its mesh from: an Exodus file or one of the generators.
std::vector<base::ParameterSpec> meshForms();

/// Reads or generates the mesh. A relative file name is looked up from the folder of `scenePath`.
/// Throws base::Error (input) when the file cannot be used.
mesh::Mesh makeMesh(const base::Parameters& source, const std::string& scenePath);

}  // namespace harmos::setup
