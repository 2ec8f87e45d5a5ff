#pragma once

#include <string>
#include <vector>

#include <harmos/input/InputTree.hpp>

namespace harmos::input {

/// The paths "List/Sublist/Name" of all entries whose value is `reference`, such as "$mu", or a list with it.
std::vector<std::string> entriesThatName(const InputTree& input, const std::string& reference);

}  // namespace harmos::input
