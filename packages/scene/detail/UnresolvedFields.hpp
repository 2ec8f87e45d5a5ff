#pragma once

#include <string>
#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/scene/Bodies.hpp>

namespace harmos::scene {

/// What to tell the user of random fields whose correlation length is shorter than the distance of points of an
/// interface that follows them: a sentence on each field, with both lengths. The points are then as good as independent
/// of each other, whatever the length, and means over the face scatter with the size of elements. `assembly` needs its
/// interfaces only.
std::vector<std::string> unresolvedFields(const input::Parameters& scene, const assembly::Assembly& assembly,
                                          const Model& model);

}  // namespace harmos::scene
