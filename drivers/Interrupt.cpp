#include "Interrupt.hpp"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

#include <semaphore.h>
#include <unistd.h>

#include <harmos/files/AtomicFile.hpp>

namespace {

using Clock = std::chrono::steady_clock;

constexpr int exitCode = 130;
// From the signal until the process is ended by force: a second, less what that takes.
constexpr std::chrono::milliseconds untilAsked{800};
// The same when the calculation has stopped in time and writes what it has.
constexpr std::chrono::seconds untilWritten{10};

volatile std::sig_atomic_t interrupted = 0;
std::atomic<bool> isStopping = false;
::sem_t signalled;

extern "C" void rememberInterrupt(int number) {
  interrupted = 1;
  std::signal(number, SIG_DFL);
  ::sem_post(&signalled);
}

/// Waits for a signal in a thread of its own; it does nothing else.
void watch() {
  while (::sem_wait(&signalled) != 0 && errno == EINTR) {
  }
  std::this_thread::sleep_for(untilAsked);
  if (isStopping) std::this_thread::sleep_for(untilWritten);
  harmos::files::removeUnfinished();
  ::_exit(exitCode);
}

}  // namespace

void catchInterrupts() {
  static const bool isWatched = [] {
    ::sem_init(&signalled, 0, 0);
    std::thread(watch).detach();
    return true;
  }();
  static_cast<void>(isWatched);
  if (interrupted != 0) return;
  std::signal(SIGINT, rememberInterrupt);
  std::signal(SIGTERM, rememberInterrupt);
}

bool wasInterrupted() {
  if (interrupted != 0) isStopping = true;
  return interrupted != 0;
}
