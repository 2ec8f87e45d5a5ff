#pragma once

#include <string>
#include <vector>

#include <harmos/input/Parameters.hpp>

namespace harmos::scene {

/// Names of the consistent systems of units that a scene may declare, "LENGTH FORCE TIME": their force is mass times
/// length over time squared, so that numbers need no factors. Nothing is converted.
std::vector<std::string> unitSystems();

/// Numbers of materials that no solid has in the units that the checked `scene` declares, a sentence each with place
/// and likely repair; none when it declares none.
std::vector<std::string> implausibleNumbers(const input::Parameters& scene);

}  // namespace harmos::scene
