#pragma once

#include <optional>
#include <string>
#include <vector>

#include <harmos/design/Surrogate.hpp>
#include <harmos/results/StudyResults.hpp>

namespace harmos::results {

/// What response surfaces are made of: the free parameters of a study that have more than one value, and its responses.
struct SurfaceData {
  std::vector<std::string> parameters;      // names
  std::vector<std::vector<double>> points;  // [configuration][parameter], in the units of the parameters
  std::vector<std::string> responses;       // names
  std::vector<std::vector<double>> values;  // [response][configuration]; not a number without a solution
  double accuracy = 0.0;                    // relative error that the study asked for

  /// Adds a free parameter with its value in every configuration, unless there is no second value: it then spans no
  /// surface.
  void addParameter(const std::string& name, const std::vector<double>& column);
  /// Adds a response with its value in every configuration; without a solution (`isSolved`) it is not a number.
  void addResponse(const std::string& name, std::vector<double> column, const std::vector<bool>& isSolved);
  /// See design::fitSurrogate(); `response` counts from 0.
  std::optional<design::Surrogate> surrogate(std::size_t response) const;
};

/// Of a study in memory.
SurfaceData surfaceDataOf(const StudyResults& results);

}  // namespace harmos::results
