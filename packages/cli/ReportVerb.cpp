#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <thread>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <harmos/base/Error.hpp>
#include <harmos/cli/detail/Verbs.hpp>

namespace harmos::cli {

namespace {

namespace fs = std::filesystem;

// Debian's, which has the libraries that the report needs.
constexpr const char* interpreter = "/usr/bin/python3";

/// The folder of the Python package lies at the same place relative to the program when built and when installed.
/// Python puts a folder that it is told to run first on its module path: no other package of that name wins.
fs::path packagePath() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  fs::path folder = program.parent_path().parent_path() / "share" / "harmos" / "python";
  const fs::path script = folder / "__main__.py";
  if (!fs::exists(script, error)) throw base::Error("The script of the report is not at " + script.string() + ".");
  return folder;
}

/// The exit code of the script, which an interruption ends.
int runScript(std::vector<std::string> words, const CommandEnvironment& environment) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::pid_t child = 0;
  const int failure = ::posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ);
  if (failure != 0) throw base::Error("Cannot start " + words[0] + ": " + std::strerror(failure) + ".");
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (environment.interrupted && environment.interrupted()) {
      ::kill(child, SIGKILL);
      ::waitpid(child, &status, 0);
      return 130;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  throw base::Error(std::string("The report was not finished: Python ended by a signal (") +
                    ::strsignal(WTERMSIG(status)) + ").");
}

int report(const Arguments& arguments, const CommandEnvironment& environment) {
  arguments.requireOperands({"STUDY.h5"});
  if (!environment.isRoot()) return 0;
  const std::string study = arguments.operands()[0];
  if (!fs::exists(study)) throw base::Error("Cannot read " + study + ": there is no such file.", base::ExitCode::input);
  const std::string page = arguments.value("--output", fs::path(study).replace_extension(".html").string());
  std::vector<std::string> words = {interpreter, packagePath().string(), study, page};
  for (const std::string option : {"--abscissa", "--pictures"}) {
    if (arguments.has(option)) words.insert(words.end(), {option, arguments.value(option, "")});
  }
  return runScript(std::move(words), environment);
}

}  // namespace

Command reportCommand() {
  return {"report",
          "STUDY.h5",
          "Write one HTML file with the pictures and tables of a study.",
          {{"--output", "FILE.html", "the page (default: beside the study, with its name)"},
           {"--abscissa", "CURVE", "draw the other curves against this one (default: against time)"},
           {"--pictures", "DIR", "write the pictures there as well, as PNG files"}},
          {"harmos report results/bolted_joint_study.h5 --abscissa u_load"},
          report};
}

}  // namespace harmos::cli
