#pragma once

#include <string>
#include <vector>

namespace harmos::input {

/// The value of a formula, see Formula, of which not all names are known: `values` of the names in their order, NaN for
/// any number. A result that is no NaN is the value whatever these numbers are, provided that there is one: 0 times a
/// number is 0. NaN also where it takes more than that to tell, as with "?:". Throws mu::ParserError for what is no
/// formula.
double knownValue(const std::string& text, const std::vector<std::string>& names, std::vector<double> values);

}  // namespace harmos::input
