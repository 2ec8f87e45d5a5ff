#include <harmos/results/SurfaceData.hpp>

#include <algorithm>
#include <limits>

#include <harmos/design/SurrogateFit.hpp>
#include <harmos/results/StatusName.hpp>

namespace harmos::results {

void SurfaceData::addParameter(const std::string& name, const std::vector<double>& column) {
  points.resize(column.size());
  const auto [least, most] = std::minmax_element(column.begin(), column.end());
  if (column.empty() || *least == *most) return;
  parameters.push_back(name);
  for (std::size_t i = 0; i < column.size(); ++i) points[i].push_back(column[i]);
}

void SurfaceData::addResponse(const std::string& name, std::vector<double> column, const std::vector<bool>& isSolved) {
  for (std::size_t i = 0; i < column.size(); ++i) {
    if (!isSolved[i]) column[i] = std::numeric_limits<double>::quiet_NaN();
  }
  responses.push_back(name);
  values.push_back(std::move(column));
}

std::optional<design::Surrogate> SurfaceData::surrogate(std::size_t response) const {
  return design::fitSurrogate(points, values[response], accuracy);
}

SurfaceData surfaceDataOf(const StudyResults& results) {
  const StudyDescription& description = results.description();
  SurfaceData data;
  data.accuracy = description.accuracy;
  for (std::size_t p = 0; p < description.parameters.size(); ++p) {
    if (!description.parameters[p].formula.empty()) continue;
    std::vector<double> column;
    for (const auto& configuration : results.configurations()) column.push_back(configuration.values[p]);
    data.addParameter(description.parameters[p].name, column);
  }
  std::vector<std::vector<double>> columns(description.responses.size());
  std::vector<bool> solved;
  for (const auto& configuration : results.configurations()) {
    const ConfigurationResult* result = results.find(configuration.id);
    solved.push_back(result && isSolved(result->status));
    const std::vector<double> responses = results.responses(configuration.id);
    for (std::size_t r = 0; r < responses.size(); ++r) columns[r].push_back(responses[r]);
  }
  for (std::size_t r = 0; r < columns.size(); ++r) {
    data.addResponse(description.responses[r].name, std::move(columns[r]), solved);
  }
  return data;
}

}  // namespace harmos::results
