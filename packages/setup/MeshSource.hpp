#pragma once

#include <optional>
#include <string>
#include <vector>

#include <harmos/base/ErrorList.hpp>
#include <harmos/base/ParameterSpec.hpp>
#include <harmos/base/Parameters.hpp>
#include <harmos/mesh/Mesh.hpp>

namespace harmos::setup {

/// Where a scene may take its mesh from: an Exodus file or one of the generators.
std::vector<base::ParameterSpec> meshForms();

/// Number of dimensions of the mesh that a generator will make; nothing for a file, which is not read here. Reports
/// boxes that cannot be to `errors`.
std::optional<int> meshDimension(const base::Parameters& source, base::ErrorList& errors);

/// Reads or generates the mesh. A relative file name is looked up from the folder of `scenePath`.
/// Throws base::Error (input) when the file cannot be used.
mesh::Mesh makeMesh(const base::Parameters& source, const std::string& scenePath);

}  // namespace harmos::setup
