#pragma once

#include <string>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>

namespace harmos::probability {

/// Throws base::Error (input) with the message unless the condition holds.
inline void require(bool condition, const std::string& message) {
  if (!condition) throw base::Error(message, base::ExitCode::input);
}

/// Throws base::Error unless 0 < u < 1; otherwise returns u.
inline double requireProbability(double u) {
  if (u > 0.0 && u < 1.0) return u;
  throw base::Error("a quantile needs a probability above 0 and below 1, not " + base::toText(u));
}

}  // namespace harmos::probability
