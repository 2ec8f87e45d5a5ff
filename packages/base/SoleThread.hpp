#pragma once

namespace harmos::base {

/// As long as one lives, its thread alone may be inside of the solvers of this process.
///
/// Debian's Trilinos counts its references without locks (Teuchos without HAVE_TEUCHOS_THREAD_SAFE, Kokkos with serial
/// atomics), also those of objects that solvers share unseen, such as the default communicator: two threads at a time
/// would release memory too early, or never, without a sign. Threads that take turns do no harm. A thread may hold
/// several.
class SoleThread {
 public:
  /// Throws base::Error where another thread holds one.
  SoleThread();
  ~SoleThread();
  SoleThread(const SoleThread&) = delete;
  SoleThread& operator=(const SoleThread&) = delete;
};

}  // namespace harmos::base
