#include <harmos/base/SoleThread.hpp>

#include <mutex>
#include <thread>

#include <harmos/base/Error.hpp>

namespace harmos::base {

namespace {

/// Who is inside, and how often.
struct Holder {
  std::mutex mutex;
  std::thread::id thread;
  int count = 0;
};

Holder& holder() {
  static Holder one;
  return one;
}

}  // namespace

SoleThread::SoleThread() {
  Holder& now = holder();
  const std::lock_guard<std::mutex> lock(now.mutex);
  if (now.count > 0 && now.thread != std::this_thread::get_id()) {
    throw Error(
        "A second thread asks a solver of Harmos while another one is inside: Trilinos counts its references without "
        "locks here.\n  Let threads take turns, or solve on ranks, each group with a communicator of its own.");
  }
  now.thread = std::this_thread::get_id();
  ++now.count;
}

SoleThread::~SoleThread() {
  Holder& now = holder();
  const std::lock_guard<std::mutex> lock(now.mutex);
  --now.count;
}

}  // namespace harmos::base
