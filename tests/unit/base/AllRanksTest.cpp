#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include <Tpetra_Core.hpp>

#include <harmos/base/AllRanks.hpp>
#include <harmos/base/Error.hpp>

namespace harmos::base {
namespace {

TEST(OnFirstRank, WorksOnceAndTellsItsErrorToAll) {
  const auto comm = Tpetra::getDefaultComm();
  int times = 0;
  onFirstRank(*comm, [&] { ++times; });
  EXPECT_EQ(times, comm->getRank() == 0 ? 1 : 0);
  try {
    onFirstRank(*comm, [] { throw Error("no room", ExitCode::input); });
    ADD_FAILURE() << "rank " << comm->getRank() << " has heard of nothing";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::input);
    EXPECT_STREQ(error.what(), "no room");
  }
}

TEST(OnEachRank, ThrowsOnAllWhatFailsOnSome) {
  const auto comm = Tpetra::getDefaultComm();
  const int rank = comm->getRank(), last = comm->getSize() - 1;
  int times = 0;
  onEachRank(*comm, [&] { ++times; });
  EXPECT_EQ(times, 1);
  try {
    onEachRank(*comm, [&] {
      if (rank == last) throw Error("lost on rank " + std::to_string(rank), ExitCode::noEquilibrium);
    });
    ADD_FAILURE() << "rank " << rank << " has heard of nothing";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::noEquilibrium);
    EXPECT_EQ(error.what(), "lost on rank " + std::to_string(last));
  }
  if (comm->getSize() == 1) {
    EXPECT_THROW(onEachRank(*comm, [] { throw std::invalid_argument("alone"); }), std::invalid_argument);
  } else {
    EXPECT_THROW(onEachRank(*comm, [] { throw std::invalid_argument("on all"); }), Error);
  }
}

}  // namespace
}  // namespace harmos::base
