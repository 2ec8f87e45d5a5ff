#pragma once

#include <optional>
#include <string>
#include <vector>

#include <harmos/input/ErrorList.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/MeshSize.hpp>

namespace harmos::scene {

/// Where a scene may take its mesh from: an Exodus file or one of the generators. Each form is the
/// list Mesh with another Type.
std::vector<input::ParameterSpec> meshForms();

/// Number of dimensions of the mesh that a generator will make; nothing for a file, which is not read here. Reports
/// boxes that cannot be to `errors`.
std::optional<int> meshDimension(const input::Parameters& source, input::ErrorList& errors);

/// The blocks of the mesh that a generator will make, as Refine and Order leave them, in no time; none for a file.
/// Throws as makeMesh().
std::vector<mesh::BlockSize> meshSizes(const input::Parameters& source);

/// Path of the file that the mesh is read from: a relative name is looked up from the folder of `scenePath`; nothing
/// when it is generated.
std::optional<std::string> meshFile(const input::Parameters& source, const std::string& scenePath);

/// Reads or generates the mesh; `scenePath` as for meshFile().
/// Throws base::Error (input) when the file cannot be used. Not collective: every rank that calls it reads the file.
/// `warnings`, if it is not null, gets what a user should know of the mesh.
mesh::Mesh makeMesh(const input::Parameters& source, const std::string& scenePath,
                    std::vector<std::string>* warnings = nullptr);

}  // namespace harmos::scene
