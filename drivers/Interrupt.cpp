#include "Interrupt.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include <pthread.h>
#include <unistd.h>

#include <harmos/files/AtomicFile.hpp>

namespace {

using Clock = std::chrono::steady_clock;

constexpr int exitCode = 130;
// From the signal until the process is ended by force: a second, less what that takes.
constexpr std::chrono::milliseconds untilAsked{800};
// The same when the calculation has stopped in time and writes what it has.
constexpr std::chrono::seconds untilWritten{10};

std::atomic<bool> interrupted = false;
std::atomic<bool> isStopping = false;

::sigset_t watchedSignals() {
  ::sigset_t signals;
  ::sigemptyset(&signals);
  ::sigaddset(&signals, SIGINT);
  ::sigaddset(&signals, SIGTERM);
  ::sigaddset(&signals, SIGUSR1);  // mpirun hands it on to the ranks, and waits for them
  return signals;
}

/// Waits for a signal in a thread of its own; it does nothing else.
void watch(bool isRankOfOpenMpi) {
  const ::sigset_t signals = watchedSignals();
  int number = 0;
  while (::sigwait(&signals, &number) != 0) {
  }
  interrupted = true;
  // A second signal ends the process at once.
  ::signal(number, SIG_DFL);
  ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  std::this_thread::sleep_for(untilAsked);
  // Asked to end its ranks, mpirun kills them a second later: what is not written by then would be left in parts.
  const bool isKilledSoon = isRankOfOpenMpi && number == SIGTERM;
  if (isStopping && !isKilledSoon) std::this_thread::sleep_for(untilWritten);
  harmos::files::removeUnfinished();
  ::_exit(exitCode);
}

}  // namespace

// Blocked in all threads, which inherit it, the signals reach nobody but watch(): METIS would take one that comes while
// it works for an error of its own.
void catchInterrupts() {
  // The write fails instead (EFBIG, EPIPE), so that results are not lost to a pipe that nobody reads.
  for (const int number : {SIGXFSZ, SIGPIPE}) ::signal(number, SIG_IGN);
  const ::sigset_t signals = watchedSignals();
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread(watch, std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr).detach();
}

bool wasInterrupted() {
  if (interrupted) isStopping = true;
  return interrupted;
}
