#pragma once

#include <string>
#include <vector>

#include <harmos/mesh/Mesh.hpp>

namespace harmos::files {

/// Reads the mesh of an Exodus II file: classic, 64-bit offset or netCDF-4, with 32- or 64-bit integers; blocks and
/// sets in the order of the file, empty blocks left out, unnamed ones called block_<id>, sideset_<id>, nodeset_<id>.
/// The time steps of the file, if any, are ignored. Orientation is not checked.
/// Coordinates are those of the file [length]; node, element and side numbers are counted from 0. Mesh::numbering
/// has the numbers of the file's maps of nodes and elements, where those are above 0 and distinct, else positions.
///
/// Blocks that `unused` names may have elements of any kind: those that are not supported are left out, with their
/// faces in side sets, and stand in Mesh::unreadBlocks.
///
/// Throws base::Error(input) if the file is missing, unreadable, truncated or no Exodus file, if another block has
/// elements that are not supported (shells in space among them), or if two blocks, side sets or node sets have one
/// name.
mesh::Mesh readExodus(const std::string& path, const std::vector<std::string>& unused = {});

}  // namespace harmos::files
