#pragma once

#include <string>

#include <harmos/input/ErrorList.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::scene {

/// Demands that a place is either a node set or given by the entry `other`, a side set or point; of these a side set
/// belongs to its part already. `what` is there, for messages.
void checkPlace(const input::Parameters& parameters, const std::string& what, const std::string& other,
                input::ErrorList& errors);

}  // namespace harmos::scene
