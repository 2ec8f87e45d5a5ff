#pragma once

#include <optional>
#include <string>
#include <vector>

#include <harmos/design/Surrogate.hpp>
#include <harmos/results/StudyResults.hpp>

namespace harmos::files {

/// What response surfaces are made of: the free parameters of a study that have more than one value, and its responses.
struct StudyData {
  std::vector<std::string> parameters;      // names
  std::vector<std::vector<double>> points;  // [configuration][parameter], in the units of the parameters
  std::vector<std::string> responses;       // names
  std::vector<std::vector<double>> values;  // [response][configuration]; not a number without a solution
  double accuracy = 0.0;                    // relative error that the study asked for

  /// See design::fitSurrogate(); `response` counts from 0.
  std::optional<design::Surrogate> surrogate(std::size_t response) const;
};

/// Of a study in memory.
StudyData dataOf(const results::StudyResults& results);

/// Reads the first study of a file that writeStudyFile() has written. Throws base::Error (input) when it is none, or
/// one of a newer version of Harmos.
StudyData readStudyData(const std::string& path);

}  // namespace harmos::files
