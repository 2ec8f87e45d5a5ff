#pragma once

#include <memory>
#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/latin/LatinOptions.hpp>
#include <harmos/latin/Response.hpp>

namespace harmos::scene {

/// Declares the entries of the list Path Following.
void describePathFollowing(input::ParameterSpec& spec);

/// What of the list can be checked without a mesh: names, and what else of the scene it does not go with.
void checkPathFollowing(const input::Parameters& scene, const latin::LatinOptions& solver, input::ErrorList& errors);

/// Makes the path of the assembly, whose interfaces and times are complete, of the list, if there is one, and adds its
/// load factor to the responses.
void addPath(const input::Parameters& scene, assembly::Assembly& assembly,
             std::vector<std::shared_ptr<const latin::Response>>& responses, input::ErrorList& errors);

}  // namespace harmos::scene
