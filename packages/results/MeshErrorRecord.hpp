#pragma once

#include <string>
#include <vector>

namespace harmos::results {

/// What the mesh is estimated to do to a response, at the last load step.
struct MeshErrorRecord {
  std::string response;            // name
  double change = 0.0;             // converged value less that on this mesh, in the unit of the response
  double relative = 0.0;           // |change| over the converged value
  std::string word;                // estimated, uncertain, near sliding, too coarse, locks
  std::vector<std::string> parts;  // whose elements bring most of it
  std::string reason = {};         // of the word "near sliding", or why parts lock; else empty
};

/// Such an error below this share is not told from nothing.
constexpr double negligibleMeshError = 0.005;

/// "9 %": as it is, with the one digit that such an estimate has. `share` > 0.
std::string percentage(double share);

/// A relative error of a mesh in words: "below 0.5 %", else "about 9 %".
std::string meshErrorInWords(double relative);

/// The same of several: "about 9 to 20 %", "up to 9 %", or as of one where all are alike. `least` <= `most`.
std::string meshErrorInWords(double least, double most);

}  // namespace harmos::results
