#include <harmos/files/HistoryFile.hpp>

#include <algorithm>

#include <harmos/base/Numerals.hpp>
#include <harmos/files/AtomicFile.hpp>
#include <harmos/files/detail/CsvText.hpp>

namespace harmos::files {

namespace {

const std::string ofMeshError = "_mesh_error";

}  // namespace

std::string meshErrorColumn(const std::string& response) {
  return response + ofMeshError;
}

bool headsAnotherColumn(const std::string& name, const std::function<bool(const std::string&)>& isResponse) {
  if (name == "step" || name == "time") return true;
  const std::size_t stem = name.size() - std::min(name.size(), ofMeshError.size());
  return name.substr(stem) == ofMeshError && isResponse(name.substr(0, stem));
}

void writeHistory(const std::string& path, const History& history) {
  std::string text = "step,time";
  for (const auto& name : history.responses) text += "," + quoted(name);
  for (const auto& error : history.meshErrors) text += "," + quoted(meshErrorColumn(error.response));
  // A column: programs that read tables know no other place for it.
  if (!history.units.empty()) text += "," + quoted("units: " + history.units);
  text += "\n";
  for (std::size_t row = 0; row < history.times.size(); ++row) {
    text += std::to_string(row) + "," + base::toText(history.times[row]);
    for (double value : history.values[row]) text += "," + base::toText(value);
    const bool isLast = row + 1 == history.times.size();
    for (const auto& error : history.meshErrors) text += "," + (isLast ? base::toText(error.relative) : "nan");
    if (!history.units.empty()) text += ",nan";
    text += "\n";
  }
  replaceFile(path, text);
}

}  // namespace harmos::files
