#pragma once

#include <functional>
#include <string>
#include <vector>

#include <harmos/results/MeshErrorRecord.hpp>

namespace harmos::files {

/// The responses over the time steps.
struct History {
  std::vector<std::string> responses;                     // names
  std::vector<double> times;                              // one per row [time]; row 0 is the unloaded start
  std::vector<std::vector<double>> values;                // [row][response], each in its unit
  std::vector<results::MeshErrorRecord> meshErrors = {};  // of some responses, in the last row
  std::string units = {};  // length, force and time, as the scene declares them; empty: it does not
};

/// Head of the column with the error of the mesh of a response.
std::string meshErrorColumn(const std::string& response);

/// Whether another column of a history has `name` for its head; `isResponse` tells the names of its responses.
bool headsAnotherColumn(const std::string& name, const std::function<bool(const std::string&)>& isResponse);

/// Writes a CSV file "step,time,<response>,...,<response>_mesh_error,..." with one row per time step, counted from 0;
/// numbers read back exactly. Errors of the mesh are relative [-], and nan in all rows but the last. Declared
/// units head a column of their own, "units: mm N s", which is nan. Replaces an older file in one step; throws
/// base::Error when it cannot.
void writeHistory(const std::string& path, const History& history);

}  // namespace harmos::files
