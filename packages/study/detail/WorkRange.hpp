#pragma once

#include <cstddef>
#include <string>

namespace harmos::study {

/// A range of configurations that share operators, which a team solves at once.
struct WorkRange {
  std::size_t operators = 0;       // position of the operators among those of the study
  std::size_t begin = 0, end = 0;  // of the configurations with them that were open at first

  bool operator==(const WorkRange& other) const {
    return operators == other.operators && begin == other.begin && end == other.end;
  }
};

/// As it is sent to another rank.
std::string toMessage(const WorkRange& range);
WorkRange rangeOf(const std::string& message);

}  // namespace harmos::study
