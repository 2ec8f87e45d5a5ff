#include <harmos/files/StudyData.hpp>

#include <algorithm>
#include <limits>

#include <harmos/base/Error.hpp>
#include <harmos/design/SurrogateFit.hpp>
#include <harmos/files/detail/Hdf5.hpp>
#include <harmos/files/detail/StudyFile.hpp>
#include <harmos/results/StatusName.hpp>

namespace harmos::files {

std::optional<design::Surrogate> StudyData::surrogate(std::size_t response) const {
  return design::fitSurrogate(points, values[response], accuracy);
}

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A parameter without a second value spans no surface.
void add(const std::string& name, const std::vector<double>& column, StudyData& data) {
  const auto [least, most] = std::minmax_element(column.begin(), column.end());
  if (column.empty() || *least == *most) return;
  data.parameters.push_back(name);
  data.points.resize(column.size());
  for (std::size_t i = 0; i < column.size(); ++i) data.points[i].push_back(column[i]);
}

}  // namespace

StudyData dataOf(const results::StudyResults& results) {
  const results::StudyDescription& description = results.description();
  const auto& all = results.configurations();
  StudyData data;
  data.accuracy = description.accuracy;
  data.points.resize(all.size());
  for (std::size_t p = 0; p < description.parameters.size(); ++p) {
    std::vector<double> column;
    for (const auto& configuration : all) column.push_back(configuration.values[p]);
    if (description.parameters[p].formula.empty()) add(description.parameters[p].name, column, data);
  }
  data.values.resize(description.responses.size());
  for (const auto& response : description.responses) data.responses.push_back(response.name);
  for (const auto& configuration : all) {
    const results::ConfigurationResult* result = results.find(configuration.id);
    const auto responses = results.responses(configuration.id);
    for (std::size_t r = 0; r < responses.size(); ++r) {
      data.values[r].push_back(result && results::isSolved(result->status) ? responses[r] : none);
    }
  }
  return data;
}

StudyData readStudyData(const std::string& path) {
  const QuietHdf5 quiet;
  const Hdf5Source root = Hdf5Source::open(path);
  if (!root.hasAttribute("schema") || root.text("schema") != "harmos-study") {
    throw base::Error(path + " is not the file of a study.", base::ExitCode::input);
  }
  if (root.integer("schema_version") > studySchemaVersion) {
    throw base::Error(path + " was written by a newer version of Harmos.", base::ExitCode::input);
  }
  const Hdf5Source study = root.group(root.names().front());
  StudyData data;
  data.accuracy = study.number("accuracy");
  const Hdf5Source parameters = study.group("parameters");
  for (const std::string& name : parameters.texts("order")) {
    const Hdf5Source array = parameters.group(name);
    if (array.text("formula").empty()) add(name, array.values(), data);
  }
  const Hdf5Source responses = study.group("responses");
  data.responses = responses.texts("order");
  const std::vector<std::string> statuses = study.group("configurations").group("status").textValues();
  for (const std::string& name : data.responses) {
    std::vector<double>& values = data.values.emplace_back(responses.group(name).values());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto status = results::statusNamed(statuses[i]);  // none when open
      if (!status || !results::isSolved(*status)) values[i] = none;
    }
  }
  return data;
}

}  // namespace harmos::files
