#pragma once

#include <harmos/study/ConfigurationResult.hpp>

namespace harmos::study {

/// Receives results as they come. A configuration may be reported again, with a better result that replaces the first.
class ResultSink {
 public:
  virtual ~ResultSink() = default;
  virtual void record(const ConfigurationResult& result) = 0;
};

}  // namespace harmos::study
