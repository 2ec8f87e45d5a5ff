#pragma once

#include <string>

namespace harmos::results {

/// Something about a study as a whole that its report shall say.
struct Note {
  std::string text;      // one sentence
  bool isUnmet = false;  // it says that the study falls short of what was asked for: `harmos study` does not end with 0
};

}  // namespace harmos::results
