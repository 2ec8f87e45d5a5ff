#include <harmos/base/AllRanks.hpp>

#include <algorithm>
#include <limits>
#include <ostream>
#include <string>
#include <utility>

#include <mpi.h>
#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_DefaultMpiComm.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/detail/Rendezvous.hpp>

namespace harmos::base {

namespace {

// Seconds that a rank with an error waits for the others, which may have met the same one or be waiting for it.
constexpr double patience = 5.0;

std::size_t firstFailure(const std::vector<int>& failures) {
  const auto failed = std::find_if(failures.begin(), failures.end(), [](int failure) { return failure != 0; });
  return static_cast<std::size_t>(failed - failures.begin());
}

/// Throws on all ranks an error whose code all have and whose message rank `from` has. Collective.
[[noreturn]] void throwOf(const Teuchos::Comm<int>& comm, int from, int code, std::string message) {
  int length = static_cast<int>(message.size());
  Teuchos::broadcast(comm, from, Teuchos::outArg(length));
  message.resize(length);
  Teuchos::broadcast(comm, from, length, message.data());
  throw Error(message, static_cast<ExitCode>(code));
}

}  // namespace

int runOnAllRanks(const Teuchos::Comm<int>& comm, const std::function<int()>& program, std::ostream& err) {
  const Rendezvous rendezvous(comm);
  try {
    const int code = program();
    const std::vector<int> failures = *rendezvous.meet(0, std::numeric_limits<double>::infinity());
    const std::size_t failed = firstFailure(failures);
    return failed == failures.size() ? code : failures[failed];
  } catch (const std::exception& error) {
    const int code = static_cast<int>(exitCodeOf(error));
    const auto failures = rendezvous.meet(code, patience);
    if (!failures) {
      err << "rank " << comm.getRank() << ": " << messageOf(error) << std::endl;
      MPI_Abort(*dynamic_cast<const Teuchos::MpiComm<int>&>(comm).getRawMpiComm(), code);
      return code;
    }
    const std::size_t failed = firstFailure(*failures);
    if (static_cast<int>(failed) == comm.getRank()) err << messageOf(error) << std::endl;
    return (*failures)[failed];
  }
}

void onFirstRank(const Teuchos::Comm<int>& comm, const std::function<void()>& action) {
  int code = 0;
  std::string message;
  if (comm.getRank() == 0) {
    try {
      action();
    } catch (const std::exception& error) {
      code = static_cast<int>(exitCodeOf(error));
      message = messageOf(error);
    }
  }
  Teuchos::broadcast(comm, 0, Teuchos::outArg(code));
  if (code != 0) throwOf(comm, 0, code, std::move(message));
}

void onEachRank(const Teuchos::Comm<int>& comm, const std::function<void()>& action) {
  if (comm.getSize() == 1) {
    action();
    return;
  }
  int code = 0;
  std::string message;
  try {
    action();
  } catch (const std::exception& error) {
    code = static_cast<int>(exitCodeOf(error));
    message = messageOf(error);
  } catch (...) {
    code = static_cast<int>(ExitCode::failure);
    message = "what was thrown is no exception of the standard library";
  }
  const int here = code != 0 ? comm.getRank() : comm.getSize();
  int first = here;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MIN, here, Teuchos::outArg(first));
  if (first == comm.getSize()) return;
  Teuchos::broadcast(comm, first, Teuchos::outArg(code));
  throwOf(comm, first, code, std::move(message));
}

}  // namespace harmos::base
