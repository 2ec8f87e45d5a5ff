#pragma once

#include <string>

#include <harmos/results/StudyResults.hpp>

namespace harmos::files {

/// Writes a CSV file with one row per configuration: id, parameters, status ("open" when it was not reached),
/// iterations, error estimate, id of the first start (0: cold), responses; what is not known is left empty. Numbers
/// read back exactly. Replaces an older file in one step; throws base::Error when it cannot.
void writeStudyTable(const std::string& path, const results::StudyResults& results);

/// Writes the annotated tabular format of Dakota: "%eval_id interface", parameters, responses; "nan" where there is no
/// solution. Otherwise as writeStudyTable().
void writeDakotaTable(const std::string& path, const results::StudyResults& results);

}  // namespace harmos::files
