#pragma once

#include <string>

#include <harmos/results/SurfaceData.hpp>

namespace harmos::files {

/// Reads what response surfaces are made of from the first study of an HDF5 file that a StudyWriter has written. Throws
/// base::Error (input) when it is none, or one of a newer version of Harmos.
results::SurfaceData readSurfaceData(const std::string& path);

}  // namespace harmos::files
