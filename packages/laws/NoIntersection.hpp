#pragma once

#include <string>

#include <harmos/laws/LawFailure.hpp>
#include <harmos/laws/NodeArrays.hpp>

namespace harmos::laws {

/// No point was found at which the graph of a law meets a line.
class NoIntersection : public LawFailure {
 public:
  /// `why`: a clause for the message.
  NoIntersection(const LocalLine& line, const NodeContext& at, const std::string& why);
};

}  // namespace harmos::laws
