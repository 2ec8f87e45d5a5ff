#pragma once

#include <exception>
#include <stdexcept>
#include <string>

/// What every package may use: errors, names and numbers in text, small vectors, matrices, clocks.
namespace harmos::base {

/// What a program that ends with this error returns to its caller.
///
/// input: what the user gave is wrong. notConverged: the accuracy was not reached.
/// noEquilibrium: the loads cannot be carried. failure: everything else.
enum class ExitCode { ok = 0, failure = 1, input = 2, notConverged = 3, noEquilibrium = 4 };

/// The one exception type that Harmos throws; its message is meant for the user, complete and without a stack.
class Error : public std::runtime_error {
 public:
  /// `message`: place, cause and remedy, without "error:" before it. `code`: how a program ends that does not catch it.
  explicit Error(const std::string& message, ExitCode code = ExitCode::failure)
      : std::runtime_error(message), code_(code) {}
  /// How a program ends that does not catch the error.
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// What to tell the user about an exception of any type: of a base::Error its message, of missing memory what helps.
std::string messageOf(const std::exception& error);
/// How a program ends that does not catch it.
ExitCode exitCodeOf(const std::exception& error);

}  // namespace harmos::base
