#pragma once

#include <string>
#include <vector>

namespace harmos::cli {

/// One option of a command; `value` names what follows it in the help and is empty for a switch.
struct CommandOption {
  std::string name;         // with its dashes
  std::string value;        // such as "DIR"; empty: a switch, which nothing follows
  std::string doc;          // one line for the help
  bool repeatable = false;  // may be given several times
};

/// The words after a command, split into options and the rest: "--name value", "--name=value", and "--" before words
/// that begin with a dash. A single dash is no option. Copies what it is given.
class Arguments {
 public:
  /// `command` stands in messages. Throws base::Error(ExitCode::input) for an unknown option, with the nearest known
  /// one, for a missing or empty value, for a value after a switch, and for a second use of what is not repeatable.
  Arguments(const std::string& command, const std::vector<std::string>& words,
            const std::vector<CommandOption>& options);

  /// Whether `option`, with its dashes, was given.
  bool has(const std::string& option) const { return !values(option).empty(); }
  /// What followed each use of `option`, in their order; empty texts for a switch; empty when it was not given.
  std::vector<std::string> values(const std::string& option) const;
  /// What followed the last use of `option`; `otherwise` when it was not given.
  std::string value(const std::string& option, const std::string& otherwise) const;
  /// The words that belong to no option, in their order.
  const std::vector<std::string>& operands() const { return operands_; }
  /// Throws base::Error(ExitCode::input) unless there are exactly as many operands as `names`, which stand in the
  /// message.
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
