#pragma once

#include <vector>

#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/MeshSize.hpp>

namespace harmos::input {
class ParameterSpec;
class Parameters;
}  // namespace harmos::input

namespace harmos::mesh {

/// The form that gluedAssembly() reads: its one entry is Cell Size [length], from 0.01 to 1.
input::ParameterSpec describeGluedAssembly();

/// Three plane parts joined by two glue lines, in square quadrilaterals with conforming nodes; lengths in mm,
/// `cellSize` [length] too.
///
/// Blocks base, middle, top. Side sets clamped, glue_1_1 (base), glue_1_2 (middle), glue_2_1 (middle), glue_2_2 (top),
/// loaded; node set point_a holds the node in the middle of the loaded edge, (38, 240). All edges and glue ends lie at
/// whole millimetres: throws base::Error(input) unless a whole number of cells makes 1 mm.
/// Source: after the second example of Champaney, Blanze, Boucard (2004), dimensions our own.
Mesh gluedAssembly(double cellSize = 0.5);
/// The same from a list that was checked against describeGluedAssembly().
Mesh gluedAssembly(const input::Parameters& parameters);
/// The blocks of this mesh, which is not made. Throws as gluedAssembly().
std::vector<BlockSize> gluedAssemblySizes(const input::Parameters& parameters);

}  // namespace harmos::mesh
