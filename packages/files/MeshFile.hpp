#pragma once

#include <string>
#include <vector>

#include <harmos/mesh/Mesh.hpp>

namespace harmos::files {

/// Reads the mesh of a file by its ending: of Gmsh (.msh), Abaqus or CalculiX (.inp), I-DEAS (.unv), Salome (.med) or
/// VTK (.vtu, .vtk) through the Python package, see runPythonPackage(), into an Exodus file that is removed again; any
/// other one, and `unused`, as readExodus() does. Throws base::Error (input) with file and line where the file is
/// wrong, the plain one where a package of Debian is missing. `warnings`, if it is not null, gets a sentence for
/// whatever the converted mesh has otherwise than its file. Not collective.
mesh::Mesh readMesh(const std::string& path, const std::vector<std::string>& unused,
                    std::vector<std::string>* warnings);

}  // namespace harmos::files
