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

/// The program `harmos`: its verbs, their options, and what they print.
namespace harmos::cli {

/// What a command may use of its surroundings. The streams must outlive it.
struct CommandEnvironment {
  Teuchos::RCP<const Teuchos::Comm<int>> communicator;  // of all ranks of the program; not null
  std::ostream& out;                                    // results that were asked for
  std::ostream& err;                                    // progress and errors
  bool terminal = false;                                // err is a terminal: progress may overwrite its line
  std::function<bool()> interrupted;                    // asked between iterations, on every rank; may be empty

  /// Whether this is rank 0, which does all printing.
  bool isRoot() const;
};

/// One verb of the program.
struct Command {
  std::string name;                    // the word after `harmos`, at most 9 letters
  std::string operands;                // as they stand in the help
  std::string summary;                 // one sentence for the help
  std::vector<CommandOption> options;  // --help is added to them
  std::vector<std::string> examples;   // command lines; at least one, which stands in the help of the program
  /// Returns the exit code. Collective over the communicator of the environment.
  std::function<int(const Arguments&, const CommandEnvironment&)> run;
};

}  // namespace harmos::cli
