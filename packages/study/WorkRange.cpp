#include <harmos/study/detail/WorkRange.hpp>

#include <cassert>
#include <sstream>

namespace harmos::study {

std::string toMessage(const WorkRange& range) {
  return std::to_string(range.operators) + " " + std::to_string(range.begin) + " " + std::to_string(range.end);
}

WorkRange rangeOf(const std::string& message) {
  WorkRange range;
  std::istringstream stream(message);
  stream >> range.operators >> range.begin >> range.end;
  assert(stream && "a message is what toMessage() has made");
  return range;
}

}  // namespace harmos::study
