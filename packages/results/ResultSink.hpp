#pragma once

#include <string>

#include <harmos/results/ConfigurationResult.hpp>
#include <harmos/results/Note.hpp>

namespace harmos::results {

/// Receives results as they come. A configuration may be reported again, with a better result that replaces the first.
class ResultSink {
 public:
  virtual ~ResultSink() = default;
  /// What is known of one configuration; replaces an earlier result of the same id.
  virtual void record(const ConfigurationResult& result) = 0;
  /// Something about the study as a whole that its report shall say, such as how its estimates were calibrated. A later
  /// note of the same name replaces the first.
  virtual void note(const std::string& /*name*/, const Note& /*note*/) {}
};

}  // namespace harmos::results
