#pragma once

#include <map>
#include <vector>

#include <harmos/base/Vector3.hpp>

namespace harmos::mortar {

/// Unit vectors along which boundaries give the displacement of nodes, by node of the mesh.
using HeldDirections = std::map<int, std::vector<base::Vector3>>;

}  // namespace harmos::mortar
