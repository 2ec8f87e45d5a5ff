#pragma once

namespace harmos::base {

/// As long as one lives, its thread alone is inside of the solvers of this process; others wait for their turn.
///
/// Debian's Trilinos counts its references without locks (Teuchos without HAVE_TEUCHOS_THREAD_SAFE, Kokkos with serial
/// atomics), also those of objects that solvers share unseen, such as the default communicator: two threads at a time
/// would release memory too early, or never, without a sign. Solvers take their turn themselves. A thread of a host
/// that makes, copies or drops matrices and communicators of Trilinos meanwhile holds one, too. A thread may hold
/// several; it must not wait for another thread that wants one.
class SoleThread {
 public:
  /// Waits until no other thread holds one. `ranks`: processes that have to come here together. More than one could
  /// wait for each other for ever, each with another thread inside: instead of waiting, it throws base::Error then.
  explicit SoleThread(int ranks = 1);
  ~SoleThread();
  SoleThread(const SoleThread&) = delete;
  SoleThread& operator=(const SoleThread&) = delete;
};

}  // namespace harmos::base
