#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace harmos::cli {

/// Prints what an input says without effect, a line per sentence, and how many they are; nothing when there are none.
void printWarnings(std::ostream& out, const std::vector<std::string>& warnings);

}  // namespace harmos::cli
