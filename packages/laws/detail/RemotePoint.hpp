#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include <harmos/base/Error.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/laws/FaceMotions.hpp>

namespace harmos::laws {

/// Declares the point that the six numbers of a face are about.
inline void describeRemotePoint(input::ParameterSpec& p) {
  p.numbers("Point").unit("length").optional().doc("Reference point; absent: the centre of the face.");
}

/// The point that is given, with z = 0 in the plane.
inline std::optional<base::Vector3> remotePointOf(const input::Parameters& p) {
  if (!p.has("Point")) return std::nullopt;
  const std::vector<double>& given = p.numbers("Point");
  if (given.size() != 2 && given.size() != 3) {
    throw base::Error(p.where("Point") + ": a point has 2 numbers in the plane and 3 in space, " +
                          std::to_string(given.size()) + " are given.",
                      base::ExitCode::input);
  }
  base::Vector3 point{};
  std::copy(given.begin(), given.end(), point.begin());
  return point;
}

}  // namespace harmos::laws
