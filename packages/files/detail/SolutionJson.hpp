#pragma once

#include <nlohmann/json.hpp>

#include <harmos/files/SolutionRecord.hpp>

namespace harmos::files {

/// What SCENE_result.json says of the solution, as an object; null where nothing is known.
nlohmann::ordered_json toJson(const SolutionRecord& record);

}  // namespace harmos::files
