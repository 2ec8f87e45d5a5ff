#pragma once

#include <string>
#include <vector>

namespace harmos::files {

/// Where the results of a scene lie: DIR/SCENE.e and its companions.
struct ResultFiles {
  /// `scene` is the path of the scene's file; its name without folder and ending names the results.
  ResultFiles(const std::string& directory, const std::string& scene);

  std::string parts;           // SCENE.e
  std::string interfaces;      // SCENE_interfaces.e
  std::string history;         // SCENE_history.csv
  std::string effectiveInput;  // SCENE_effective.xml
  std::string record;          // SCENE_result.json
  std::string derivatives;     // SCENE_derivatives.csv, where they are asked for

  /// These six paths, whether there are such files or not.
  std::vector<std::string> all() const { return {parts, interfaces, history, effectiveInput, record, derivatives}; }
};

}  // namespace harmos::files
