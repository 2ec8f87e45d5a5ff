#include <harmos/files/detail/ForeignReading.hpp>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>

namespace harmos::files {

namespace {

// What a sound file may take. The libraries read over 100 MB/s; a mesh takes a few times the bytes of its file, and
// more where these are compressed.
constexpr double secondsPerFile = 5.0, secondsPerByte = 1e-6;
constexpr double bytesPerFile = 1e9, bytesPerByte = 100.0;
// Time until a child that waits for something is ended, in multiples of the processor time that it may take: the file
// may lie on a slow disk.
constexpr double waiting = 20.0;
// Of the processor, until it is ended by force after it was told to end [s].
constexpr rlim_t grace = 1;

struct Limits {
  double seconds;  // of processor time
  double bytes;    // of memory, beyond what this process has
};

Limits limitsFor(const std::vector<std::string>& paths) {
  double size = 0.0;
  for (const std::string& path : paths) {
    std::error_code isMissing;
    const auto bytes = std::filesystem::file_size(path, isMissing);
    if (!isMissing) size += static_cast<double>(bytes);
  }
  return {secondsPerFile + secondsPerByte * size, bytesPerFile + bytesPerByte * size};
}

double addressSpace() {
  std::ifstream stream("/proc/self/statm");
  double pages = 0.0;
  stream >> pages;
  return pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

void limit(int resource, double amount, rlim_t more = 0) {
  struct ::rlimit old {};
  ::getrlimit(static_cast<__rlimit_resource>(resource), &old);
  const auto soft = std::min(static_cast<rlim_t>(amount), old.rlim_cur);
  const struct ::rlimit now { soft, std::min(soft + more, old.rlim_max) };
  ::setrlimit(static_cast<__rlimit_resource>(resource), &now);
}

/// A crash ends the child and prints nothing; an interruption is the business of the parent, with which the child dies.
void settle(const Limits& limits) {
  for (const int number : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXCPU, SIGALRM}) std::signal(number, SIG_DFL);
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, SIG_IGN);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit(RLIMIT_CORE, 0.0);
  limit(RLIMIT_CPU, limits.seconds, grace);
  ::alarm(static_cast<unsigned>(waiting * limits.seconds));
  limit(RLIMIT_AS, addressSpace() + limits.bytes);
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
}

enum Ending : int { done = 0, failed = 1, damaged = 2, tooLarge = 3 };

/// Leaves an error instead of what was read; the parent sees to it that there is all of it.
void leave(const base::Error& error, int descriptor) {
  if (::ftruncate(descriptor, 0) != 0 || ::lseek(descriptor, 0, SEEK_SET) != 0) ::_exit(damaged);
  ByteWriter writer(descriptor);
  writer.put(error.code());
  writer.put(std::string(error.what()));
  writer.flush();
}

/// What the child does; never returns.
[[noreturn]] void readInChild(int descriptor, const Limits& limits, const std::function<void(ByteWriter&)>& read) {
  settle(limits);
  int ending = done;
  try {
    ByteWriter writer(descriptor);
    read(writer);
    writer.flush();
  } catch (const base::Error& error) {
    leave(error, descriptor);
    ending = failed;
  } catch (const std::bad_alloc&) {
    ending = tooLarge;
  } catch (const std::length_error&) {
    ending = tooLarge;
  } catch (...) {
    ending = damaged;
  }
  // Nothing of this process is to end as if it were the program: no destructors, no MPI_Finalize.
  ::_exit(ending);
}

int waitFor(::pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/// Why a child that did not end by itself has ended; in the words of a user.
std::string causeOf(int status) {
  if (!WIFSIGNALED(status)) {
    return WEXITSTATUS(status) == tooLarge ? "it asks for more memory than a sound file of its size"
                                           : "what stands in it does not fit together";
  }
  const int number = WTERMSIG(status);
  if (number == SIGXCPU || number == SIGKILL || number == SIGALRM) return "reading it does not end";
  return std::string("reading it fails (") + ::strsignal(number) + ")";
}

/// Bytes that the child has left, as long as it lives.
class Mapping {
 public:
  explicit Mapping(int descriptor)
      : size_(static_cast<std::size_t>(std::max<::off_t>(0, ::lseek(descriptor, 0, SEEK_END)))) {
    if (size_ == 0) return;
    bytes_ = ::mmap(nullptr, size_, PROT_READ, MAP_SHARED, descriptor, 0);
    if (bytes_ == MAP_FAILED)
      throw base::Error(std::string("Cannot take what was read: ") + std::strerror(errno) + ".");
  }
  ~Mapping() {
    if (size_ > 0 && bytes_ != MAP_FAILED) ::munmap(bytes_, size_);
  }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  ByteReader reader() const { return {static_cast<const char*>(bytes_), size_}; }

 private:
  std::size_t size_;
  void* bytes_ = nullptr;
};

/// Closes a descriptor.
struct Descriptor {
  int number;
  explicit Descriptor(int opened) : number(opened) {}
  ~Descriptor() { ::close(number); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
};

}  // namespace

void readForeign(const std::vector<std::string>& paths, const std::function<void(ByteWriter&)>& read,
                 const std::function<void(ByteReader&)>& take) {
  const std::string names = base::joinNames(paths);
  const Limits limits = limitsFor(paths);
  const Descriptor memory(::memfd_create("harmos", MFD_CLOEXEC));
  const ::pid_t child = memory.number < 0 ? -1 : ::fork();
  if (child == 0) readInChild(memory.number, limits, read);
  if (child < 0) throw base::Error("Cannot start a process that reads " + names + ": " + std::strerror(errno) + ".");
  const int status = waitFor(child);
  if (!WIFEXITED(status) || WEXITSTATUS(status) > failed) {
    throw base::Error("Cannot read " + names + ": it is damaged: " + causeOf(status) + ".", base::ExitCode::input);
  }
  const Mapping mapping(memory.number);
  ByteReader reader = mapping.reader();
  if (WEXITSTATUS(status) == failed) {
    const auto code = reader.get<base::ExitCode>();
    throw base::Error(reader.get<std::string>(), code);
  }
  take(reader);
}

}  // namespace harmos::files
