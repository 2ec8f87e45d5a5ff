#pragma once

#include <optional>
#include <string>
#include <vector>

#include <harmos/design/Surrogate.hpp>
#include <harmos/results/StudyResults.hpp>

namespace harmos::files {

/// What response surfaces are made of: the free parameters of a study that have more than one value, and its responses.
struct StudyData {
  std::vector<std::string> parameters;
  std::vector<std::vector<double>> points;  // [configuration][parameter]
  std::vector<std::string> responses;
  std::vector<std::vector<double>> values;  // [response][configuration]; not a number without a solution
  double accuracy = 0.0;

  /// See design::fitSurrogate().
  std::optional<design::Surrogate> surrogate(std::size_t response) const;
};

/// Of a study in memory.
StudyData dataOf(const results::StudyResults& results);

/// Reads the first study of a file that writeStudyFile() has written. Throws base::Error (input) when it is none.
StudyData readStudyData(const std::string& path);

}  // namespace harmos::files
