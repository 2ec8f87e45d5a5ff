#include <harmos/base/SoleThread.hpp>

#include <condition_variable>
#include <mutex>
#include <thread>

#include <harmos/base/Error.hpp>

namespace harmos::base {

namespace {

/// Who is inside, and how often.
struct Holder {
  std::mutex mutex;
  std::condition_variable isFree;
  std::thread::id thread;
  int count = 0;
};

Holder& holder() {
  static Holder one;
  return one;
}

}  // namespace

SoleThread::SoleThread(int ranks) {
  Holder& now = holder();
  std::unique_lock<std::mutex> lock(now.mutex);
  const auto isOurs = [&] { return now.count == 0 || now.thread == std::this_thread::get_id(); };
  if (ranks > 1 && !isOurs()) {
    throw Error(
        "A second thread asks a solver of Harmos on several ranks while another one is inside: Trilinos counts its "
        "references without locks here, and ranks whose threads come in another order would wait for ever.\n  Let "
        "threads take turns on all ranks alike, or solve on communicators of one rank.");
  }
  now.isFree.wait(lock, isOurs);
  now.thread = std::this_thread::get_id();
  ++now.count;
}

SoleThread::~SoleThread() {
  Holder& now = holder();
  const std::lock_guard<std::mutex> lock(now.mutex);
  if (--now.count == 0) now.isFree.notify_one();
}

}  // namespace harmos::base
