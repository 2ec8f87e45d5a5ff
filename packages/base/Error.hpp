#pragma once

#include <stdexcept>
#include <string>

namespace harmos::base {

/// What a program that ends with this error returns to its caller.
enum class ExitCode { ok = 0, failure = 1, input = 2, notConverged = 3, noEquilibrium = 4 };

/// The one exception type that Harmos throws; its message is meant for the user, complete and without a stack.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message, ExitCode code = ExitCode::failure)
      : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace harmos::base
