#include <exception>
#include <iostream>
#include <new>

#include <mpi.h>
#include <unistd.h>
#include <Tpetra_Core.hpp>

#include <harmos/base/BlasKernels.hpp>
#include <harmos/cli/CommandLine.hpp>

#include "Interrupt.hpp"

extern "C" {
// Present when the BLAS is OpenBLAS and when an OpenMP runtime is loaded.
__attribute__((weak)) void openblas_set_num_threads(int);
__attribute__((weak)) void omp_set_num_threads(int);
}

namespace {

// BLAS threads on the small blocks of a substructure cost more than they give; ranks are the way to use more cores.
void useOneThread() {
  if (openblas_set_num_threads) openblas_set_num_threads(1);
  if (omp_set_num_threads) omp_set_num_threads(1);
}

}  // namespace

int main(int argc, char** argv) {
  harmos::base::useFittingBlasKernels(argv);
  useOneThread();
  // Kokkos and MPI get no arguments: Kokkos would answer --help itself.
  char* program[] = {argv[0], nullptr};
  char** programOnly = program;
  int one = 1;
  Tpetra::ScopeGuard scope(&one, &programOnly);
  const auto communicator = Tpetra::getDefaultComm();
  // After MPI's start, which sets handlers of its own.
  catchInterrupts();
  try {
    return harmos::cli::runCommandLine(
        {argv + 1, argv + argc}, {communicator, std::cout, std::cerr, isatty(STDERR_FILENO) != 0, wasInterrupted});
  } catch (const std::exception& error) {
    const bool isFull = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
    std::cerr << "harmos, rank " << communicator->getRank() << ": "
              << (isFull ? "there is not enough memory; \"harmos check\" tells what a scene of this kind takes"
                         : error.what())
              << std::endl;
    // The other ranks wait for this one; only an abort lets them end.
    if (communicator->getSize() > 1) MPI_Abort(MPI_COMM_WORLD, 1);
    return 1;
  }
}
