#include <gtest/gtest.h>

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

}  // namespace
}  // namespace harmos::base
