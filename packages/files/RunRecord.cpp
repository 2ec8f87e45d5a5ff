#include <harmos/files/RunRecord.hpp>

#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include <harmos/files/AtomicFile.hpp>
#include <harmos/files/Version.hpp>
#include <harmos/files/detail/SolutionJson.hpp>

namespace harmos::files {

namespace {

using Json = nlohmann::ordered_json;
constexpr const char* earlierRun = "earlier_run";

}  // namespace

std::string earlierRecord(const ResultFiles& files) {
  if (!std::filesystem::exists(files.parts)) return "";
  std::ifstream stream(files.record, std::ios::binary);
  const Json json = Json::parse(stream, nullptr, false);
  if (!json.is_object()) return "";
  if (json.contains(earlierRun)) return json[earlierRun].dump();
  const bool hasResults = json.contains("status") && json["status"] != "running" && json["status"] != "failed";
  return hasResults ? json.dump() : "";
}

std::string toJson(const RunRecord& record) {
  Json errors = Json::object();
  for (const auto& [name, value] : record.responseErrors) errors[name] = value;
  Json sizes = Json::object();
  for (const auto& [name, value] : record.responseSizes) sizes[name] = value;
  Json ranges = Json::object();
  for (const RecordedRange& range : record.responseRanges)
    ranges[range.response] = {{"lower", range.lower}, {"upper", range.upper}};
  Json meshErrors = Json::object(), energyShares = Json::object();
  for (const results::MeshErrorRecord& error : record.meshErrors) {
    meshErrors[error.response] = {{"change", error.change},
                                  {"relative", error.relative},
                                  {"word", error.word},
                                  {"parts", error.parts},
                                  {"reason", error.reason}};
  }
  for (const auto& [part, share] : record.meshEnergyShares) energyShares[part] = share;
  Json phases = Json::object();
  for (const auto& phase : record.phases)
    phases[phase.name] = {{"wall_seconds", phase.wallSeconds}, {"cpu_seconds", phase.cpuSeconds}};
  Json json = {{"program", "Harmos"},
               {"version", version()},
               {"scene", record.scene},
               {"units", record.units.empty() ? Json() : Json(record.units)},
               {"status", record.status},
               {"reason", record.reason},
               {"remarks", record.remarks},
               {"exit_code", record.exitCode ? Json(*record.exitCode) : Json()},
               {"accuracy", record.accuracy},
               {"error_estimate", record.errorEstimate},
               {"round_off_estimate", record.roundOffEstimate},
               {"response_error_estimates", errors},
               {"response_sizes", sizes},
               {"response_ranges", ranges},
               {"mesh_error_estimates", meshErrors},
               {"mesh_energy_shares", energyShares},
               {"last_step", toJson(record.solution)},
               {"steps", record.steps},
               {"solved_steps", record.solvedSteps},
               {"iterations", record.iterations},
               {"linear_stages", record.linearStages},
               {"ranks", record.ranks},
               {"wall_seconds", record.wallSeconds},
               {"cpu_seconds", record.cpuSeconds},
               {"phases", phases},
               {"warnings", record.warnings},
               {"cuts", record.cuts},
               {"peak_memory_bytes", record.peakMemory}};
  if (!record.earlier.empty()) json[earlierRun] = Json::parse(record.earlier, nullptr, false);
  // Text from the user may not be UTF-8; replacing what is not is better than failing after the solution.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void writeRunRecord(const std::string& path, const RunRecord& record) {
  replaceFile(path, toJson(record));
}

}  // namespace harmos::files
