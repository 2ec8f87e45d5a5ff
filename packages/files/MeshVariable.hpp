#pragma once

#include <optional>
#include <string>
#include <vector>

namespace harmos::files {

/// A variable of an Exodus file over its nodes or its elements, in its unit.
struct MeshVariable {
  bool isNodal = true;                      // else of elements
  std::vector<double> times;                // [time], of the steps that were read, ascending
  std::vector<std::vector<double>> values;  // per step: of every node, or of every element through all blocks
  std::vector<std::string> blocks;          // of elements: the names of all blocks of the file, in their order
  std::vector<int> blockSizes;              // how many elements each has
};

/// Reads the variable of this name, of nodes if they have one, else of elements; 0 on blocks without it.
///
/// `step`: time step of the file, counted from 1, 0 the last; nothing: all of them. Throws base::Error (input) if there
/// is no such file, variable or time step, or the file is damaged. Not collective.
MeshVariable readMeshVariable(const std::string& path, const std::string& name, const std::optional<int>& step);

}  // namespace harmos::files
