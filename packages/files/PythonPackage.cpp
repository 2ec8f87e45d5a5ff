#include <harmos/files/PythonPackage.hpp>

#include <array>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <harmos/base/Error.hpp>

namespace harmos::files {

namespace {

namespace fs = std::filesystem;

constexpr const char* interpreter = "/usr/bin/python3";

/// Python puts a folder that it is told to run first on its module path: no other package of that name wins.
std::string packageFolder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path folder = program.parent_path().parent_path() / "share" / "harmos" / "python";
  if (!fs::exists(folder / "__main__.py", error)) {
    throw base::Error("The Python package of Harmos is not in " + folder.string() + ".");
  }
  return folder.string();
}

/// Where a child's output goes.
class Redirection {
 public:
  /// Into a file in memory, or nowhere else than that of this process.
  explicit Redirection(bool keepsErrors) {
    ::posix_spawn_file_actions_init(&actions_);
    if (!keepsErrors) return;
    memory_ = ::memfd_create("harmos", MFD_CLOEXEC);
    if (memory_ < 0) throw base::Error(std::string("Cannot keep what a script prints: ") + std::strerror(errno) + ".");
    ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, memory_, STDERR_FILENO);
  }
  ~Redirection() {
    ::posix_spawn_file_actions_destroy(&actions_);
    if (memory_ >= 0) ::close(memory_);
  }
  Redirection(const Redirection&) = delete;
  Redirection& operator=(const Redirection&) = delete;

  const ::posix_spawn_file_actions_t* actions() const { return &actions_; }

  /// What has been printed.
  std::string text() const {
    std::string result;
    if (memory_ < 0 || ::lseek(memory_, 0, SEEK_SET) != 0) return result;
    std::array<char, 4096> buffer{};
    for (::ssize_t count = 0; (count = ::read(memory_, buffer.data(), buffer.size())) > 0;)
      result.append(buffer.data(), static_cast<std::size_t>(count));
    return result;
  }

 private:
  ::posix_spawn_file_actions_t actions_{};
  int memory_ = -1;
};

/// Of a script that listens to signals which this process may have blocked.
class Attributes {
 public:
  Attributes() {
    ::posix_spawnattr_init(&attributes_);
    ::sigset_t none;
    ::sigemptyset(&none);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK);
  }
  ~Attributes() { ::posix_spawnattr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;

  const ::posix_spawnattr_t* get() const { return &attributes_; }

 private:
  ::posix_spawnattr_t attributes_{};
};

constexpr std::chrono::milliseconds betweenLooks{5};
// After which a script that was asked to end is ended.
constexpr std::chrono::milliseconds patience{600};

/// Lets a script remove what it was writing.
void end(::pid_t child) {
  ::kill(child, SIGTERM);
  const auto latest = std::chrono::steady_clock::now() + patience;
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > latest) {
      ::kill(child, SIGKILL);
      ::waitpid(child, &status, 0);
      return;
    }
    std::this_thread::sleep_for(betweenLooks);
  }
}

}  // namespace

ScriptEnd runPythonPackage(std::vector<std::string> words, const std::function<bool()>& interrupted, bool keepsErrors) {
  const std::string verb = words.empty() ? std::string() : words.front();
  words.insert(words.begin(), {interpreter, packageFolder()});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const Redirection redirection(keepsErrors);
  const Attributes attributes;
  ::pid_t child = 0;
  const int failure =
      ::posix_spawnp(&child, arguments[0], redirection.actions(), attributes.get(), arguments.data(), environ);
  if (failure != 0) throw base::Error("Cannot start " + words[0] + ": " + std::strerror(failure) + ".");
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (interrupted && interrupted()) {
      end(child);
      return {130, {}};
    }
    std::this_thread::sleep_for(betweenLooks);
  }
  if (WIFEXITED(status)) return {WEXITSTATUS(status), redirection.text()};
  throw base::Error("\"harmos " + verb + "\" was not finished: Python ended by a signal (" +
                    ::strsignal(WTERMSIG(status)) + ").");
}

}  // namespace harmos::files
