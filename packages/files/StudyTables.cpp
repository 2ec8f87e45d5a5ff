#include <harmos/files/detail/StudyTables.hpp>

#include <cmath>

#include <harmos/base/Numerals.hpp>
#include <harmos/files/AtomicFile.hpp>
#include <harmos/results/StatusName.hpp>

namespace harmos::files {

void writeStudyTable(const std::string& path, const results::StudyResults& results) {
  const results::StudyDescription& description = results.description();
  // Some names of a status hold a comma.
  const auto quoted = [](const std::string& name) {
    return name.find(',') == std::string::npos ? name : '"' + name + '"';
  };
  const auto cell = [](double value) { return "," + (std::isnan(value) ? "" : base::toText(value)); };
  std::string text = "id";
  for (const auto& parameter : description.parameters) text += "," + parameter.name;
  text += ",status,iterations,error_estimate,start";
  for (const auto& response : description.responses) text += "," + response.name;
  text += "\n";
  for (const design::Configuration& configuration : results.configurations()) {
    const results::ConfigurationResult* result = results.find(configuration.id);
    text += std::to_string(configuration.id);
    for (const double value : configuration.values) text += cell(value);
    if (result) {
      text += "," + quoted(results::statusName(result->status)) + "," + std::to_string(result->iterations) +
              cell(result->errorEstimate) + "," + std::to_string(result->starts.empty() ? 0 : result->starts.front());
    } else {
      text += ",open,,,";
    }
    for (const double value : results.responses(configuration.id)) text += cell(value);
    text += "\n";
  }
  replaceFile(path, text);
}

void writeDakotaTable(const std::string& path, const results::StudyResults& results) {
  const results::StudyDescription& description = results.description();
  std::string text = "%eval_id interface";
  for (const auto& parameter : description.parameters) text += " " + parameter.name;
  for (const auto& response : description.responses) text += " " + response.name;
  text += "\n";
  for (const design::Configuration& configuration : results.configurations()) {
    text += std::to_string(configuration.id) + " NO_ID";
    for (const double value : configuration.values) text += " " + base::toText(value);
    for (const double value : results.responses(configuration.id)) {
      text += " " + (std::isnan(value) ? "nan" : base::toText(value));
    }
    text += "\n";
  }
  replaceFile(path, text);
}

}  // namespace harmos::files
