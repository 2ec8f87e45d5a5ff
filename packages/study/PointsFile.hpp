#pragma once

#include <string>
#include <vector>

namespace harmos::study {

/// Reads points from a CSV file: the header names all of `parameters`, in any order, each further row holds one point.
/// Blank lines are passed over. Returns a row per point with columns in the order of `parameters`, in their units.
/// Throws one base::Error (input) that lists all errors with their lines.
std::vector<std::vector<double>> readPoints(const std::string& path, const std::vector<std::string>& parameters);

}  // namespace harmos::study
