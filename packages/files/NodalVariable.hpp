#pragma once

#include <string>
#include <vector>

namespace harmos::files {

/// Values of a nodal variable of an Exodus II file, one per node of the file, in its unit.
///
/// `step`: time step of the file, counted from 1; 0: the last. Throws base::Error (input) if there is no such file,
/// variable or time step, or the file is damaged.
std::vector<double> readNodalVariable(const std::string& path, const std::string& name, int step);

}  // namespace harmos::files
