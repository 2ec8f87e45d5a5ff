#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace harmos::base {

/// The name among `known` that `given` was probably meant to be; empty when none is near.
///
/// Nearness is the number of letters inserted, deleted, replaced or swapped with their neighbour, upper and lower case
/// being equal; up to one plus a quarter of the length of `given` is near, if it
/// is less than the length of the name. Of equally near names it is the first. Failing that, the only name that
/// contains `given`, if this has 3 letters or more. Source: Damerau (1964), doi:10.1145/363958.363994, at most one swap
/// per pair of letters.
std::string nearestName(const std::string& given, const std::vector<std::string>& known);

/// The text between double quotes, for names in messages; quotes inside are not escaped.
inline std::string quoted(const std::string& text) {
  return "\"" + text + "\"";
}

/// "a, b, c"; of more than `most` names the first `most` and how many are left: "a, b and 3 more".
std::string joinNames(const std::vector<std::string>& names, std::size_t most = 12);

/// What to tell a user who gave an unknown name: "Did you mean "x"? <kind>: a, b, c." or, when there are no names,
/// "<kind>: none."
std::string suggestName(const std::string& given, const std::vector<std::string>& known, const std::string& kind);

}  // namespace harmos::base
