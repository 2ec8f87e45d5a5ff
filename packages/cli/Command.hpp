#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include <Teuchos_RCP.hpp>

#include <harmos/cli/Arguments.hpp>

namespace Teuchos {
template <typename Ordinal>
class Comm;
}

namespace harmos::cli {

/// What a command may use of its surroundings.
struct CommandEnvironment {
  Teuchos::RCP<const Teuchos::Comm<int>> communicator;
  std::ostream& out;                  // results that were asked for
  std::ostream& err;                  // progress and errors
  bool terminal = false;              // err is a terminal: progress may overwrite its line
  std::function<bool()> interrupted;  // asked between iterations, on every rank; may be empty

  bool isRoot() const;
};

/// One verb of the program.
struct Command {
  std::string name;
  std::string operands;  // as they stand in the help
  std::string summary;
  std::vector<CommandOption> options;
  std::vector<std::string> examples;
  std::function<int(const Arguments&, const CommandEnvironment&)> run;  // returns the exit code
};

}  // namespace harmos::cli
