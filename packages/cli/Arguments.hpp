#pragma once

#include <string>
#include <vector>

namespace harmos::cli {

/// One option of a command; `value` names what follows it in the help and is empty for a switch.
struct CommandOption {
  std::string name;  // with its dashes
  std::string value;
  std::string doc;
  bool repeatable = false;
};

/// The words after a command, split into options and the rest: "--name value", "--name=value", and "--" before words
/// that begin with a dash.
class Arguments {
 public:
  /// `command` stands in messages. Throws base::Error(ExitCode::input) for an unknown option, with the nearest known
  /// one, for a missing or empty value, for a value after a switch, and for a second use of what is not repeatable.
  Arguments(const std::string& command, const std::vector<std::string>& words,
            const std::vector<CommandOption>& options);

  bool has(const std::string& option) const { return !values(option).empty(); }
  std::vector<std::string> values(const std::string& option) const;
  std::string value(const std::string& option, const std::string& otherwise) const;
  const std::vector<std::string>& operands() const { return operands_; }
  /// Throws base::Error(ExitCode::input) unless there are exactly as many operands as `names`.
  void requireOperands(const std::vector<std::string>& names) const;

 private:
  struct Given {
    std::string option;
    std::string value;
  };
  std::string command_;
  std::vector<Given> given_;
  std::vector<std::string> operands_;
};

}  // namespace harmos::cli
