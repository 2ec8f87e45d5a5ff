#pragma once

#include <string>

#include <harmos/results/StudyResults.hpp>

namespace harmos::files {

/// Version of the layout below, in the attribute "schema_version" of the root.
constexpr int studySchemaVersion = 1;

/// Writes a study as HDF5; docs/guide/studies.md describes the layout. Replaces an older file in one step, so that a
/// reader finds a complete file at any time. `state` says how far the study is: running, complete, interrupted,
/// aborted. Throws base::Error when it cannot.
void writeStudyFile(const std::string& path, const results::StudyResults& results, const std::string& state);

}  // namespace harmos::files
