#pragma once

#include <string>
#include <vector>

#include <harmos/input/Documentation.hpp>
#include <harmos/laws/LawRegistry.hpp>

namespace harmos::cli {

/// What the program says by ending.
struct ExitCodeMeaning {
  int code;             // as the shell sees it
  std::string meaning;  // in one sentence
};

/// All exit codes, ascending.
std::vector<ExitCodeMeaning> exitCodeMeanings();

/// Pages of the reference that no list of an input has: all laws with equation and source, the fields of the results
/// with those that laws add, the exit codes.
std::vector<input::Page> referencePages(const laws::LawRegistry& laws);

}  // namespace harmos::cli
