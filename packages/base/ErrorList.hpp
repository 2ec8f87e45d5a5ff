#pragma once

#include <string>

namespace harmos::base {

/// Collects the errors of an input, so that the user sees all of them at once.
class ErrorList {
 public:
  /// `where` as from Parameters::where(); `what` and `repair` are complete sentences, the second may be empty.
  void add(const std::string& where, const std::string& what, const std::string& repair = "");
  int count() const { return count_; }
  /// Throws base::Error(ExitCode::input) with all errors, ended by "N errors; nothing was run.", if there are any.
  void throwIfAny() const;

 private:
  std::string text_;
  int count_ = 0;
};

}  // namespace harmos::base
