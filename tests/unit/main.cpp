#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

// Every test executable starts MPI and Kokkos once; ranks other than 0 report only failures.
int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  Tpetra::ScopeGuard scope(&argc, &argv);
  if (Tpetra::getDefaultComm()->getRank() != 0) {
    auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
  }
  return RUN_ALL_TESTS();
}
