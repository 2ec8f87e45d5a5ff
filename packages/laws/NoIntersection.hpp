#pragma once

#include <string>

#include <harmos/base/Error.hpp>
#include <harmos/laws/NodeArrays.hpp>

namespace harmos::laws {

/// No point was found at which the graph of a law meets a line. The solver says at which interface and load step.
class NoIntersection : public base::Error {
 public:
  /// `why`: a clause for the message.
  NoIntersection(const LocalLine& line, const NodeContext& at, const std::string& why);
};

}  // namespace harmos::laws
