#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace harmos::base {

/// The name among `known` that `given` was probably meant to be; empty when none is near.
///
/// Nearness is the number of letters inserted, deleted, replaced or swapped with their neighbour, upper and lower case
/// being equal; up to one plus a quarter of the length of `given` is near. Failing that, the only name that contains
/// `given`.
std::string nearestName(const std::string& given, const std::vector<std::string>& known);

/// For names in messages.
inline std::string quoted(const std::string& text) {
  return "\"" + text + "\"";
}

/// "a, b, c"; of very many names the first `most` and how many are left.
std::string joinNames(const std::vector<std::string>& names, std::size_t most = 12);

/// What to tell a user who gave an unknown name: "Did you mean "x"? <kind>: a, b, c." or, when there are no names,
/// "<kind>: none."
std::string suggestName(const std::string& given, const std::vector<std::string>& known, const std::string& kind);

}  // namespace harmos::base
