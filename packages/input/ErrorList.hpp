#pragma once

#include <functional>
#include <string>

#include <harmos/base/Error.hpp>

namespace harmos::input {

/// All errors of an input.
class InputErrors : public base::Error {
 public:
  /// `closing` says what became of the input.
  InputErrors(const std::string& list, const std::string& closing)
      : base::Error(list + "\n" + closing, base::ExitCode::input), list_(list) {}
  /// Without the closing line, to be nested in a message about something else.
  const std::string& list() const { return list_; }

 private:
  std::string list_;
};

/// Collects the errors of an input, so that the user sees all of them at once, in the order in which they were added;
/// of more than a hundred the first hundred.
class ErrorList {
 public:
  /// Adds an error, "where: what" and, indented below it, `repair`. `where` as from Parameters::where(); `what` and
  /// `repair` are complete sentences, the second may be empty.
  void add(const std::string& where, const std::string& what, const std::string& repair = "");
  /// Runs `action`; a base::Error (input) that it throws becomes an error at `where`
  /// (or at a place of its own, when it begins with one: the same file, or "--set"). Returns whether there was none.
  /// Passes on every other exception, also a base::Error of another code.
  bool collect(const std::string& where, const std::function<void()>& action);
  /// How many errors were added.
  int count() const { return count_; }
  /// The errors, ended by "N errors; nothing was run."; empty when there are none.
  std::string message() const;
  /// Throws InputErrors with message(), if there are any.
  void throwIfAny() const;

 private:
  std::string closing() const;

  std::string text_;  // ends with a line break
  int count_ = 0;
};

}  // namespace harmos::input
