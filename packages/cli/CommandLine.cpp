#include <harmos/cli/CommandLine.hpp>

#include <algorithm>
#include <ostream>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/cli/detail/Rendezvous.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/files/Version.hpp>

namespace harmos::cli {

namespace {

// Seconds between the first and the last rank that meet the same error.
constexpr double patience = 5.0;

const char* const exitCodes =
    "Exit codes:\n"
    "  0    done; for run and study: all solutions are as accurate as asked for\n"
    "  1    failure, the message says which; for compare: the files are different\n"
    "  2    the input or the command line is wrong, nothing was run or written\n"
    "  3    not converged: iteration limit or stagnation; for study: some configurations have no solution, a "
    "tolerance\n"
    "       of the design was not reached, or an audit found a larger error than was accepted\n"
    "  4    no equilibrium exists under the given loads, or no path leads to it; for study: of some configurations, "
    "all\n"
    "       others are solved\n"
    "  130  interrupted; what was written is readable\n";

void printIndented(std::ostream& out, const std::vector<std::string>& lines) {
  for (const auto& line : lines) out << "  " << line << "\n";
}

void printHelp(std::ostream& out, const std::vector<Command>& all) {
  out << "Usage: harmos COMMAND [options]\n\n"
         "Solves assemblies of elastic parts joined by contacts, friction, bolts and glue by the LATIN method.\n\n"
         "Commands:\n";
  for (const auto& command : all)
    out << "  " << command.name << std::string(10 - command.name.size(), ' ') << command.summary << "\n";
  out << "\n\"harmos COMMAND --help\" explains one of them; \"harmos --version\" prints the version.\n\nExamples:\n";
  for (const auto& command : all) printIndented(out, {command.examples.front()});
  out << "  mpirun -np 2 harmos run xml/bolted_joint.xml\n\n" << exitCodes;
}

void printHelp(std::ostream& out, const Command& command) {
  out << "Usage: harmos " << command.name << " " << command.operands << " [options]\n\n"
      << command.summary << "\n\nOptions:\n";
  for (const auto& option : command.options) {
    const std::string left = option.name + (option.value.empty() ? "" : " " + option.value);
    out << "  " << left << std::string(left.size() < 24 ? 24 - left.size() : 1, ' ') << option.doc << "\n";
  }
  out << "\nExamples:\n";
  printIndented(out, command.examples);
  out << "\n" << exitCodes;
}

int dispatch(const std::vector<std::string>& words, const CommandEnvironment& environment) {
  const auto all = commands();
  if (words.empty() || words[0] == "--help" || words[0] == "-h" || words[0] == "help") {
    if (environment.isRoot()) printHelp(words.empty() ? environment.err : environment.out, all);
    return static_cast<int>(words.empty() ? base::ExitCode::input : base::ExitCode::ok);
  }
  if (words[0] == "--version") {
    if (environment.isRoot()) environment.out << "harmos " << files::version() << "\n";
    return 0;
  }
  const auto command = std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.name == words[0]; });
  if (command == all.end()) {
    std::vector<std::string> names;
    for (const auto& c : all) names.push_back(c.name);
    throw base::Error("harmos: unknown command \"" + words[0] + "\". " + base::suggestName(words[0], names, "Commands"),
                      base::ExitCode::input);
  }
  auto options = command->options;
  options.push_back({"--help", "", "", true});
  const Arguments arguments("harmos " + command->name, {words.begin() + 1, words.end()}, options);
  if (arguments.has("--help")) {
    if (environment.isRoot()) printHelp(environment.out, *command);
    return 0;
  }
  return command->run(arguments, environment);
}

}  // namespace

std::vector<Command> commands() {
  return {runCommand(),     checkCommand(), docCommand(),    meshCommand(),
          compareCommand(), studyCommand(), reportCommand(), predictCommand()};
}

int runCommandLine(const std::vector<std::string>& words, const CommandEnvironment& environment) {
  const Rendezvous rendezvous(*environment.communicator);
  try {
    return dispatch(words, environment);
  } catch (const base::Error& error) {
    int code = static_cast<int>(error.code());
    // Input is read by every rank, so that every rank arrives here with the same error.
    if (error.code() != base::ExitCode::input) {
      if (!rendezvous.allCome(patience)) throw;
      Teuchos::broadcast(*environment.communicator, 0, Teuchos::outArg(code));
    }
    if (environment.isRoot()) environment.err << error.what() << "\n";
    return code;
  }
}

}  // namespace harmos::cli
