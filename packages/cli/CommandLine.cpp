#include <harmos/cli/CommandLine.hpp>

#include <algorithm>
#include <ostream>
#include <sstream>

#include <Teuchos_Comm.hpp>

#include <harmos/base/AllRanks.hpp>
#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/cli/detail/ReferencePages.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/files/Version.hpp>

namespace harmos::cli {

namespace {

/// In columns, for a terminal.
std::string exitCodes() {
  constexpr std::size_t column = 7, width = 112;
  std::string text = "Exit codes:\n";
  for (const ExitCodeMeaning& each : exitCodeMeanings()) {
    std::string line = "  " + std::to_string(each.code);
    line.resize(column, ' ');
    std::istringstream words(each.meaning);
    for (std::string word; words >> word;) {
      if (line.size() > column && line.size() + word.size() >= width) {
        text += line + "\n";
        line = std::string(column, ' ');
      }
      line += (line.size() > column ? " " : "") + word;
    }
    text += line + "\n";
  }
  return text;
}

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
  out << "  mpirun -np 2 harmos run xml/bolted_joint.xml\n\n" << exitCodes();
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
  out << "\n" << exitCodes();
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

/// A full disk shows only when the last characters leave.
void demandPrinted(std::ostream& out) {
  if (out.flush()) return;
  throw base::Error("The output cannot be written: the disk is full, or whoever reads it has gone.");
}

}  // namespace

std::vector<Command> commands() {
  return {runCommand(),   checkCommand(),  docCommand(),     meshCommand(),   compareCommand(),
          studyCommand(), reportCommand(), predictCommand(), importCommand(), pictureCommand(),
          showCommand(),  exportCommand(), tradeCommand()};
}

int runCommandLine(const std::vector<std::string>& words, const CommandEnvironment& environment) {
  const auto program = [&] {
    const int code = dispatch(words, environment);
    if (environment.isRoot()) demandPrinted(environment.out);
    return code;
  };
  return base::runOnAllRanks(*environment.communicator, program, environment.err);
}

}  // namespace harmos::cli
