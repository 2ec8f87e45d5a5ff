#pragma once

#include <optional>
#include <string>
#include <vector>

#include <harmos/design/Surrogate.hpp>
#include <harmos/results/StudyResults.hpp>

namespace harmos::results {

/// What response surfaces are made of: the free parameters of a study that have more than one value, and its responses.
struct SurfaceData {
  std::vector<std::string> parameters;
  std::vector<std::vector<double>> points;  // [configuration][parameter]
  std::vector<std::string> responses;
  std::vector<std::vector<double>> values;  // [response][configuration]; not a number without a solution
  double accuracy = 0.0;                    // of the values, relative to the largest of a response

  /// Adds a free parameter with its value in every configuration, unless there is no second value: it then spans no
  /// surface.
  void addParameter(const std::string& name, const std::vector<double>& column);
  /// Adds a response with its value in every configuration; without a solution (`isSolved`) it is not a number.
  void addResponse(const std::string& name, std::vector<double> column, const std::vector<bool>& isSolved);
  /// See design::fitSurrogate().
  std::optional<design::Surrogate> surrogate(std::size_t response) const;
};

/// Of a study in memory.
SurfaceData surfaceDataOf(const StudyResults& results);

}  // namespace harmos::results
