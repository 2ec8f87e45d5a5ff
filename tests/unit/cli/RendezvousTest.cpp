#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/cli/detail/Rendezvous.hpp>

namespace harmos::cli {
namespace {

TEST(Rendezvous, AllRanksMeet) {
  const Rendezvous rendezvous(*Tpetra::getDefaultComm());
  EXPECT_TRUE(rendezvous.allCome(60.0));
}

TEST(Rendezvous, NobodyWaitsForeverForOneWhoStaysAway) {
  const auto comm = Tpetra::getDefaultComm();
  if (comm->getSize() == 1) GTEST_SKIP() << "nobody else is there";
  const Rendezvous rendezvous(*comm);
  if (comm->getRank() > 0) {
    EXPECT_FALSE(rendezvous.allCome(0.1));
  }
  comm->barrier();
  // Nothing may be left of it when MPI ends.
  if (comm->getRank() == 0) {
    EXPECT_TRUE(rendezvous.allCome(60.0));
  }
}

}  // namespace
}  // namespace harmos::cli
