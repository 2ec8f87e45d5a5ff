#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/base/detail/Rendezvous.hpp>

namespace harmos::base {
namespace {

TEST(Rendezvous, EverybodyLearnsWhatEachRankSays) {
  const auto comm = Tpetra::getDefaultComm();
  const Rendezvous rendezvous(*comm);
  const auto words = rendezvous.meet(10 + comm->getRank(), 60.0);
  ASSERT_TRUE(words);
  ASSERT_EQ(static_cast<int>(words->size()), comm->getSize());
  for (int rank = 0; rank < comm->getSize(); ++rank) EXPECT_EQ((*words)[static_cast<std::size_t>(rank)], 10 + rank);
}

TEST(Rendezvous, NobodyWaitsForeverForOneWhoStaysAway) {
  const auto comm = Tpetra::getDefaultComm();
  if (comm->getSize() == 1) GTEST_SKIP() << "nobody else is there";
  const Rendezvous rendezvous(*comm);
  if (comm->getRank() > 0) {
    EXPECT_FALSE(rendezvous.meet(1, 0.1));
  }
  comm->barrier();
  // Nothing may be left of it when MPI ends.
  if (comm->getRank() == 0) {
    EXPECT_TRUE(rendezvous.meet(0, 60.0));
  }
}

}  // namespace
}  // namespace harmos::base
