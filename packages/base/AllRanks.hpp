#pragma once

#include <functional>
#include <iosfwd>

#include <Teuchos_Comm.hpp>

namespace harmos::base {

/// Runs a program on every rank of `comm`, so that all ranks end when one fails, be it alone. Returns the exit code:
/// what `program` returns, or exitCodeOf() the exception that left it on the lowest rank that failed, then on all
/// ranks. The message of that rank, and of no other, is printed to `err`.
///
/// An error may come up on one rank only, such as that of a law on the rank that owns its interface, while the others
/// wait for it in an exchange that it will never reach: a rank that has failed waits some seconds for the others,
/// prints its message, and ends all of them with MPI_Abort and the same exit code. Collective.
int runOnAllRanks(const Teuchos::Comm<int>& comm, const std::function<int()>& program, std::ostream& err);

/// Does on rank 0 what concerns files, which other machines may not see; an error of it is thrown as base::Error on all
/// ranks. Collective.
void onFirstRank(const Teuchos::Comm<int>& comm, const std::function<void()>& action);

/// Does on every rank what may fail on some, without collective calls in it: when it does, all ranks throw the same, so
/// that all go on alike: a base::Error with the message and the exit code of the lowest one that failed. On one rank it
/// is the action alone. Collective.
void onEachRank(const Teuchos::Comm<int>& comm, const std::function<void()>& action);

}  // namespace harmos::base
